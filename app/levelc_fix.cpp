#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/level/fixes.h"
#include "core/level/key_text.h"
#include "core/level/lint.h"
#include "editor/window/messages.h"

namespace spacetow {

namespace {

/// "Merge points: floor: Vertices 1 and 2 lie at the same point: …"
QString curedLine(const Level& before, const Problem& problem) {
    const Object* const object = problem.object == 0 ? nullptr : before.objects.find(problem.object);
    QString which;
    if (object != nullptr) {
        which =
            object->name.empty() ? QString::fromStdString(keyText(object->key)) : QString::fromStdString(object->name);
        which += QStringLiteral(": ");
    }
    const Label label{fixFor(problem)->label, 1};
    return sentence(label) + QStringLiteral(": ") + which + sentence(problem);
}

/// What is left: errors first among those that matter for the exit status.
std::vector<Problem> leftIn(const Level& level) {
    std::vector<Problem> problems = lint(level);
    const std::vector<bool> hidden = hiddenAmong(level, problems);
    std::size_t place = 0;
    std::erase_if(problems, [&](const Problem&) { return hidden[place++]; });
    return problems;
}

void printJson(const QString& file, const FixedLevel& fixed, const std::vector<Problem>& left) {
    JsonText json = JsonText::object();
    JsonText cured = JsonText::array();
    for (const Problem& problem : fixed.cured) {
        JsonText one = problemJson(file, problem);
        one.append("did", JsonText::text(std::string(fixFor(problem)->label.text())));
        cured.append(std::move(one));
    }
    JsonText rest = JsonText::array();
    for (const Problem& problem : left) {
        rest.append(problemJson(file, problem));
    }
    json.append("fixed", std::move(cured).broken());
    json.append("left", std::move(rest).broken());
    printText(QString::fromStdString(std::move(json).broken().laidOut()).trimmed());
}

void printWords(const Level& before, const FixedLevel& fixed, const std::vector<Problem>& left) {
    for (const Problem& problem : fixed.cured) {
        printLine(curedLine(before, problem));
    }
    printLine(QStringLiteral("%1 fixed, %2 left").arg(fixed.cured.size()).arg(left.size()) +
              (left.empty() ? QString() : QStringLiteral(" (see levelc check)")));
}

} // namespace

int fixCommand(const QStringList& arguments) {
    CommandLine line(QStringLiteral("fix"),
                     QStringLiteral("Cures what can be cured without asking, in place unless told where to write. Exit "
                                    "status: 0 when no error is left, 1 with errors left, 2 when a file cannot be read "
                                    "or written."));
    line.parser.addOption(
        {{QStringLiteral("o"), QStringLiteral("output")}, QStringLiteral("Level to write."), QStringLiteral("OUT")});
    line.parser.addOption({QStringLiteral("json"), QStringLiteral("Prints a JSON object instead of lines.")});
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level file."));
    if (!line.read(arguments, 1, 1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printLine(line.helpText());
        return exit_status::good;
    }
    const QString file = line.parser.positionalArguments().first();
    const std::optional<Level> level = loadedLevel(file);
    if (!level) {
        return exit_status::unusable;
    }
    const FixedLevel fixed = withSafeFixes(*level);
    const std::vector<Problem> left = leftIn(fixed.level);
    const QString out = line.parser.value(QStringLiteral("output"));
    // A file in which there is nothing to do stays as it is, down to its spelling.
    if (!out.isEmpty() || !fixed.cured.empty()) {
        const QString written = out.isEmpty() ? file : out;
        if (const auto error = writeLevel(toPath(written), fixed.level)) {
            complain(written, *error);
            return exit_status::unusable;
        }
    }
    if (line.parser.isSet(QStringLiteral("json"))) {
        printJson(file, fixed, left);
    } else {
        printWords(*level, fixed, left);
    }
    return hasErrors(left) ? exit_status::bad : exit_status::good;
}

} // namespace spacetow
