#include "app/levelc_support.h"

#include "core/level/json_text.h"
#include "core/level/key_text.h"
#include "editor/window/messages.h"

#include <QSaveFile>

#include <cstdio>

namespace spacetow {

CommandLine::CommandLine(const QString& command, const QString& description) : m_command(command) {
    parser.setApplicationDescription(description);
    parser.addOption({{QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Shows this help.")});
}

QString CommandLine::helpText() const {
    // The parser knows the program, but not the command.
    return parser.helpText().replace(QStringLiteral(" [options]"), QStringLiteral(" ") + m_command + " [options]");
}

bool CommandLine::read(const QStringList& arguments, int least, int most) {
    if (!parser.parse(arguments)) {
        complain(parser.errorText());
        return false;
    }
    const auto count = parser.positionalArguments().size();
    if (!helpWanted() && (count < least || (most >= 0 && count > most))) {
        complain(count < least ? QStringLiteral("a file name is missing; see levelc %1 --help").arg(m_command)
                               : QStringLiteral("there are too many file names; see levelc %1 --help").arg(m_command));
        return false;
    }
    return true;
}

void printLine(const QString& line) {
    std::fputs(qUtf8Printable(line + '\n'), stdout);
}

void complain(const QString& line) {
    std::fputs(qUtf8Printable("levelc: " + line + '\n'), stderr);
}

void complain(const Error& error) {
    complain(sentence(error));
}

QString problemLine(const QString& file, const Problem& problem) {
    const char* severity = problem.severity == Severity::Error ? "error" : "warning";
    return QStringLiteral("%1:%2: %3: ").arg(file).arg(problem.line).arg(severity) +
           QString::fromStdString(problem.code) + ": " + sentence(problem) + " (" +
           QString::fromStdString(problem.pointer) + ')';
}

std::optional<Level> loadedLevel(const QString& file) {
    Result<LevelFile> result = readLevel(file.toStdString());
    if (!result) {
        complain(result.error());
        return {};
    }
    LevelFile read = std::move(result).value();
    if (!read.level) {
        for (const Problem& problem : read.problems) {
            std::fputs(qUtf8Printable(problemLine(file, problem) + '\n'), stderr);
        }
    }
    return std::move(read.level);
}

QString hashText(std::uint64_t hash) {
    return QStringLiteral("%1").arg(static_cast<qulonglong>(hash), 16, 16, QLatin1Char('0'));
}

namespace {

JsonText pointJson(const Vec2& p) {
    JsonText json = JsonText::array();
    json.append(JsonText::number(p.x()));
    json.append(JsonText::number(p.y()));
    return json;
}

JsonText bodyJson(const BodyState& body, const std::string& name) {
    JsonText json = JsonText::object();
    json.append("key", JsonText::text(keyText(static_cast<Key>(body.user))));
    json.append("name", JsonText::text(name));
    json.append("position", pointJson(body.pose.position));
    json.append("angle", JsonText::number(body.angle));
    json.append("velocity", pointJson(body.velocity));
    json.append("angularVelocity", JsonText::number(body.angularVelocity));
    return json;
}

} // namespace

bool writeDump(const QString& file, const Level& level, const World& world, std::int64_t updates) {
    JsonText bodies = JsonText::array();
    for (const BodyId id : world.bodies()) {
        const BodyState state = world.body(id);
        const Object* object = level.objects.find(static_cast<Key>(state.user));
        bodies.append(bodyJson(state, object == nullptr ? std::string() : object->name));
    }
    JsonText json = JsonText::object();
    json.append("updates", JsonText::integer(updates));
    json.append("bodies", std::move(bodies).broken());
    const std::string text = std::move(json).broken().laidOut();
    QSaveFile out(file);
    const bool written = out.open(QIODevice::WriteOnly) &&
                         out.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) &&
                         out.commit();
    if (!written) {
        complain(Error{"cannot-write", {file.toStdString(), out.errorString().toStdString()}});
    }
    return written;
}

} // namespace spacetow
