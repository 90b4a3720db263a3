#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/level/lint.h"
#include "editor/window/messages.h"
#include "editor/window/messages_compare.h"

#include <algorithm>
#include <cstdio>
#include <set>

namespace spacetow {

namespace {

/// For git, which gives this name for the side on which there is no file.
constexpr auto noFile = "/dev/null";

std::optional<Level> comparedLevel(const QString& file) {
    return file == QLatin1String(noFile) ? Level{} : loadedLevel(file);
}

/// Git gives an empty file for what both sides have made of nothing.
std::optional<Level> baseLevel(const QString& file) {
    const Result<ReadText> read = readFile(toPath(file), 0);
    return read && read.value().text.empty() ? Level{} : comparedLevel(file);
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

/// What neither side has got wrong, but both together: two ships, or a rope tied to one ball at both ends.
std::vector<Problem> madeByMerging(const Level& result, const Level& ours, const Level& theirs) {
    std::set<std::pair<LevelCode, Key>> known;
    for (const Level* const side : {&ours, &theirs}) {
        for (const Problem& problem : lint(*side)) {
            known.emplace(problem.code, problem.object);
        }
    }
    std::vector<Problem> made = lint(result);
    std::erase_if(made, [&known](const Problem& problem) {
        return problem.severity != Severity::Error || known.contains({problem.code, problem.object});
    });
    return made;
}

/// Whether there is any.
bool printDifference(const Level& before, const Level& after) {
    const LevelDifference difference = differenceBetween(before, after);
    for (const DifferenceLine& each : differenceLines(before, after, difference)) {
        // A number may not be parted from its unit in a window; here people search for what they see.
        printLine(markOf(each) + QStringLiteral(" ") + QString(each.text).replace(QChar::Nbsp, QLatin1Char(' ')));
    }
    return !difference.empty();
}

/// Anything but success ends git's whole diff: what is no level is said, and git goes on.
int diffForGit(const QStringList& given) {
    if (given.size() != 1 && given.size() < 7) {
        complain(QStringLiteral("diff --git wants the seven arguments of an external diff of git"));
        return exit_status::unusable;
    }
    printLine(QStringLiteral("level ") + given[0]);
    if (given.size() == 1) {
        printLine(QStringLiteral("! not merged yet"));
        return exit_status::good;
    }
    std::fflush(stdout); // complaints come behind
    const std::optional<Level> before = comparedLevel(given[1]);
    const std::optional<Level> after = comparedLevel(given[4]);
    if (before && after) {
        printDifference(*before, *after);
    } else {
        printLine(QStringLiteral("! cannot be compared: %1 is no level")
                      .arg(before ? QStringLiteral("what it is now") : QStringLiteral("what it was")));
    }
    return exit_status::good;
}

} // namespace

int diffCommand(const QStringList& arguments) {
    CommandLine line(
        QStringLiteral("diff"),
        QStringLiteral("Tells in words what is different between two levels, by the keys of their objects. "
                       "Exit status: 0 when nothing is, 1 when something is, 2 when a file cannot be "
                       "read."));
    line.parser.addOption({QStringLiteral("git"), QStringLiteral("Takes the arguments that git gives to an external "
                                                                 "diff, and exits with 0.")});
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
    if (line.parser.isSet(QStringLiteral("git"))) {
        return diffForGit(given);
    }
    if (given.size() != 2) {
        complain(QStringLiteral("diff wants two files"));
        return exit_status::unusable;
    }
    const std::optional<Level> before = comparedLevel(given[0]);
    const std::optional<Level> after = comparedLevel(given[1]);
    if (!before || !after) {
        return exit_status::unusable;
    }
    return printDifference(*before, *after) ? exit_status::bad : exit_status::good;
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
    const std::optional<Level> base = baseLevel(given[0]);
    const std::optional<Level> ours = comparedLevel(given[1]);
    const std::optional<Level> theirs = comparedLevel(given[2]);
    if (!base || !ours || !theirs) {
        return exit_status::unusable;
    }
    const MergeSide preferred = line.parser.isSet(QStringLiteral("theirs")) ? MergeSide::Theirs : MergeSide::Ours;
    const MergedLevel result = merged(*base, *ours, *theirs, preferred);
    const QString out = line.parser.isSet(QStringLiteral("o")) ? line.parser.value(QStringLiteral("o")) : given[1];
    if (const std::optional<Error> error = writeLevel(toPath(out), result.level)) {
        complain(out, *error);
        return exit_status::unusable;
    }
    for (const MergeConflict& conflict : result.conflicts) {
        complain(QStringLiteral("conflict: ") + sentence(conflict, result.level));
    }
    const std::vector<Problem> made = madeByMerging(result.level, *ours, *theirs);
    for (const Problem& problem : made) {
        complain(QStringLiteral("conflict: both sides together make an error: ") + sentence(problem));
    }
    return result.conflicts.empty() && made.empty() ? exit_status::good : exit_status::bad;
}

} // namespace spacetow
