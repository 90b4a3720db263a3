// What can be seen of a session: readings, the snapshot and the hash.

#include "core/base/hash.h"
#include "core/game/session.h"
#include "core/physics/query/world_bytes.h"

#include <algorithm>

namespace spacetow {

bool wouldMoveUnsteered(const Snapshot& snapshot) {
    return snapshot.phase == Phase::AwaitingInput && std::ranges::any_of(snapshot.moving, [](const BodyPicture& body) {
               return body.look->role == BodyRole::Object;
           });
}

bool standAlike(const BodyPictures& a, const BodyPictures& b) {
    return std::ranges::equal(a, b, [](const BodyPicture& one, const BodyPicture& other) {
        return one.look == other.look && one.pose.position == other.pose.position &&
               one.pose.rotation == other.pose.rotation;
    });
}

Hud Session::hud() const {
    return {m_lives, fuel(), time(), payloadInRange(), m_flippedFor};
}

std::optional<BodyState> Session::ship() const {
    return m_ship ? std::optional(m_world.body(m_ship)) : std::nullopt;
}

std::optional<BodyState> Session::payload() const {
    return m_payload ? std::optional(m_world.body(m_payload)) : std::nullopt;
}

std::optional<BodyId> Session::bodyOf(Key object) const {
    const auto found = std::ranges::lower_bound(*m_bodies, object, {}, &std::pair<Key, BodyId>::first);
    const bool known = found != m_bodies->end() && found->first == object && m_world.contains(found->second);
    return known ? std::optional(found->second) : std::nullopt;
}

std::optional<ConnectorId> Session::connectorOf(Key object) const {
    const auto found = std::ranges::lower_bound(*m_connectors, object, {}, &std::pair<Key, ConnectorId>::first);
    const bool known = found != m_connectors->end() && found->first == object && m_world.contains(found->second);
    return known ? std::optional(found->second) : std::nullopt;
}

Key Session::keyOf(BodyId body) const {
    return m_world.contains(body) ? static_cast<Key>(m_world.body(body).user) : 0;
}

Key Session::keyOf(ConnectorId connector) const {
    const auto found = std::ranges::find(*m_connectors, connector, &std::pair<Key, ConnectorId>::second);
    return found != m_connectors->end() ? found->first : 0;
}

std::optional<ConnectorId> Session::rope() const {
    return m_rope && m_world.contains(m_rope) ? std::optional(m_rope) : std::nullopt;
}

void Session::appendPictures(BodyKind kind, BodyPictures& pictures) const {
    for (const Actor& actor : m_actors) {
        if (actor.look->kind == kind && m_world.contains(actor.body)) {
            const BodyState state = m_world.body(actor.body);
            pictures.push_back({actor.look, state.pose, state.velocity, state.angularVelocity});
        }
    }
}

/// The list stays the same one as long as what is in it does, so that who shows it sees at once that it does.
void Session::listStatics() {
    auto now = std::make_shared<BodyPictures>();
    appendPictures(BodyKind::Static, *now);
    if (!m_statics || !standAlike(*m_statics, *now)) {
        m_statics = std::move(now);
    }
}

std::shared_ptr<const Snapshot> Session::snapshot() const {
    auto picture = std::make_shared<Snapshot>();
    picture->update = m_update;
    picture->phase = m_phase;
    picture->hud = hud();
    picture->loss = m_loss;
    picture->camera = m_camera.position();
    picture->controls = m_controls;
    picture->sounds = m_sounds;
    picture->statics = m_statics;
    picture->moving.reserve(m_actors.size() - m_statics->size());
    for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Dynamic}) {
        appendPictures(kind, picture->moving);
    }
    for (const ConnectorId id : m_world.connectors()) {
        const ConnectorState state = m_world.connector(id);
        picture->connectors.push_back({state.anchorA, state.anchorB, state.length, state.tension});
    }
    return picture;
}

std::size_t Session::copyBytes() const {
    return sizeof(Session) + spacetow::copyBytes(m_world) + m_actors.size() * sizeof(Actor) +
           m_debris.size() * sizeof(FlyingDebris);
}

std::uint64_t Session::hash() const {
    StateHash hash;
    hash.add(m_world.hash());
    Random next = m_random; // what it is about to draw stands for its state
    hash.add(std::uint64_t{next.next()});
    hash.add(std::uint64_t{next.next()});
    hash.add(static_cast<std::uint64_t>(m_phase));
    hash.add(static_cast<std::uint64_t>(m_payloadState));
    hash.add(static_cast<std::uint64_t>(m_lives));
    hash.add(std::uint64_t{toBits(m_controls)});
    hash.add(std::uint64_t{m_rested});
    hash.add(static_cast<std::uint64_t>(m_thrusted));
    hash.add(static_cast<std::uint64_t>(m_flown));
    hash.add(m_flippedFor);
    for (const FlyingDebris& one : m_debris) {
        hash.add(one.piece.life);
    }
    return hash.value();
}

} // namespace spacetow
