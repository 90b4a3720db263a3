#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/level/json_text.h"
#include "core/level/lint.h"

#include <algorithm>

namespace spacetow {

namespace {

/// The problems of one file; none after complaining that it cannot be read.
std::optional<std::vector<Problem>> problemsOf(const QString& file, bool withHidden) {
    Result<LevelFile> result = readLevel(toPath(file), Checks::All, Sources::Any);
    if (!result) {
        complain(file, result.error());
        return {};
    }
    LevelFile read = std::move(result).value();
    if (read.level && !withHidden) {
        const std::vector<bool> hidden = hiddenAmong(*read.level, read.problems);
        std::size_t place = 0;
        std::erase_if(read.problems, [&](const Problem&) { return hidden[place++]; });
    }
    return read.problems;
}

} // namespace

int checkCommand(const QStringList& arguments) {
    CommandLine line(
        QStringLiteral("check"),
        QStringLiteral("Reports what is wrong with levels. Exit status: 0 without errors, 1 with, 2 when a "
                       "file cannot be read."));
    line.parser.addOption({QStringLiteral("json"), QStringLiteral("Prints a JSON array instead of lines.")});
    line.parser.addOption(
        {QStringLiteral("all"), QStringLiteral("Also prints the problems that the author of a level has hidden.")});
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level files."), QStringLiteral("FILE…"));
    if (!line.read(arguments, 1, -1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const bool json = line.parser.isSet(QStringLiteral("json"));
    const bool all = line.parser.isSet(QStringLiteral("all"));
    JsonText list = JsonText::array();
    int status = exit_status::good;
    for (const QString& file : line.parser.positionalArguments()) {
        const auto problems = problemsOf(file, all);
        if (!problems) {
            status = exit_status::unusable;
            continue;
        }
        status = std::max(status, hasErrors(*problems) ? exit_status::bad : exit_status::good);
        for (const Problem& problem : *problems) {
            if (json) {
                list.append(problemJson(file, problem));
            } else {
                printLine(problemLine(file, problem));
            }
        }
    }
    if (json) {
        printText(QString::fromStdString(std::move(list).broken().laidOut()).trimmed());
    }
    return status;
}

} // namespace spacetow
