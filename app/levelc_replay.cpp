#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/game/replay.h"
#include "core/game/session.h"
#include "core/level/json_text.h"

namespace spacetow {

namespace {

bool dumpEnd(const QString& file, const Level& level, const Replay& replay) {
    Session session(level, replay.seed);
    for (InputReader inputs(inputsOf(replay, level)); !inputs.isAtEnd();) {
        session.step(inputs.next());
    }
    return writeDump(file, level, session.world(), session.updates());
}

} // namespace

int replayCommand(const QStringList& arguments) {
    CommandLine line(QStringLiteral("replay"),
                     QStringLiteral("Flies a recorded flight. Exit status: 0 when it is won, 1 when not, 2 when a file "
                                    "cannot be read."));
    line.parser.addOption(
        {QStringLiteral("dump"), QStringLiteral("Writes where every body is at the end."), QStringLiteral("OUT.json")});
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level file."), QStringLiteral("FILE"));
    line.parser.addPositionalArgument(QStringLiteral("replay"), QStringLiteral("Recorded flight."),
                                      QStringLiteral("REPLAY"));
    if (!line.read(arguments, 2, 2)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const QStringList files = line.parser.positionalArguments();
    const std::optional<Level> level = loadedLevel(files[0]);
    if (!level) {
        return exit_status::unusable;
    }
    const Result<Replay> replay = readReplay(toPath(files[1]), Sources::Any);
    if (!replay) {
        complain(replay.error());
        return exit_status::unusable;
    }
    const Outcome outcome = replayed(*level, replay.value());
    if (outcome.levelChanged) {
        complain(QStringLiteral("the level has been changed since the flight was recorded"));
    }
    const char* result = outcome.won() ? "won" : outcome.lost() ? "lost" : "running";
    const QString dump = line.parser.value(QStringLiteral("dump"));
    printBeside(dump, QStringLiteral("outcome=%1 time=%2 fuel=%3 lives=%4 hash=%5")
                          .arg(QLatin1String(result), QString::fromStdString(spelledNumber(outcome.time)),
                               QString::fromStdString(spelledNumber(outcome.fuel)))
                          .arg(outcome.lives)
                          .arg(hashText(outcome.hash)));
    if (!dump.isEmpty() && !dumpEnd(dump, *level, replay.value())) {
        return exit_status::unusable;
    }
    return outcome.won() ? exit_status::good : exit_status::bad;
}

} // namespace spacetow
