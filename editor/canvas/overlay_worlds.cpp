#include "editor/canvas/overlay_worlds.h"

#include "core/game/crowd.h"
#include "core/game/session.h"
#include "core/level/level_index.h"

#include <algorithm>

namespace spacetow {

namespace {

bool needsUpdate(const OverlayFlags& overlays) {
    return overlays.contacts || overlays.islands || overlays.tension;
}

/// The ways of all bodies that move, as nobody steers.
std::vector<DebugTrail> firstTrails(Session session) {
    constexpr double seconds = 1;
    constexpr std::size_t most = 500; // bodies
    std::vector<BodyId> bodies;
    std::vector<DebugTrail> trails;
    for (const BodyId id : session.world().bodies()) {
        if (session.world().body(id).kind != BodyKind::Static && bodies.size() < most) {
            bodies.push_back(id);
        }
    }
    trails.resize(bodies.size());
    constexpr double affordable = 1e6; // bodies and iterations, in all updates: a second or so
    const double each = static_cast<double>(bodies.size() + 1) * session.world().parameters().iterations;
    const double updates = std::min(std::clamp(seconds / session.updateSeconds(), 1.0, 100.0), 1 + affordable / each);
    for (int update = 0; update <= updates; ++update) {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (session.world().contains(bodies[i])) {
                trails[i].points.push_back(session.world().body(bodies[i]).massCenter);
            }
        }
        session.step(Controls{});
    }
    std::erase_if(trails, [](const DebugTrail& trail) { return trail.points.front() == trail.points.back(); });
    return trails;
}

} // namespace

std::shared_ptr<const OverlayWorlds> overlayWorlds(const Level& level, const OverlayFlags& overlays) {
    const Session session(level);
    auto worlds = std::make_shared<OverlayWorlds>();
    worlds->made = overlays;
    worlds->start = session.world();
    if (isCrowded(worlds->start)) {
        return worlds; // nobody has the memory for what would happen
    }
    // The trees are made by an update; one that takes no time to speak of leaves everything where it is.
    worlds->start.update({.gravity = Vec2(0, 0), .seconds = 1e-6, .iterations = 1, .substeps = 1});
    if (needsUpdate(overlays)) {
        Session next = session;
        next.step(Controls{});
        worlds->touched = next.world();
    }
    if (overlays.trails) {
        worlds->trails = firstTrails(session);
    }
    return worlds;
}

int workOfWorlds(const Level& level, const OverlayFlags& overlays) {
    constexpr int eachBody = 10; // of an update, when one is made
    constexpr int enough = 5000;
    const LevelIndex& index = levelIndex(level);
    int work = needsUpdate(overlays) || overlays.trails ? eachBody * level.objects.size() : 0;
    index.visitObjects(index.bounds(),
                       [&](int place) { work += work < enough ? index.segmentsNear(place, index.bounds()) : 0; });
    return work;
}

bool covers(const OverlayFlags& made, const OverlayFlags& wanted) {
    return (needsUpdate(made) || !needsUpdate(wanted)) && (made.trails || !wanted.trails);
}

} // namespace spacetow
