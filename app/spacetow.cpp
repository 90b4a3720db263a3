// The program: reads its arguments, chooses language and style, opens one window.
#include "editor/canvas/icons.h"
#include "editor/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QLibraryInfo>
#include <QLocale>
#include <QStyleFactory>
#include <QTranslator>

namespace {

void installTranslations(QTranslator& own, QTranslator& toolkit) {
    const QLocale locale;
    const QString resources = QStringLiteral(":/translations");
    if (own.load(locale, QStringLiteral("spacetow"), QStringLiteral("_"), resources)) {
        // Only with our own, so that two languages never mix in one window.
        const QString folder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
        if (toolkit.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"), folder)) {
            QCoreApplication::installTranslator(&toolkit);
        }
    } else if (!own.load(QStringLiteral("spacetow_en"), resources)) {
        return;
    }
    QCoreApplication::installTranslator(&own);
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("spacetow-studio"));
    QApplication::setApplicationDisplayName(QStringLiteral("SpaceTow Studio"));
    QApplication::setOrganizationName(QStringLiteral("spacetow-studio"));
    QApplication::setApplicationVersion(QStringLiteral(SPACETOW_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("spacetow-studio"));
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setWindowIcon(spacetow::applicationIcon());

    QTranslator own;
    QTranslator toolkit;
    installTranslations(own, toolkit);

    QCommandLineParser parser;
    parser.setApplicationDescription(
        QCoreApplication::translate("main", "Draw levels and fly them: a level editor and physics sandbox."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("level"),
                                 QCoreApplication::translate("main", "Level file to open; without it, an example."),
                                 QStringLiteral("[LEVEL]"));
    parser.process(application);

    spacetow::MainWindow window;
    window.show();
    const QStringList files = parser.positionalArguments();
    if (files.isEmpty()) {
        window.openExample();
    } else {
        window.open(files.front());
    }
    return QApplication::exec();
}
