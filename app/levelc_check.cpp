#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/level/json_text.h"
#include "core/level/key_text.h"
#include "editor/window/messages.h"

#include <algorithm>

namespace spacetow {

namespace {

JsonText problemJson(const QString& file, const Problem& problem) {
    JsonText json = JsonText::object();
    json.append("file", JsonText::text(toPath(file).string()));
    json.append("line", JsonText::integer(problem.line));
    json.append("severity", JsonText::text(problem.severity == Severity::Error ? "error" : "warning"));
    json.append("code", JsonText::text(problem.code));
    json.append("message", JsonText::text(sentence(problem).toStdString()));
    json.append("pointer", JsonText::text(problem.pointer));
    json.append("object", problem.object == 0 ? JsonText::null() : JsonText::text(keyText(problem.object)));
    return json;
}

/// The problems of one file; none after complaining that it cannot be read.
std::optional<std::vector<Problem>> problemsOf(const QString& file) {
    const Result<LevelFile> result = readLevel(toPath(file), Checks::All, Sources::Any);
    if (!result) {
        complain(result.error());
        return {};
    }
    return result.value().problems;
}

} // namespace

int checkCommand(const QStringList& arguments) {
    CommandLine line(
        QStringLiteral("check"),
        QStringLiteral("Reports what is wrong with levels. Exit status: 0 without errors, 1 with, 2 when a "
                       "file cannot be read."));
    line.parser.addOption({QStringLiteral("json"), QStringLiteral("Prints a JSON array instead of lines.")});
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level files."), QStringLiteral("FILE…"));
    if (!line.read(arguments, 1, -1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const bool json = line.parser.isSet(QStringLiteral("json"));
    JsonText all = JsonText::array();
    int status = exit_status::good;
    for (const QString& file : line.parser.positionalArguments()) {
        const auto problems = problemsOf(file);
        if (!problems) {
            status = exit_status::unusable;
            continue;
        }
        status = std::max(status, hasErrors(*problems) ? exit_status::bad : exit_status::good);
        for (const Problem& problem : *problems) {
            if (json) {
                all.append(problemJson(file, problem));
            } else {
                printLine(problemLine(file, problem));
            }
        }
    }
    if (json) {
        printText(QString::fromStdString(std::move(all).broken().laidOut()).trimmed());
    }
    return status;
}

} // namespace spacetow
