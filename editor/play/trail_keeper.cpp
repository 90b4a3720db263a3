#include "editor/play/trail_keeper.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

constexpr std::size_t mostPoints = 12000; // of all trails together
constexpr std::size_t longestTrail = 150; // points; three seconds

std::size_t pointsFor(std::size_t bodies) {
    return std::clamp<std::size_t>(mostPoints / std::max<std::size_t>(bodies, 1), 4, longestTrail);
}

} // namespace

void TrailKeeper::forget() {
    m_bodies.clear();
    m_trails.clear();
    m_updates.clear();
}

void TrailKeeper::forgetAfter(std::int64_t update) {
    std::size_t later = 0;
    while (!m_updates.empty() && m_updates.back() > update) {
        m_updates.pop_back();
        ++later;
    }
    for (DebugTrail& trail : m_trails) {
        trail.points.resize(trail.points.size() - std::min(later, trail.points.size()));
    }
}

void TrailKeeper::note(const Session& session) {
    forgetAfter(session.updates());
    if (!m_updates.empty() && m_updates.back() == session.updates()) {
        return;
    }
    m_updates.push_back(session.updates());
    if (m_updates.size() > longestTrail) {
        m_updates.erase(m_updates.begin());
    }
    const World& world = session.world();
    std::vector<BodyId> bodies = world.bodies();
    std::erase_if(bodies, [&](BodyId id) { return world.body(id).kind == BodyKind::Static; });
    if (bodies != m_bodies) { // those that are still there keep theirs
        std::vector<DebugTrail> trails(bodies.size());
        constexpr std::size_t none = ~std::size_t{0};
        std::vector<std::size_t> places; // in the list of before, by the slot of the body
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            places.resize(std::max<std::size_t>(places.size(), m_bodies[i].index + std::size_t{1}), none);
            places[m_bodies[i].index] = i;
        }
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const std::size_t old = bodies[i].index < places.size() ? places[bodies[i].index] : none;
            if (old != none && m_bodies[old] == bodies[i]) { // the slot may have another body now
                trails[i] = std::move(m_trails[old]);
            }
        }
        m_bodies = std::move(bodies);
        m_trails = std::move(trails);
    }
    const std::size_t most = pointsFor(m_bodies.size());
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        std::vector<Vec2>& points = m_trails[i].points;
        points.push_back(world.body(m_bodies[i]).massCenter);
        if (points.size() > most) {
            points.erase(points.begin(), points.end() - static_cast<std::ptrdiff_t>(most));
        }
    }
}

} // namespace spacetow
