// Watching a run: what the window takes for a frame, and whether the run keeps up meanwhile.
#include "core/level/bounds.h"
#include "tests/bench/sandbox_stage.h"
#include "tests/bench/stopwatch.h"

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QTest>

#include <array>
#include <bit>

namespace spacetow::bench {

namespace {

constexpr int watchedBalls = 2000;
constexpr int timedFrames = 100;
constexpr qint64 watchedTime = 4000; // ms

/// What a way of watching has to keep to; 0: nothing.
struct WatchBars {
    double frame = 33.3; // ms, of the median
    double frames = 0;   // 1/s
    double updates = 0;  // 1/s
};

OverlayFlags allOverlays() {
    std::array<bool, sizeof(OverlayFlags)> all; // it has nothing else
    all.fill(true);
    return std::bit_cast<OverlayFlags>(all);
}

void timeFrames(SandboxStage& stage, const std::string& name, double bar, const Meter& meter) {
    std::vector<double> times;
    for (int i = 0; i < timedFrames; ++i) {
        stage.turn();
        times.push_back(meter.time([&] {
            stage.window().liveView().refresh();
            stage.canvas().repaint();
        }));
    }
    meter.report({"frame.median." + name, timedFrames, quantile(times, 0.5), "ms", bar});
    meter.report({"frame.longest." + name, timedFrames, quantile(times, 1), "ms", 50});
}

/// As the window does it by itself.
void watch(SandboxStage& stage, const std::string& name, const WatchBars& bars, const Meter& meter) {
    timeFrames(stage, name, bars.frame, meter);
    QElapsedTimer clock;
    clock.start();
    const std::int64_t updates = stage.run().updates();
    const int paintings = stage.paintings();
    const double longest = stage.longestTurn([&] { return clock.elapsed() >= watchedTime; });
    const double seconds = 1e-3 * static_cast<double>(clock.elapsed());
    const auto perSecond = [&](auto count) { return static_cast<double>(count) / seconds; };
    const int frames = stage.paintings() - paintings;
    meter.report({"window-turn.longest." + name, frames, longest, "ms", 50});
    meter.report({"frames." + name, frames, perSecond(frames), "1/s", bars.frames, true});
    // One update fewer or more is a matter of when one looks.
    const double least = bars.updates > 0 ? bars.updates - 1 / seconds : 0;
    meter.report({"updates." + name, frames, perSecond(stage.run().updates() - updates), "1/s", least, true});
}

/// Whatever can be switched on while something runs.
void showEverything(MainWindow& window) {
    window.setOverlays(allOverlays());
    for (const char* name : {"explain", "plots", "profile", "tagMatrix", "flights"}) {
        QDockWidget& dock = window.panels().dock(QString::fromLatin1(name));
        dock.setFloating(true); // else they would stand as tabs behind each other
        dock.show();
    }
    window.reach().setSeconds(ReachView::longest);
    window.reach().setOn(true);
    window.setPanelsHidden(false);
}

/// Back a second, and on from there: what was to come stays as a ghost.
void leaveGhost(SandboxStage& stage) {
    stage.run().seek(stage.run().updates() - 50);
    stage.longestTurn([&] { return stage.run().frame()->paused; });
    stage.run().setPaused(false);
}

/// More than the computer can do, and the window goes on.
void measureFallingBehind(SandboxStage& stage, const std::string& name, const Meter& meter) {
    watch(stage, name, {.frame = 0}, meter);
    const bool told = stage.window().statusLine().hint().contains(QStringLiteral("behind"));
    meter.report({"told-behind." + name, told ? 1 : 0, stage.run().behind(), "s", 0.1, true});
}

} // namespace

void measureWindow(const Meter& meter) {
    SandboxStage stage(meter);
    MainWindow& window = stage.window();
    stage.show(ballPit(watchedBalls));
    window.simulate();
    watch(stage, "overlays-off", {16.7, 30, 50}, meter);
    window.setOverlays(allOverlays());
    watch(stage, "overlays-on", {33.3, 30, 0}, meter);
    showEverything(window);
    window.document().select(Selection({500}));
    leaveGhost(stage);
    watch(stage, "all-on", {33.3, 0, 0}, meter);
    window.setOverlays(OverlayFlags());
    stage.run().setSpeed(Runner::fastest);
    watch(stage, "eight-times", {.frame = 0}, meter);
    constexpr int tooMany = 20'000;
    stage.show(ballPit(tooMany));
    window.simulate();
    measureFallingBehind(stage, "20,000-balls", meter);
    stage.stop();
}

} // namespace spacetow::bench
