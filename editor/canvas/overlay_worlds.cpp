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

constexpr std::size_t mostTrails = 500;

/// Bodies, iterations and substeps of an update.
double workOfUpdate(const Level& level, std::size_t bodies) {
    return static_cast<double>(bodies + 1) * (level.iterations + level.substeps);
}

/// How many updates the trails are long.
double trailUpdates(const Level& level, std::size_t bodies) {
    constexpr double seconds = 1;
    constexpr double affordable = 1e6; // bodies and iterations, in all updates: a second or so
    return std::min(std::clamp(seconds / level.updateSeconds, 1.0, 100.0),
                    1 + affordable / workOfUpdate(level, bodies));
}

std::size_t trailCount(const Level& level) {
    const auto moves = [](const Object& object) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        return body != nullptr ? body->kind != BodyKind::Static
                               : std::holds_alternative<ShipObject>(object.data) ||
                                     std::holds_alternative<PayloadObject>(object.data);
    };
    std::size_t count = 0;
    for (const Object& object : level.objects) {
        count += moves(object) ? 1 : 0;
    }
    return std::min(mostTrails, count);
}

/// The ways of all bodies that move, as nobody steers.
std::vector<DebugTrail> firstTrails(Session session) {
    std::vector<BodyId> bodies;
    std::vector<DebugTrail> trails;
    for (const BodyId id : session.world().bodies()) {
        if (session.world().body(id).kind != BodyKind::Static && bodies.size() < mostTrails) {
            bodies.push_back(id);
        }
    }
    trails.resize(bodies.size());
    const double updates = trailUpdates(session.level(), bodies.size());
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
    if (overlays.trails) {
        constexpr double each = 50; // bodies and iterations, that take as long as a segment
        const std::size_t count = trailCount(level);
        work += static_cast<int>(trailUpdates(level, count) * workOfUpdate(level, count) / each);
    }
    index.visitObjects(index.bounds(),
                       [&](int place) { work += work < enough ? index.segmentsNear(place, index.bounds()) : 0; });
    return work;
}

bool covers(const OverlayFlags& made, const OverlayFlags& wanted) {
    return (needsUpdate(made) || !needsUpdate(wanted)) && (made.trails || !wanted.trails);
}

} // namespace spacetow
