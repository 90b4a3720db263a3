#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "editor/window/messages_compare.h"

#include <algorithm>

namespace spacetow {

namespace {

/// For git, which gives this name for the side on which there is no file.
constexpr auto noFile = "/dev/null";

std::optional<Level> comparedLevel(const QString& file) {
    return file == QLatin1String(noFile) ? Level{} : loadedLevel(file);
}

QChar markOf(const DifferenceLine& line) {
    switch (line.change) {
    case ObjectChange::Added:
        return u'+';
    case ObjectChange::Removed:
        return u'-';
    case ObjectChange::Moved:
    case ObjectChange::Retagged:
    case ObjectChange::Reordered:
    case ObjectChange::Changed:
        break;
    }
    return u'~';
}

} // namespace

int diffCommand(const QStringList& arguments) {
    CommandLine line(
        QStringLiteral("diff"),
        QStringLiteral("Tells in words what is different between two levels, by the keys of their objects. "
                       "Exit status: 0 when nothing is, 1 when something is, 2 when a file cannot be "
                       "read."));
    line.parser.addOption({QStringLiteral("git"), QStringLiteral("Takes the seven arguments that git gives to an "
                                                                 "external diff, and exits with 0.")});
    line.parser.addPositionalArgument(QStringLiteral("before"), QStringLiteral("The one level."));
    line.parser.addPositionalArgument(QStringLiteral("after"), QStringLiteral("The other level."));
    if (!line.read(arguments, 0, 9)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const QStringList given = line.parser.positionalArguments();
    const bool git = line.parser.isSet(QStringLiteral("git"));
    if (git ? given.size() < 7 : given.size() != 2) {
        complain(git ? QStringLiteral("diff --git wants the seven arguments of an external diff of git")
                     : QStringLiteral("diff wants two files"));
        return exit_status::unusable;
    }
    const std::optional<Level> before = comparedLevel(git ? given[1] : given[0]);
    const std::optional<Level> after = comparedLevel(git ? given[4] : given[1]);
    if (!before || !after) {
        return exit_status::unusable;
    }
    if (git) {
        printLine(QStringLiteral("level ") + given[0]);
    }
    const LevelDifference difference = differenceBetween(*before, *after);
    for (const DifferenceLine& each : differenceLines(*before, *after, difference)) {
        // A number may not be parted from its unit in a window; here people search for what they see.
        printLine(markOf(each) + QStringLiteral(" ") + QString(each.text).replace(QChar::Nbsp, QLatin1Char(' ')));
    }
    return git || difference.empty() ? exit_status::good : exit_status::bad;
}

int mergeCommand(const QStringList& arguments) {
    CommandLine line(QStringLiteral("merge"),
                     QStringLiteral("Puts together what two sides made of the same level. Conflicts are named; where "
                                    "there is one, ours is taken. Exit status: 0 without conflicts, 1 with, 2 when a "
                                    "file cannot be read or written."));
    line.parser.addOption(
        {QStringLiteral("o"), QStringLiteral("Where the merge goes; without it, to ours."), QStringLiteral("file")});
    line.parser.addOption({QStringLiteral("theirs"), QStringLiteral("Takes theirs where there is a conflict.")});
    line.parser.addPositionalArgument(QStringLiteral("base"), QStringLiteral("The level that both started from."));
    line.parser.addPositionalArgument(QStringLiteral("ours"), QStringLiteral("What our side made of it."));
    line.parser.addPositionalArgument(QStringLiteral("theirs"), QStringLiteral("What their side made of it."));
    if (!line.read(arguments, 3, 3)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const QStringList given = line.parser.positionalArguments();
    const std::optional<Level> base = comparedLevel(given[0]);
    const std::optional<Level> ours = comparedLevel(given[1]);
    const std::optional<Level> theirs = comparedLevel(given[2]);
    if (!base || !ours || !theirs) {
        return exit_status::unusable;
    }
    const MergeSide preferred = line.parser.isSet(QStringLiteral("theirs")) ? MergeSide::Theirs : MergeSide::Ours;
    const MergedLevel result = merged(*base, *ours, *theirs, preferred);
    const QString out = line.parser.isSet(QStringLiteral("o")) ? line.parser.value(QStringLiteral("o")) : given[1];
    if (const std::optional<Error> error = writeLevel(toPath(out), result.level)) {
        complain(*error);
        return exit_status::unusable;
    }
    for (const MergeConflict& conflict : result.conflicts) {
        complain(QStringLiteral("conflict: ") + sentence(conflict, result.level));
    }
    return result.conflicts.empty() ? exit_status::good : exit_status::bad;
}

} // namespace spacetow
