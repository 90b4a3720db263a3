#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/game/session.h"
#include "core/level/build.h"
#include "core/level/json_text.h"
#include "core/level/key_text.h"
#include "editor/window/messages.h"

namespace spacetow {

namespace {

/// Says what is no part of the simulation. False when something is left out because it is faulty.
bool allTakenIn(const Level& level, bool withGame) {
    const std::vector<Problem> faults = problemsLeftOut(level);
    for (const Problem& problem : faults) {
        complain(QStringLiteral("the object ") + QString::fromStdString(keyText(problem.object)) +
                 " is left out: " + sentence(problem));
    }
    const bool isGame = firstOf<ShipObject>(level) != nullptr || firstOf<PayloadObject>(level) != nullptr ||
                        firstOf<FinishObject>(level) != nullptr;
    if (isGame && !withGame) {
        complain(QStringLiteral("ship, payload and finish are left out, and the hash does not tell them apart; --game "
                                "takes them in"));
    }
    return faults.empty();
}

struct Simulated {
    World world;
    std::uint64_t hash = 0;
};

Simulated simulated(const Level& level, int updates, bool withGame) {
    if (!withGame) {
        World world = builtWorld(level).world;
        for (int i = 0; i < updates; ++i) {
            world.update();
        }
        return {world, world.hash()};
    }
    Session session(level, 1);
    for (int i = 0; i < updates; ++i) {
        session.step(Controls{});
    }
    return {session.world(), session.hash()};
}

} // namespace

int simulateCommand(const QStringList& arguments) {
    constexpr int mostUpdates = 10'000'000;
    CommandLine line(
        QStringLiteral("simulate"),
        QStringLiteral("Runs the physics of a level. Exit status: 0, 1 when faulty objects were left out, 2 when "
                       "it cannot be run."));
    line.parser.addOption(
        {QStringLiteral("game"), QStringLiteral("Also takes in ship, payload and finish; no key is held.")});
    line.parser.addOption({QStringLiteral("updates"), QStringLiteral("Number of updates."), QStringLiteral("N")});
    line.parser.addOption(
        {QStringLiteral("dump"), QStringLiteral("Writes where every body is at the end."), QStringLiteral("OUT.json")});
    line.parser.addOption({QStringLiteral("hash"), QStringLiteral("Prints the hash of the state at the end.")});
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level file."), QStringLiteral("FILE"));
    if (!line.read(arguments, 1, 1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    bool isNumber = false;
    const int updates = line.parser.value(QStringLiteral("updates")).toInt(&isNumber);
    if (!isNumber || updates < 0 || updates > mostUpdates) {
        complain(QStringLiteral("--updates needs a number from 0 to %1").arg(mostUpdates));
        return exit_status::unusable;
    }
    const std::optional<Level> level = loadedLevel(line.parser.positionalArguments().front());
    if (!level) {
        return exit_status::unusable;
    }
    const bool withGame = line.parser.isSet(QStringLiteral("game"));
    const bool whole = allTakenIn(*level, withGame);
    const Simulated end = simulated(*level, updates, withGame);
    QString summary = QStringLiteral("updates=%1 time=%2 bodies=%3")
                          .arg(updates)
                          .arg(QString::fromStdString(spelledNumber(updates * end.world.parameters().seconds)))
                          .arg(end.world.bodyCount());
    if (line.parser.isSet(QStringLiteral("hash"))) {
        summary += " hash=" + hashText(end.hash);
    }
    const QString dump = line.parser.value(QStringLiteral("dump"));
    printBeside(dump, summary);
    if (!dump.isEmpty() && !writeDump(dump, *level, end.world, updates)) {
        return exit_status::unusable;
    }
    return whole ? exit_status::good : exit_status::bad;
}

} // namespace spacetow
