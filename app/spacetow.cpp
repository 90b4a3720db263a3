// The program: reads its arguments, chooses language and style, opens the windows.
#include "editor/canvas/icons.h"
#include "editor/window/application.h"
#include "editor/window/language.h"
#include "editor/window/main_window.h"
#include "editor/window/preferences.h"
#include "editor/window/quit_signals.h"

#include <QApplication>
#include <QCommandLineParser>

#include <algorithm>
#include <array>
#include <string_view>

namespace {

void describe(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        QCoreApplication::translate("main", "Draw levels and fly them: a level editor and physics sandbox."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("level"),
        QCoreApplication::translate("main", "Level files to open; without any, what was open last."),
        QStringLiteral("[LEVEL…]"));
}

/// Whoever ends the session gets no questions; the next start offers what was not saved.
void keepWorkAtEnd(const QApplication& application, const spacetow::QuitSignals& ending) {
    QObject::connect(&ending, &spacetow::QuitSignals::received, &application, [] {
        spacetow::MainWindow::keepForNextTime();
        QCoreApplication::exit(); // quit() would ask the windows
    });
    QObject::connect(
        &application, &QGuiApplication::commitDataRequest, &application,
        [] { spacetow::MainWindow::keepForNextTime(); }, Qt::DirectConnection);
}

bool asksForWordsOnly(int argc, char** argv) {
    constexpr std::array<std::string_view, 5> options{"-h", "--help", "--help-all", "-v", "--version"};
    return std::any_of(argv + 1, argv + argc, [&options](std::string_view argument) {
        return std::find(options.begin(), options.end(), argument) != options.end();
    });
}

/// For these no window is needed, and there may be no display.
int printWords(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    spacetow::speak(spacetow::Preferences().language());
    QCommandLineParser parser;
    describe(parser);
    parser.process(application);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName(QStringLiteral("spacetow-studio"));
    QCoreApplication::setOrganizationName(QStringLiteral("spacetow-studio"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SPACETOW_VERSION));
    if (asksForWordsOnly(argc, argv)) {
        return printWords(argc, argv);
    }
    QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("SpaceTow Studio"));
    QApplication::setDesktopFileName(QStringLiteral("spacetow-studio"));
    QApplication::setWindowIcon(spacetow::applicationIcon());

    spacetow::speak(spacetow::Preferences().language());

    QCommandLineParser parser;
    describe(parser);
    parser.process(application);

    const spacetow::QuitSignals ending;
    keepWorkAtEnd(application, ending);

    spacetow::Application windows;
    windows.start(parser.positionalArguments());
    windows.windows().front()->offerRecovery();
    return QApplication::exec();
}
