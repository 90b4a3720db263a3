#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/base/whole_file.h"
#include "editor/exchange/import.h"
#include "editor/window/messages.h"

#include <QFileInfo>

namespace spacetow {

namespace {

QString optionName(const char* name) {
    return QString::fromLatin1(name);
}

/// What the options say; nothing after complaining.
std::optional<ImportOptions> importOptions(const QCommandLineParser& parser) {
    ImportOptions options;
    bool good = true;
    if (parser.isSet(optionName("scale"))) {
        options.scale = parser.value(optionName("scale")).toDouble(&good);
        good = good && *options.scale > 0 && *options.scale <= 1e6;
    }
    if (!good) {
        complain(QStringLiteral("--scale needs the metres that a unit of the file is, such as 0.01"));
        return {};
    }
    options.tolerance = parser.value(optionName("tolerance")).toDouble(&good);
    if (!good || !(options.tolerance >= leastTolerance && options.tolerance <= 1e3)) {
        complain(QStringLiteral("--tolerance needs metres, at least %1").arg(leastTolerance));
        return {};
    }
    const QString walls = parser.value(optionName("walls"));
    if (walls != QLatin1String("one-way") && walls != QLatin1String("two-way")) {
        complain(QStringLiteral("--walls is one-way or two-way"));
        return {};
    }
    options.walls = walls == QLatin1String("one-way") ? ImportedWalls::OneWay : ImportedWalls::TwoWay;
    options.fillsAsWalls = parser.isSet(optionName("outlines"));
    return options;
}

Result<Import> importedFile(const QString& path, const ImportOptions& options, std::vector<Error>& leftOut) {
    const Result<ReadText> bytes = readFile(toPath(path), maxLevelBytes, Sources::Any);
    if (!bytes) {
        return bytes.error();
    }
    const Result<Drawing> drawing = readDrawing(bytes.value().text);
    return drawing ? importOf(drawing.value(), options, {}, &leftOut) : drawing.error();
}

void tellNotes(const QString& file, const std::vector<Error>& notes) {
    for (const Error& note : notes) {
        complain(file, note);
    }
}

void addOptions(QCommandLineParser& parser) {
    parser.addOption({{QStringLiteral("o"), QStringLiteral("output")},
                      QStringLiteral("Level to write."),
                      QStringLiteral("OUT.json")});
    parser.addOption({QStringLiteral("scale"),
                      QStringLiteral("Metres that a unit of the file is; 0.01 a pixel for SVG, a tile a metre for "
                                     "Tiled, 1 for R.U.B.E. unless told."),
                      QStringLiteral("M")});
    parser.addOption({QStringLiteral("tolerance"),
                      QStringLiteral("Metres by which segments may stray from a curve; 0.01 unless told."),
                      QStringLiteral("M"), QStringLiteral("0.01")});
    parser.addOption({QStringLiteral("walls"), QStringLiteral("What lines become: two-way (unless told) or one-way."),
                      QStringLiteral("KIND"), QStringLiteral("two-way")});
    parser.addOption({QStringLiteral("outlines"), QStringLiteral("Walls instead of polygons for what is filled.")});
    parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("SVG, .tmx, .tmj or R.U.B.E. JSON."),
                                 QStringLiteral("FILE"));
}

} // namespace

int importCommand(const QStringList& arguments) {
    CommandLine line(QStringLiteral("import"),
                     QStringLiteral("Makes a level of a file of another program. What is not taken over is told on "
                                    "standard error."));
    addOptions(line.parser);
    if (!line.read(arguments, 1, 1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const QString output = line.parser.value(QStringLiteral("output"));
    if (output.isEmpty()) {
        complain(QStringLiteral("the level to write is missing: -o OUT.json"));
        return exit_status::unusable;
    }
    const std::optional<ImportOptions> options = importOptions(line.parser);
    if (!options) {
        return exit_status::unusable;
    }
    const QString file = line.parser.positionalArguments().front();
    std::vector<Error> leftOut;
    Result<Import> import = importedFile(file, *options, leftOut);
    if (!import) {
        tellNotes(file, leftOut);
        complain(file, import.error());
        return exit_status::unusable;
    }
    tellNotes(file, import.value().notes);
    Level level;
    level.name = QFileInfo(file).completeBaseName().toStdString();
    constexpr std::uint64_t seed = 1; // the same file makes the same level
    Imported result = imported(std::move(level), std::move(import).value().foreign, {.seed = seed});
    const Result<std::string> text = savableText(result.level);
    if (!text) {
        complain(output, text.error());
        return exit_status::unusable;
    }
    return writeOut(output, text.value()) ? exit_status::good : exit_status::unusable;
}

} // namespace spacetow
