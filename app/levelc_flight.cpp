#include "app/levelc_flight.h"

#include "core/game/session.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/scene_painter.h"

namespace spacetow {

namespace {

using Ways = std::vector<std::vector<Vec2>>;

void goOn(Ways& ways, const std::optional<BodyState>& body) {
    constexpr double jump = 0.5; // m in one update; nothing flies that fast
    if (!body) {
        return;
    }
    const Vec2 here = body->pose.position;
    if (ways.empty() || (ways.back().back() - here).norm() > jump) {
        ways.emplace_back();
    }
    ways.back().push_back(here);
}

void paintWays(const Stage& stage, const Ways& ways, QColor color) {
    color.setAlpha(190);
    stage.painter.setPen(stroke(color, 2, Qt::DotLine));
    stage.painter.setBrush(Qt::NoBrush);
    for (const std::vector<Vec2>& way : ways) {
        stage.painter.drawPolyline(stage.at(way));
    }
}

} // namespace

Flight flown(const Level& level, const Replay& replay) {
    Session session(level, replay.seed);
    Flight flight;
    for (InputReader inputs(inputsOf(replay, level)); !inputs.isAtEnd();) {
        session.step(inputs.next());
        goOn(flight.shipWays, session.ship());
        goOn(flight.payloadWays, session.payload());
    }
    flight.end = session.snapshot();
    flight.session = std::make_shared<const Session>(session);
    return flight;
}

void paintFlight(const Stage& stage, const Flight& flight, const OverlayFlags& overlays) {
    paintSnapshot(stage, *flight.end);
    std::vector<DebugTrail> trails;
    for (const Ways* ways : {&flight.shipWays, &flight.payloadWays}) {
        for (const std::vector<Vec2>& way : *ways) {
            trails.push_back({way});
        }
    }
    paintWorldOverlays(stage, flight.session->world(),
                       {.flags = overlays, .level = &flight.session->level(), .trails = trails});
    paintWays(stage, flight.payloadWays, stage.theme.payloadLight);
    paintWays(stage, flight.shipWays, stage.theme.shipGlass);
}

} // namespace spacetow
