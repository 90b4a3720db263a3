#include "app/levelc_support.h"

#include "core/level/fixes.h"
#include "core/level/key_text.h"
#include "editor/window/messages.h"

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

namespace {

// As Python does it: a byte that is not UTF-8 is the code of half a character, which no text has alone.
constexpr char16_t firstHalf = 0xdc00;

bool isByte(QChar c) {
    return c.unicode() >= firstHalf + 0x80 && c.unicode() < firstHalf + 0x100;
}

QString decoded(std::string_view bytes) {
    QString text;
    while (!bytes.empty()) {
        const auto length = static_cast<qsizetype>(utf8Length(bytes));
        if (length == 0) {
            text += QChar(static_cast<char16_t>(firstHalf + static_cast<unsigned char>(bytes.front())));
        } else {
            text += QString::fromUtf8(bytes.data(), length);
        }
        bytes.remove_prefix(static_cast<std::size_t>(length == 0 ? 1 : length));
    }
    return text;
}

/// Characters that a terminal obeys, or that turn the order of others.
bool isObeyed(QChar c) {
    const char16_t code = c.unicode();
    return c.category() == QChar::Other_Control || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069) || code == 0x200e || code == 0x200f;
}

QString codeText(QChar c) {
    switch (c.unicode()) {
    case u'\n':
        return QStringLiteral("\\n");
    case u'\r':
        return QStringLiteral("\\r");
    case u'\t':
        return QStringLiteral("\\t");
    default:
        const bool isShort = isByte(c) || c.unicode() < 0x80;
        const int code = isByte(c) ? c.unicode() - firstHalf : c.unicode();
        return (isShort ? QStringLiteral("\\x") : QStringLiteral("\\u")) +
               QStringLiteral("%1").arg(code, isShort ? 2 : 4, 16, QLatin1Char('0'));
    }
}

} // namespace

QStringList argumentsOf(int argc, char** argv) {
    QStringList arguments;
    for (int i = 0; i < argc; ++i) {
        arguments << decoded(argv[i]);
    }
    return arguments;
}

std::filesystem::path toPath(const QString& file) {
    std::string bytes;
    for (qsizetype i = 0; i < file.size(); ++i) {
        const qsizetype length = file[i].isHighSurrogate() && i + 1 < file.size() ? 2 : 1;
        if (length == 1 && isByte(file[i])) {
            bytes += static_cast<char>(file[i].unicode() - firstHalf);
        } else {
            bytes += QStringView(file).mid(i, length).toUtf8().toStdString();
        }
        i += length - 1;
    }
    return bytes;
}

QString harmless(const QString& text) {
    QString out;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool isPair = text[i].isHighSurrogate() && i + 1 < text.size();
        if (isPair) {
            out += text[i++];
            out += text[i];
        } else {
            out += isObeyed(text[i]) || isByte(text[i]) ? codeText(text[i]) : QString(text[i]);
        }
    }
    return out;
}

void printLine(const QString& line) {
    printText(harmless(line));
}

void printText(const QString& text) {
    std::fputs(qUtf8Printable(text + '\n'), stdout);
}

void complain(const QString& line, const QString& more) {
    const QString rest = more.isEmpty() ? QString() : '\n' + more;
    std::fputs(qUtf8Printable("levelc: " + harmless(line) + rest + '\n'), stderr);
}

void complain(const QString& file, const Error& error) {
    complain(namesItsFile(error) ? sentence(error) : file + QStringLiteral(": ") + sentence(error));
}

QString problemLine(const QString& file, const Problem& problem) {
    const char* severity = severityName(problem.severity);
    // Put together, as a file name may hold what looks like a place for an argument.
    return file + ':' + QString::number(problem.line) + ": " + QLatin1String(severity) + ": " +
           QString::fromUtf8(problem.code.text()) + ": " + sentence(problem) + " (" +
           QString::fromStdString(problem.pointer) + ')';
}

JsonText problemJson(const QString& file, const Problem& problem) {
    JsonText json = JsonText::object();
    json.append("file", JsonText::text(toPath(file).string()));
    json.append("line", JsonText::integer(problem.line));
    json.append("severity", JsonText::text(severityName(problem.severity)));
    json.append("code", JsonText::text(std::string(problem.code.text())));
    json.append("message", JsonText::text(sentence(problem).toStdString()));
    json.append("pointer", JsonText::text(problem.pointer));
    json.append("object", problem.object == 0 ? JsonText::null() : JsonText::text(keyText(problem.object)));
    JsonText place = JsonText::array();
    for (const Vec2& point : problem.place) {
        JsonText pair = JsonText::array();
        pair.append(JsonText::number(point.x()));
        pair.append(JsonText::number(point.y()));
        place.append(std::move(pair));
    }
    json.append("place", std::move(place));
    const Fix* const fix = fixFor(problem);
    json.append("fix", JsonText::text(fix == nullptr ? "none" : fix->isSafe ? "safe" : "by hand"));
    return json;
}

std::optional<Level> loadedLevel(const QString& file) {
    Result<LevelFile> result = readLevel(toPath(file), Checks::All, Sources::Any);
    if (!result) {
        complain(file, result.error());
        return {};
    }
    LevelFile read = std::move(result).value();
    if (!read.level) {
        for (const Problem& problem : read.problems) {
            std::fputs(qUtf8Printable(harmless(problemLine(file, problem)) + '\n'), stderr);
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

void printBeside(const QString& dump, const QString& line) {
    if (!dump.isEmpty() && isStandardOutput(toPath(dump))) {
        std::fputs(qUtf8Printable(harmless(line) + '\n'), stderr);
    } else {
        printLine(line);
    }
}

bool writeOut(const QString& file, std::string_view text) {
    std::fflush(stdout); // what was printed comes first
    const std::optional<Error> error = writeFileOrStream(toPath(file), text);
    if (error) {
        complain(file, *error);
    }
    return !error;
}

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
    return writeOut(file, std::move(json).broken().laidOut());
}

} // namespace spacetow
