#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/level/build.h"
#include "core/level/json_text.h"

namespace spacetow {

int simulateCommand(const QStringList& arguments) {
    constexpr int mostUpdates = 10'000'000;
    CommandLine line(QStringLiteral("simulate"),
                     QStringLiteral("Runs the physics of a level alone, without ship and payload."));
    line.parser.addOption({QStringLiteral("updates"), QStringLiteral("Number of updates."), QStringLiteral("N")});
    line.parser.addOption(
        {QStringLiteral("dump"), QStringLiteral("Writes where every body is at the end."), QStringLiteral("OUT.json")});
    line.parser.addOption({QStringLiteral("hash"), QStringLiteral("Prints the hash of the state at the end.")});
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level file."), QStringLiteral("FILE"));
    if (!line.read(arguments, 1, 1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printLine(line.helpText());
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
    World world = builtWorld(*level).world;
    for (int i = 0; i < updates; ++i) {
        world.update();
    }
    const double seconds = updates * world.parameters().seconds;
    QString summary = QStringLiteral("updates=%1 time=%2 bodies=%3")
                          .arg(updates)
                          .arg(QString::fromStdString(spelledNumber(seconds)))
                          .arg(world.bodyCount());
    if (line.parser.isSet(QStringLiteral("hash"))) {
        summary += " hash=" + hashText(world.hash());
    }
    printLine(summary);
    const QString dump = line.parser.value(QStringLiteral("dump"));
    return dump.isEmpty() || writeDump(dump, *level, world, updates) ? exit_status::good : exit_status::unusable;
}

} // namespace spacetow
