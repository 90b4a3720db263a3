// The bodies that a session adds to its world, and the table that finds those of objects.

#include "core/game/session.h"

#include <algorithm>

namespace spacetow {

void Session::scatter(const BodyState& source, int least) {
    for (DebrisPiece& piece : debrisOf(source, least, m_random)) {
        FlyingDebris one{std::move(piece), {}};
        addDebris(one);
    }
}

void Session::addDebris(FlyingDebris& debris) {
    debris.body = addActor(debris.piece.def, BodyRole::Debris, 0);
    if (debris.body) { // refused where its source was not finite
        m_debris.push_back(std::move(debris));
    }
}

void Session::ageDebris() {
    for (FlyingDebris& one : m_debris) {
        one.piece.life -= updateSeconds();
        if (one.piece.life <= 0) {
            removeActor(one.body);
        }
    }
    std::erase_if(m_debris, [](const FlyingDebris& one) { return !one.body; });
}

BodyId Session::addActor(const std::optional<StartBody>& start, BodyRole role) {
    return start ? addActor(start->def, role, start->key) : BodyId{};
}

BodyId Session::addActor(const BodyDef& def, BodyRole role, Key key) {
    BodyDef named = def;
    named.user = key;
    const Result<BodyId> added = m_world.addBody(named);
    if (!added) {
        return {};
    }
    m_actors.push_back({added.value(), std::make_shared<const BodyLook>(BodyLook{++m_lastLook, key, role, def.kind,
                                                                                 def.tangible, def.filter.tags.bits,
                                                                                 m_world.shapes(added.value())})});
    return added.value();
}

void Session::indexBodies() {
    auto table = std::make_shared<std::vector<std::pair<Key, BodyId>>>();
    table->reserve(m_actors.size());
    for (const Actor& actor : m_actors) {
        if (actor.look->key != 0) {
            table->emplace_back(actor.look->key, actor.body);
        }
    }
    std::ranges::sort(*table, {}, &std::pair<Key, BodyId>::first);
    m_bodies = std::move(table);
}

void Session::removeActor(BodyId& body) {
    m_world.removeBody(body);
    std::erase_if(m_actors, [&](const Actor& actor) { return actor.body == body; });
    body = {};
}

} // namespace spacetow
