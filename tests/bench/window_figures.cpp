#include "tests/bench/editor_figures.h"

#include "core/level/file.h"
#include "editor/window/application.h"
#include "editor/window/main_window.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include <fstream>

#include <unistd.h>

namespace spacetow::bench {

namespace {

double megabytesInUse() {
    std::ifstream status("/proc/self/statm");
    long total = 0;
    long resident = 0;
    status >> total >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Until all that is worked out beside the windows is there.
void settle(const Application& windows) {
    for (int round = 0; round < 3; ++round) {
        QCoreApplication::processEvents();
        for (MainWindow* window : windows.windows()) {
            window->canvas().finishPainting();
            window->problems().check();
        }
    }
}

} // namespace

void measureWindows(const Subject& subject, const std::function<void(const Figure&)>& report) {
    const QTemporaryDir folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.filePath(QStringLiteral("settings")));
    QStringList files;
    for (const char* name : {"one.json", "two.json"}) {
        files << folder.filePath(QString::fromLatin1(name));
        writeLevel(files.back().toStdString(), largeLevel(subject.level, subject.edges));
    }
    Application windows;
    windows.start(files);
    settle(windows);
    report({"two-windows", megabytesInUse(), "MB", 200});
    windows.newView(*windows.windows().front());
    settle(windows);
    report({"two-windows-and-a-view", megabytesInUse(), "MB", 0});
}

} // namespace spacetow::bench
