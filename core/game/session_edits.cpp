// How a running session takes over an edited level.

#include "core/game/object_edits.h"
#include "core/game/payload.h"
#include "core/game/session.h"
#include "core/game/start_bodies.h"
#include "core/level/build.h"

#include <algorithm>

namespace spacetow {
namespace {

/// Whether what can be changed of a body in the world is all that differs.
bool sameShape(const BodyDef& a, const BodyDef& b) {
    return a.kind == b.kind && a.shapes == b.shapes;
}

/// By as much as the level's own pose was changed. What still is where it started is put exactly where it would start.
void moveAlong(BodyDef& def, const BodyDef& before, const BodyState& now) {
    constexpr double unmoved = 1e-9; // m and rad
    const Rot start = Rot::fromAngle(before.angle);
    const bool rests = (now.pose.position - before.position).norm() < unmoved &&
                       std::abs(start.c - now.pose.rotation.c) + std::abs(start.s - now.pose.rotation.s) < unmoved;
    if (!rests) {
        def.position = now.pose.position + (def.position - before.position);
        def.angle = now.angle + (def.angle - before.angle);
    }
    def.velocity = now.velocity + (def.velocity - before.velocity);
    def.angularVelocity = now.angularVelocity + (def.angularVelocity - before.angularVelocity);
}

Vec2 startAnchor(const Level& level, Key key, const Vec2& local) {
    const auto* body = as<BodyObject>(level.objects.find(key));
    return body == nullptr ? local : Transform{body->position, Rot::fromAngle(body->angle)}.toWorld(local);
}

double startLength(const Level& level, const ConnectorObject& connector) {
    return (startAnchor(level, connector.b, connector.anchorB) - startAnchor(level, connector.a, connector.anchorA))
        .norm();
}

} // namespace

struct Session::Adoption {
    Session& session;
    const Level& before;
    const Level& after;
    std::vector<std::pair<Key, ConnectorId>> connected = *session.m_connectors;
    std::vector<Key> replaced{}; // whose bodies are others now

    void objects();
    void body(const ObjectEdit& edit);
    void connectors(const std::vector<ObjectEdit>& edits, const std::vector<Key>& bad);
    void letGo(Key connector);
    void connect(Key key, const ConnectorObject& connector);
    void ship();
    void payload();
    void finish();
    void rope();
    void figures();

    /// The body that the definition makes of the one that is there.
    BodyId changed(BodyId old, const BodyDef& was, BodyDef def, BodyRole role);
    void alter(BodyId body, const BodyDef& was, const BodyDef& def);
    void showAs(BodyId body, const BodyDef& def);
    void remove(BodyId body) { session.removeActor(body); }
};

void Session::adopt(const std::shared_ptr<const Level>& level) {
    if (level == m_level) {
        return;
    }
    const std::shared_ptr<const Level> before = std::exchange(m_level, level);
    if (*before == *level) {
        return;
    }
    if (m_update == 0) {
        begin();
        return;
    }
    Adoption adoption{*this, *before, *level};
    adoption.objects();
    adoption.finish();
    adoption.payload();
    adoption.ship();
    adoption.rope();
    adoption.figures();
    m_start = nullptr;
    indexBodies();
    listStatics();
}

void Session::Adoption::objects() {
    const std::vector<ObjectEdit> edits = editsBetween(before, after);
    const std::vector<Key> bad = unbuildable(after, edits);
    for (const ObjectEdit& edit : edits) {
        if (edit.after == nullptr || !std::ranges::binary_search(bad, edit.after->key)) {
            body(edit);
        }
    }
    session.indexBodies();
    connectors(edits, bad);
}

void Session::Adoption::body(const ObjectEdit& edit) {
    const auto* was = as<BodyObject>(edit.before);
    const auto* is = as<BodyObject>(edit.after);
    const Key key = edit.after != nullptr ? edit.after->key : edit.before->key;
    const std::optional<BodyId> there = was != nullptr ? session.bodyOf(key) : std::nullopt;
    if (is == nullptr) {
        if (there) {
            remove(*there);
        }
        return;
    }
    BodyDef def = bodyDef(*is, key);
    const BodyId now = there ? changed(*there, bodyDef(*was, key), std::move(def), BodyRole::Object)
                             : session.addActor(def, BodyRole::Object, key);
    if (!there || now != *there) {
        replaced.push_back(key);
    }
}

BodyId Session::Adoption::changed(BodyId old, const BodyDef& was, BodyDef def, BodyRole role) {
    const BodyState now = session.m_world.body(old);
    const bool moved = def.position != was.position || def.angle != was.angle;
    moveAlong(def, was, now);
    if (sameShape(was, def)) {
        if (!session.m_world.setMaterial(old, materialOf(def))) { // refused by the physics
            return old;
        }
        if (moved) {
            session.m_world.setPose(old, def.position, def.angle);
        }
        alter(old, was, def);
        return old;
    }
    const BodyId made = session.addActor(def, role, static_cast<Key>(now.user));
    if (!made) { // likewise
        return old;
    }
    remove(old);
    return made;
}

void Session::Adoption::alter(BodyId body, const BodyDef& was, const BodyDef& def) {
    World& world = session.m_world;
    const BodyState now = world.body(body);
    if (was.positionFrozen != def.positionFrozen) {
        world.setFrozen(body, def.positionFrozen);
    }
    if (def.velocity != now.velocity || def.angularVelocity != now.angularVelocity) {
        world.setVelocity(body, def.velocity, def.angularVelocity);
    }
    if (was.filter != def.filter) {
        world.setFilter(body, def.filter);
        showAs(body, def);
    }
    if (was.tangible != def.tangible) {
        world.setTangible(body, def.tangible);
        showAs(body, def);
    }
}

void Session::Adoption::showAs(BodyId body, const BodyDef& def) {
    const auto actor = std::ranges::find(session.m_actors, body, &Actor::body);
    BodyLook look = *actor->look;
    look.tangible = def.tangible;
    look.tags = def.filter.tags.bits;
    actor->look = std::make_shared<const BodyLook>(std::move(look));
}

void Session::Adoption::connectors(const std::vector<ObjectEdit>& edits, const std::vector<Key>& bad) {
    std::vector<Key> wanted;
    for (const ObjectEdit& edit : edits) {
        if (as<ConnectorObject>(edit.before) != nullptr && as<ConnectorObject>(edit.after) == nullptr) {
            letGo(edit.before->key);
        } else if (as<ConnectorObject>(edit.after) != nullptr && !std::ranges::binary_search(bad, edit.after->key)) {
            wanted.push_back(edit.after->key);
        }
    }
    std::ranges::sort(wanted);
    std::ranges::sort(replaced);
    const auto has = [](const std::vector<Key>& keys, Key key) { return std::ranges::binary_search(keys, key); };
    if (!wanted.empty() || !replaced.empty()) {
        for (const Object& object : after.objects) {
            const auto* connector = as<ConnectorObject>(&object);
            if (connector != nullptr &&
                (has(wanted, object.key) || has(replaced, connector->a) || has(replaced, connector->b))) {
                connect(object.key, *connector);
            }
        }
    }
    std::ranges::sort(connected, {}, &std::pair<Key, ConnectorId>::first);
    session.m_connectors = std::make_shared<const std::vector<std::pair<Key, ConnectorId>>>(std::move(connected));
}

void Session::Adoption::letGo(Key connector) {
    if (const std::optional<ConnectorId> there = session.connectorOf(connector)) {
        session.m_world.removeConnector(*there);
    }
    std::erase_if(connected, [connector](const auto& entry) { return entry.first == connector; });
}

void Session::Adoption::connect(Key key, const ConnectorObject& connector) {
    const auto* was = as<ConnectorObject>(before.objects.find(key));
    const std::optional<ConnectorId> there = session.connectorOf(key);
    std::optional<double> length = connector.length;
    if (!length) { // what was measured at the start stays, unless it is measured between other points now
        const bool same = there && was != nullptr && !was->length && was->a == connector.a && was->b == connector.b &&
                          was->anchorA == connector.anchorA && was->anchorB == connector.anchorB;
        length = same ? session.m_world.connector(*there).length : startLength(after, connector);
    }
    const std::optional<BodyId> a = session.bodyOf(connector.a);
    const std::optional<BodyId> b = session.bodyOf(connector.b);
    ConnectorDef def = connectorDef(connector, a.value_or(BodyId{}), b.value_or(BodyId{}));
    def.length = length;
    if (there && session.m_world.setConnector(*there, def)) {
        return;
    }
    letGo(key);
    if (const Result<ConnectorId> added = session.m_world.addConnector(def)) {
        connected.emplace_back(key, added.value());
    }
}

void Session::Adoption::finish() {
    const std::optional<StartBody> was = startOfFinish(before);
    const std::optional<StartBody> is = startOfFinish(after);
    const auto actor =
        std::ranges::find(session.m_actors, BodyRole::Finish, [](const Actor& a) { return a.look->role; });
    const BodyId there = actor != session.m_actors.end() ? actor->body : BodyId{};
    const bool same = was && is && was->key == is->key;
    if (same && there) {
        changed(there, was->def, is->def, BodyRole::Finish);
        return;
    }
    if (there) {
        remove(there);
    }
    session.addActor(is, BodyRole::Finish);
}

void Session::Adoption::payload() {
    const std::optional<StartBody> was = startOfPayload(before);
    std::optional<StartBody> is = startOfPayload(after);
    Session& s = session;
    if (was && is && was->key == is->key) {
        if (s.m_payload) {
            const bool waits = s.m_payloadState == PayloadState::Waiting || s.m_payloadState == PayloadState::Delivered;
            is->def.positionFrozen = is->def.rotationFrozen = waits;
            BodyDef old = was->def;
            old.positionFrozen = old.rotationFrozen = waits;
            s.m_payload = changed(s.m_payload, old, is->def, BodyRole::Payload);
        }
        return;
    }
    if (s.m_payload) {
        if (s.m_phase == Phase::Towing) {
            s.letGoOfRope();
        }
        s.removeActor(s.m_payload);
    }
    const bool due = s.m_phase != Phase::Crashed && s.m_phase != Phase::GameOver && s.m_phase != Phase::Won;
    s.m_payload = due ? s.addActor(is, BodyRole::Payload) : BodyId{};
    s.m_payloadState = s.m_payload ? PayloadState::Waiting : PayloadState::Absent;
}

void Session::Adoption::ship() {
    const std::optional<StartBody> was = startOfShip(before);
    std::optional<StartBody> is = startOfShip(after);
    Session& s = session;
    if (was && is && was->key == is->key) {
        if (s.m_ship) {
            const bool waits = s.m_phase == Phase::AwaitingInput || s.m_phase == Phase::Won;
            is->def.positionFrozen = is->def.rotationFrozen = waits;
            BodyDef old = was->def;
            old.positionFrozen = old.rotationFrozen = waits;
            s.m_ship = changed(s.m_ship, old, is->def, BodyRole::Ship);
        }
        return;
    }
    s.breakRope();
    if (s.m_ship) {
        s.removeActor(s.m_ship);
    }
    s.m_ship = s.addActor(is, BodyRole::Ship);
    s.m_phase = s.m_ship ? Phase::AwaitingInput : Phase::Sandbox;
    s.m_flown = s.m_thrusted = 0; // an attempt begins
    if (s.m_lives < 1) {
        s.m_lives = std::max(1, after.rules.lives);
    }
}

/// It may be fastened to other bodies now, or obey other rules, but is as long as before.
void Session::Adoption::rope() {
    World& world = session.m_world;
    if (!session.m_ship || !session.m_payload || !world.contains(session.m_rope)) {
        return;
    }
    ConnectorDef def = towRope(session.m_ship, session.m_payload, after.rules.rope);
    def.length = world.connector(session.m_rope).length;
    static_cast<void>(world.setConnector(session.m_rope, def)); // or it stays as it was
}

void Session::Adoption::figures() {
    Session& s = session;
    UpdateParameters parameters = updateParameters(after);
    if (s.m_flippedFor >= 0) {
        parameters.gravity = -parameters.gravity;
    }
    if (parameters != s.m_world.parameters()) {
        s.m_world.setParameters(parameters);
    }
    if (before.sleeping != after.sleeping) {
        s.m_world.setSleeping(after.sleeping);
    }
    const int more = std::max(1, after.rules.lives) - std::max(1, before.rules.lives);
    if (more != 0 && s.m_phase != Phase::GameOver) {
        s.m_lives = std::max(1, s.m_lives + more);
    }
}

} // namespace spacetow
