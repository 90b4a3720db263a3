// Watching a run: what the window takes for a frame, and whether the run keeps up meanwhile.
#include "core/level/bounds.h"
#include "editor/window/main_window.h"
#include "tests/bench/sandbox_figures.h"
#include "tests/bench/stopwatch.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>

#include <array>
#include <bit>

namespace spacetow::bench {

namespace {

constexpr int watchedBalls = 2000;
constexpr int watchedFrames = 200;

OverlayFlags allOverlays() {
    std::array<bool, sizeof(OverlayFlags)> all; // it has nothing else
    all.fill(true);
    return std::bit_cast<OverlayFlags>(all);
}

void watch(MainWindow& window, const std::string& name, double bar, const Meter& meter) {
    std::vector<double> times;
    QElapsedTimer clock;
    clock.start();
    const std::int64_t first = window.liveRun().updates();
    for (int i = 0; i < watchedFrames; ++i) {
        QCoreApplication::processEvents();
        times.push_back(meter.time([&] {
            window.liveView().refresh();
            window.canvas().repaint();
        }));
    }
    const auto updates = static_cast<double>(window.liveRun().updates() - first);
    meter.report({"frame.median." + name, watchedBalls, quantile(times, 0.5), "ms", bar});
    meter.report({"frame.longest." + name, watchedBalls, quantile(times, 1), "ms", 50});
    meter.report({"watched-updates." + name, watchedBalls, 1e3 * updates / static_cast<double>(clock.elapsed()), "1/s",
                  bar < 20 ? 50.0 : 0, true});
}

} // namespace

void measureWindow(const Meter& meter) {
    const QTemporaryDir folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.filePath(QStringLiteral("settings")));
    qputenv("XDG_STATE_HOME", folder.filePath(QStringLiteral("state")).toUtf8());
    MainWindow window;
    window.files().questions.whatAboutChanges = [](const QString&) { return Unsaved::Discard; };
    window.resize(1280, 800);
    window.show();
    window.document().reset(ballPit(watchedBalls));
    const std::vector<Key> trough{window.document().level().objects[0].key};
    window.canvas().setView(window.canvas().view().showing(boundsOf(window.document().level(), trough)));
    window.simulate();
    for (const bool on : {false, true}) {
        window.setOverlays(on ? allOverlays() : OverlayFlags());
        QCoreApplication::processEvents();
        watch(window, on ? "overlays-on" : "overlays-off", on ? 33.3 : 16.7, meter);
    }
    window.stopPlaying();
}

} // namespace spacetow::bench
