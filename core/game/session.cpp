#include "core/game/session.h"

#include "core/game/ship.h"
#include "core/level/build.h"
#include "core/level/edits.h"

#include <algorithm>

namespace spacetow {
namespace {

Controls pressed(const Controls& now, const Controls& before) {
    return {now.left && !before.left, now.right && !before.right, now.thrust && !before.thrust, now.tow && !before.tow};
}

} // namespace

Session::Session(const Level& level, std::uint64_t seed) : Session(std::make_shared<const Level>(level), seed) {}

Session::Session(std::shared_ptr<const Level> level, std::uint64_t seed) : m_level(std::move(level)), m_random(seed) {
    begin();
}

void Session::begin() {
    m_start = nullptr;
    m_lastLook = 0;
    beginLevel();
    const Aabb bounds = boundsOf(*m_level);
    const Vec2 middle = bounds.isEmpty() ? Vec2(0, 0) : bounds.center();
    m_camera.snapTo(m_ship ? m_shipSeen : middle);
}

void Session::buildStart() {
    BuiltWorld built = builtWorld(*m_level);
    m_world = std::move(built.world);
    m_startConnectors = std::make_shared<const std::vector<std::pair<Key, ConnectorId>>>(std::move(built.connectors));
    m_actors.clear();
    for (const BodyId body : m_world.bodies()) {
        const BodyState state = m_world.body(body);
        const auto key = static_cast<Key>(state.user);
        m_actors.push_back({body, std::make_shared<const BodyLook>(
                                      BodyLook{++m_lastLook, key, BodyRole::Object, state.kind, state.tangible,
                                               state.filter.tags.bits, m_world.shapes(body)})});
    }
    addActor(startOfFinish(*m_level), BodyRole::Finish);
    m_startActors = m_actors.size();
    m_start = std::make_shared<const World>(m_world);
}

void Session::beginLevel() {
    m_lives = std::max(1, m_level->rules.lives);
    m_debris.clear();
    beginAttempt();
}

void Session::beginAttempt() {
    std::vector<FlyingDebris> debris = std::move(m_debris);
    for (FlyingDebris& one : debris) {
        const BodyState state = m_world.body(one.body);
        one.piece.def.position = state.pose.position;
        one.piece.def.angle = state.angle;
        one.piece.def.velocity = state.velocity;
        one.piece.def.angularVelocity = state.angularVelocity;
    }
    if (!m_start) {
        buildStart();
    }
    m_world = *m_start;
    m_actors.resize(m_startActors);
    m_connectors = m_startConnectors;
    m_debris.clear();
    m_rope = {};
    m_flown = 0;
    m_thrusted = 0;
    m_flippedFor = -1;
    m_loss.reset();
    const std::optional<StartBody> payload = startOfPayload(*m_level);
    m_payload = addActor(payload, BodyRole::Payload);
    m_payloadState = m_payload ? PayloadState::Waiting : PayloadState::Absent;
    m_payloadSeen = payload ? payload->def.position : m_payloadSeen;
    const std::optional<StartBody> ship = startOfShip(*m_level);
    m_ship = addActor(ship, BodyRole::Ship);
    m_phase = m_ship ? Phase::AwaitingInput : Phase::Sandbox;
    m_shipSeen = ship ? ship->def.position : m_shipSeen;
    indexBodies();
    for (FlyingDebris& one : debris) {
        addDebris(one);
    }
    listStatics();
}

void Session::step(const StepInput& input) {
    stepWith(input, {});
}

void Session::stepTimed(const StepInput& input, StageTimes& times) {
    stepWith(input, {.times = &times});
}

void Session::stepPartly(const StepInput& input, int iterations) {
    stepWith(input, {.iterations = iterations});
}

void Session::updateWorld(const StepManner& manner) {
    if (m_world.recordsImpulses() != m_explains) {
        m_world.setRecordsImpulses(m_explains);
    }
    UpdateParameters parameters = m_world.parameters();
    if (manner.iterations && *manner.iterations < parameters.iterations) {
        EXPECTS(*manner.iterations > 0);
        parameters.seconds *= static_cast<double>(*manner.iterations) / parameters.iterations;
        parameters.iterations = *manner.iterations;
    }
    if (manner.times != nullptr) {
        m_world.update(parameters, *manner.times);
    } else {
        m_world.update(parameters);
    }
}

void Session::stepWith(const StepInput& input, const StepManner& manner) {
    const Controls& controls = input.controls;
    m_sounds = 0;
    if (input.level) {
        adopt(input.level);
    }
    ++m_update;
    m_rested = m_rested || controls == Controls{};
    obey(pressed(controls, m_controls));
    m_controls = controls;
    if (isPlaying()) {
        steer(m_world, m_ship, controls, m_level->rules);
        ++m_flown;
    }
    const std::optional<BodyId> held = input.grab ? bodyOf(input.grab->object) : std::nullopt;
    m_grabForce = held ? pull(m_world, *held, *input.grab) : std::nullopt;
    updateWorld(manner);
    m_touches.note(m_world, m_explains);
    judge();
    if (isPlaying() && controls.thrust) {
        ++m_thrusted;
        hear(Sound::Thruster);
    }
    if (m_flippedFor >= 0) {
        m_flippedFor += updateSeconds();
    }
    ageDebris();
    moveCamera();
    noteFlight();
}

void Session::obey(const Controls& fresh) {
    const bool direction = fresh.left || fresh.right || fresh.thrust;
    switch (m_phase) {
    case Phase::AwaitingInput:
        if (direction) {
            m_phase = Phase::Flying;
            m_world.setFrozen(m_ship, false);
            hear(Sound::Start);
        }
        break;
    case Phase::Flying:
        if (fresh.tow && payloadInRange()) {
            attachRope();
        }
        break;
    case Phase::Crashed:
    case Phase::GameOver:
        if (m_rested && (direction || fresh.tow)) {
            if (m_phase == Phase::GameOver) {
                beginLevel();
            } else {
                beginAttempt();
            }
            m_camera.snapTo(m_shipSeen);
            hear(Sound::Respawn);
        }
        break;
    case Phase::Towing:
        if (fresh.tow) {
            letGoOfRope();
        }
        break;
    case Phase::Sandbox:
    case Phase::Won:
        break;
    }
}

bool Session::payloadInRange() const {
    const bool free = m_payloadState == PayloadState::Waiting || m_payloadState == PayloadState::Dropped;
    if (m_phase != Phase::Flying || !free) {
        return false;
    }
    const Vec2 gap = m_world.body(m_ship).massCenter - m_world.body(m_payload).massCenter;
    return gap.norm() < m_level->rules.towRange;
}

void Session::attachRope() {
    const Result<ConnectorId> added = m_world.addConnector(towRope(m_ship, m_payload, m_level->rules.rope));
    if (!added) {
        return;
    }
    m_rope = added.value();
    if (m_payloadState == PayloadState::Waiting) {
        m_world.setFrozen(m_payload, false);
        m_world.setVelocity(m_payload, Vec2(0, 0), 0);
    }
    m_payloadState = PayloadState::Towed;
    m_phase = Phase::Towing;
    hear(Sound::TowAttached);
    if (m_level->rules.flipGravityOnTow && m_flippedFor < 0) { // once an attempt
        UpdateParameters parameters = m_world.parameters();
        parameters.gravity = -parameters.gravity;
        m_world.setParameters(parameters);
        m_flippedFor = 0;
        hear(Sound::GravityFlip);
    }
}

void Session::letGoOfRope() {
    breakRope();
    m_phase = Phase::Flying;
    hear(Sound::TowBroken);
}

void Session::loseAttempt() {
    if (m_rope) {
        hear(Sound::TowBroken);
    }
    breakRope();
    --m_lives;
    m_rested = false;
    m_phase = m_lives > 0 ? Phase::Crashed : Phase::GameOver;
}

void Session::win() {
    breakRope();
    m_payloadState = PayloadState::Delivered;
    m_phase = Phase::Won;
    for (const BodyId body : {m_ship, m_payload}) { // nobody steers any more, so nothing is to happen to them
        m_world.setVelocity(body, Vec2(0, 0), 0);
        m_world.setFrozen(body, true);
    }
    hear(Sound::Won);
}

void Session::breakRope() {
    if (m_rope && m_world.contains(m_rope)) {
        m_world.removeConnector(m_rope);
    }
    m_rope = {};
    if (m_payloadState == PayloadState::Towed) {
        m_payloadState = PayloadState::Dropped;
    }
}

void Session::destroyShip() {
    const BodyState state = m_world.body(m_ship);
    m_shipSeen = state.massCenter;
    scatter(state, debris::fromShip);
    removeActor(m_ship);
    hear(Sound::ShipLost);
}

void Session::destroyPayload() {
    const BodyState state = m_world.body(m_payload);
    m_payloadSeen = state.massCenter;
    scatter(state, debris::fromPayload);
    removeActor(m_payload);
    m_payloadState = PayloadState::Lost;
    hear(Sound::PayloadLost);
}

void Session::moveCamera() {
    if (m_phase == Phase::Sandbox) {
        return;
    }
    if (m_ship) {
        m_shipSeen = m_world.body(m_ship).massCenter;
    }
    if (m_payload) {
        m_payloadSeen = m_world.body(m_payload).massCenter;
    }
    const bool payloadMoved = m_payloadState != PayloadState::Absent && m_payloadState != PayloadState::Waiting;
    m_camera.follow(m_ship || !payloadMoved ? m_shipSeen : m_payloadSeen, updateSeconds());
}

/// Until it is won, or lost for the first time.
void Session::noteFlight() {
    const bool lost = m_phase == Phase::Crashed || m_phase == Phase::GameOver;
    const bool won = m_phase == Phase::Won;
    if (m_note.won || (m_note.lost && !won)) {
        return;
    }
    m_note.won = won;
    m_note.lost = m_note.lost || lost;
    m_note.update = m_update;
    if (m_phase != Phase::Sandbox) {
        m_note.place = lost && m_ship ? m_payloadSeen : m_shipSeen;
    }
}

FlightResult Session::flight() const {
    const FlightEnd end = m_phase == Phase::Won ? FlightEnd::Won : m_note.lost ? FlightEnd::Lost : FlightEnd::UnderWay;
    return {end, time(), fuel(), m_note.place, m_note.update, static_cast<double>(m_note.update) * updateSeconds()};
}

} // namespace spacetow
