// What holds up the window around a run: beginning and ending it, and the mouse while it runs or stands still.
#include "core/level/object_geometry.h"
#include "tests/bench/large_levels.h"
#include "tests/bench/sandbox_stage.h"
#include "tests/bench/stopwatch.h"

#include <QDockWidget>
#include <QElapsedTimer>
#include <QTest>

namespace spacetow::bench {

namespace {

constexpr double bearable = 50; // ms
constexpr int moves = 60;       // of the mouse
constexpr int balls = 2000;

void measureBeginning(SandboxStage& stage, const std::string& name, const Meter& meter) {
    MainWindow& window = stage.window();
    const int objects = window.document().level().objects.size();
    const bool hasShip = firstOf<ShipObject>(window.document().level()) != nullptr;
    for (const bool game : {false, true}) {
        if (game && !hasShip) {
            continue;
        }
        const std::string run = (game ? "play." : "simulate.") + name;
        QElapsedTimer clock;
        clock.start();
        const double longest = stage.longestTurn([&] { game ? window.play() : window.simulate(); },
                                                 [&] { return window.isPlaying() && stage.run().updates() > 0; });
        meter.report({"until-it-runs." + run, objects, static_cast<double>(clock.elapsed()), "ms"});
        meter.report({"blocked." + run, objects, longest, "ms", bearable});
        const auto ended = [&] { return !window.isPlaying() && stage.run().ending() == 0; };
        meter.report(
            {"blocked.stop-" + run, objects, stage.longestTurn([&] { window.stopPlaying(); }, ended), "ms", bearable});
        stage.stop();
    }
}

QPoint onScreen(SandboxStage& stage, const Vec2& world) {
    const Vec2 screen = stage.canvas().view().toScreen(world);
    return {qRound(screen.x()), qRound(screen.y())};
}

struct Drag {
    std::string name;
    Vec2 from{0, 0}; // m
    QPoint step;     // px a move
};

/// Each move with what follows from it.
void measureMoves(SandboxStage& stage, const Drag& drag, const Meter& meter) {
    std::vector<double> times;
    QPoint at = onScreen(stage, drag.from);
    for (int i = 0; i < moves; ++i) {
        at += i < moves / 2 ? drag.step : -drag.step;
        const double moved = meter.time([&] { QTest::mouseMove(&stage.canvas(), at); });
        times.push_back(std::max(moved, stage.turn()));
    }
    meter.report({"move.median." + drag.name, moves, quantile(times, 0.5), "ms"});
    meter.report({"move.longest." + drag.name, moves, quantile(times, 1), "ms", bearable});
}

/// A wall is dragged while one looks at a moment early in the run.
void measureEditInThePast(SandboxStage& stage, const Drag& drag, const Meter& meter) {
    LiveRun& run = stage.run();
    const auto wholeIsThere = [&] {
        const std::shared_ptr<const Frame> frame = run.frame();
        const bool isEdited = frame->session->sharedLevel() == stage.window().document().current().level;
        return isEdited && frame->timeline->goal == frame->timeline->last;
    };
    run.seek(20);
    stage.longestTurn([&] { return run.frame()->paused && run.updates() == 20; });
    const std::shared_ptr<const Level> before = stage.window().document().current().level;
    QTest::mouseMove(&stage.canvas(), onScreen(stage, drag.from));
    QTest::mousePress(&stage.canvas(), Qt::LeftButton, {}, onScreen(stage, drag.from));
    measureMoves(stage, drag, meter);
    const QPoint there = onScreen(stage, drag.from) + 7 * drag.step;
    QTest::mouseMove(&stage.canvas(), there);
    QElapsedTimer clock;
    clock.start();
    const auto release = [&] { QTest::mouseRelease(&stage.canvas(), Qt::LeftButton, {}, there); };
    const double longest = stage.longestTurn(release, wholeIsThere);
    const bool edited = stage.window().document().current().level != before;
    meter.report({"blocked.edit." + drag.name, edited ? 1 : 0, longest, "ms", bearable});
    meter.report({"simulated-again." + drag.name, static_cast<int>(run.timeline()->last),
                  static_cast<double>(clock.elapsed()), "ms"});
}

void runFor(SandboxStage& stage, std::int64_t updates) {
    stage.window().simulate();
    stage.run().setSpeed(Runner::fastest);
    stage.longestTurn([&] { return stage.run().isRunning() && stage.run().updates() >= updates; });
    stage.run().setPaused(true);
}

/// In the middle of the first edge of the first wall.
Vec2 onSomeWall(const Level& level) {
    for (int i = 0; i < level.objects.size(); ++i) {
        const auto* body = std::get_if<BodyObject>(&level.objects[i].data);
        if (body == nullptr || body->kind != BodyKind::Static) {
            continue;
        }
        for (const auto& shape : body->shapes) {
            if (const auto* chain = std::get_if<EdgeChain>(&shape)) {
                return poseOf(level.objects[i])->toWorld(0.5 * (chain->vertices[0] + chain->vertices[1]));
            }
        }
    }
    return {0, 0};
}

/// Everything that follows a run and an edit.
void watchEverything(MainWindow& window) {
    for (const char* name : {"explain", "plots", "profile", "flights"}) {
        QDockWidget& dock = window.panels().dock(QString::fromLatin1(name));
        dock.setFloating(true); // else they would stand as tabs behind each other
        dock.show();
    }
    window.reach().setOn(true);
    OverlayFlags overlays;
    overlays.trails = overlays.contacts = true;
    window.setOverlays(overlays);
}

} // namespace

void measureEdits(const Meter& meter) {
    SandboxStage stage(meter);
    stage.show(*firstLevel());
    measureBeginning(stage, "level-1", meter);
    for (const bool all : {false, true}) {
        if (all) {
            watchEverything(stage.window());
        }
        runFor(stage, 3000);
        measureEditInThePast(stage, {all ? "level-1-all-on" : "level-1", onSomeWall(*firstLevel()), {1, 1}}, meter);
        stage.stop();
    }
    stage.show(ballPit(balls));
    measureBeginning(stage, "balls", meter);
    runFor(stage, 400);
    stage.run().setSpeed(1);
    stage.run().setPaused(false);
    measureMoves(stage, {"hover-balls", {0, 1}, {3, -1}}, meter);
    const double side = -0.5 * 50 * 0.22;
    measureEditInThePast(stage, {"balls", {side, 0.95 * 12}, {1, 0}}, meter);
    for (const auto& [kind, edges, name] : std::initializer_list<std::tuple<LargeLevel, int, const char*>>{
             {LargeLevel::Chains, 10'000, "chains-10000"},
             {LargeLevel::Chains, 100'000, "chains-100000"},
             {LargeLevel::Bodies, 10'000, "bodies-10000"},
             {LargeLevel::Bodies, 100'000, "bodies-100000"}}) {
        stage.show(largeLevel(kind, edges));
        measureBeginning(stage, name, meter);
    }
}

} // namespace spacetow::bench
