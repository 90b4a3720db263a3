// levelc: checks, draws, simulates and replays levels from the command line.

#include "app/levelc_commands.h"
#include "app/levelc_support.h"

#include <QGuiApplication>
#include <QLocale>

#include <algorithm>
#include <memory>

namespace {

using namespace spacetow;

struct Command {
    const char* name;
    int (*run)(const QStringList&);
    const char* usage;
};

constexpr Command commands[] = {
    {"check", checkCommand, "check FILE… [--all] [--json]"},
    {"fix", fixCommand, "fix FILE [-o OUT] [--json]"},
    {"info", infoCommand, "info FILE"},
    {"import", importCommand,
     "import FILE -o OUT.json [--scale M] [--tolerance M] [--walls one-way|two-way] [--outlines]"},
    {"render", renderCommand, "render FILE -o OUT.png|OUT.svg [--size WxH] [--overlays LIST] [--replay REPLAY]"},
    {"simulate", simulateCommand, "simulate FILE --updates N [--game] [--dump OUT.json] [--hash]"},
    {"replay", replayCommand, "replay FILE REPLAY [--dump OUT.json]"},
    {"flights", flightsCommand, "flights FILE…"},
    {"diff", diffCommand, "diff BEFORE AFTER"},
    {"merge", mergeCommand, "merge BASE OURS THEIRS [-o OUT] [--theirs]"},
    {"schema", schemaCommand, "schema"},
    {"fields", fieldsCommand, "fields PART"},
};

QString usage() {
    QString text = QStringLiteral("usage:");
    for (const Command& command : commands) {
        text += QStringLiteral("\n  levelc ") + QString::fromUtf8(command.usage);
    }
    return text;
}

/// Only pictures need fonts and painting, and never a screen.
std::unique_ptr<QCoreApplication> application(int& argc, char** argv) {
    if (argc > 1 && qstrcmp(argv[1], "render") == 0) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        return std::make_unique<QGuiApplication>(argc, argv);
    }
    return std::make_unique<QCoreApplication>(argc, argv);
}

} // namespace

int main(int argc, char** argv) {
    const auto app = application(argc, argv);
    QLocale::setDefault(QLocale::c()); // programs read what is printed
    QCoreApplication::setApplicationName(QStringLiteral("levelc"));
    QStringList arguments = argumentsOf(argc, argv);
    if (arguments.size() < 2) {
        complain(QStringLiteral("a command is missing"), usage());
        return exit_status::unusable;
    }
    const QString name = arguments.takeAt(1);
    if (name == QLatin1String("--help") || name == QLatin1String("-h")) {
        printText(usage());
        return exit_status::good;
    }
    const auto found = std::ranges::find_if(commands, [&name](const Command& c) { return name == c.name; });
    if (found == std::end(commands)) {
        complain(QStringLiteral("there is no command “%1”").arg(name), usage());
        return exit_status::unusable;
    }
    return found->run(arguments);
}
