#include "core/physics/world/world.h"

#include "core/base/contract.h"
#include "core/geometry/bounds.h"
#include "core/physics/sleep/sleep.h"
#include "core/physics/state/world_data.h"
#include "core/physics/step/deferred_changes.h"
#include "core/physics/step/update.h"
#include "core/physics/world/make_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

bool isUsable(const UpdateParameters& p) {
    return isFinite(p.gravity) && std::isfinite(p.seconds) && p.seconds > 0 && p.iterations >= 1 && p.substeps >= 1;
}

} // namespace

World::World(const UpdateParameters& parameters) : m_data(std::make_unique<WorldData>()) {
    setParameters(parameters);
}
World::World(const World& other) : m_data(std::make_unique<WorldData>(*other.m_data)) {}
World::World(World&&) noexcept = default;
World& World::operator=(const World& other) {
    if (this != &other) {
        *m_data = *other.m_data;
    }
    return *this;
}
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

void World::update() {
    update(m_data->parameters);
}

void World::update(const UpdateParameters& parameters) {
    EXPECTS(isUsable(parameters));
    updateWorld(*m_data, parameters);
}

void World::update(const UpdateParameters& parameters, StageTimes& times) {
    m_data->scratch.times = &times;
    update(parameters);
    m_data->scratch.times = nullptr;
}

Result<BodyId> World::addBody(const BodyDef& def) {
    Result<MadeBody> made = makeBody(def);
    if (!made) {
        return made.error();
    }
    WorldData& data = *m_data;
    Slot slot = static_cast<Slot>(data.bodies.records.size());
    if (data.bodies.freeSlots.empty()) {
        data.bodies.records.emplace_back();
        data.bodies.motions.emplace_back();
        data.bodies.steps.emplace_back();
    } else {
        slot = data.bodies.freeSlots.back();
        data.bodies.freeSlots.pop_back();
    }
    const std::uint32_t generation = data.bodies.records[slot].generation;
    data.bodies.records[slot] = made.value().record;
    data.bodies.records[slot].generation = generation;
    data.bodies.records[slot].used = true;
    data.bodies.records[slot].serial = data.bodies.nextSerial++;
    data.bodies.motions[slot] = made.value().motion;
    data.bodies.steps[slot] = made.value().step;
    refreshInverseMass(data.bodies, slot);
    if (def.kind == BodyKind::Static) {
        data.noteStaticChange(slot);
    } else {
        data.bodies.addedNonStatic.push_back(slot);
    }
    data.bodies.changedBodies.push_back(slot);
    requestWake(data.bodies, data.sleep, slot);
    return data.bodies.idOf(slot);
}

void World::removeBody(BodyId body) {
    EXPECTS(contains(body));
    m_data->bodies.pending.push_back({PendingChange::Kind::Remove, body});
}

void World::setActive(BodyId body, bool active) {
    EXPECTS(contains(body));
    m_data->bodies.pending.push_back({PendingChange::Kind::Active, body, active});
}

void World::setTangible(BodyId body, bool tangible) {
    EXPECTS(contains(body));
    m_data->bodies.pending.push_back({PendingChange::Kind::Tangible, body, tangible});
}

void World::setFrozen(BodyId body, bool position, bool rotation) {
    EXPECTS(contains(body));
    m_data->bodies.pending.push_back({PendingChange::Kind::Frozen, body, position, rotation});
}

void World::setPose(BodyId body, const Vec2& position, double angle) {
    EXPECTS(contains(body) && isFinite(position) && std::isfinite(angle));
    BodyMotion& m = m_data->bodies.motions[body.index];
    BodyRecord& record = m_data->bodies.records[body.index];
    m.rotation = Rot::fromAngle(angle);
    m.center = position + m.rotation * record.localCenter;
    record.bounds = Aabb{};
    m_data->flags.pairsStale = true;
    if (record.kind == BodyKind::Static) {
        m_data->noteStaticChange(body.index);
    }
    requestWake(m_data->bodies, m_data->sleep, body.index);
}

void World::setVelocity(BodyId body, const Vec2& velocity, double angularVelocity) {
    EXPECTS(contains(body) && isFinite(velocity) && std::isfinite(angularVelocity));
    const BodyRecord& record = m_data->bodies.records[body.index];
    if (record.kind == BodyKind::Static) {
        return;
    }
    BodyMotion& m = m_data->bodies.motions[body.index];
    m.velocity = record.positionFrozen ? Vec2(0, 0) : velocity;
    m.angularVelocity = record.rotationFrozen ? 0 : angularVelocity;
    requestWake(m_data->bodies, m_data->sleep, body.index);
}

void World::setFilter(BodyId body, const Filter& filter) {
    EXPECTS(contains(body));
    m_data->bodies.records[body.index].filter = filter;
    m_data->flags.pairsStale = true;
    requestWake(m_data->bodies, m_data->sleep, body.index);
}

void World::setSleeping(bool allowed) {
    m_data->sleep.allowed = allowed;
    for (BodyRecord& record : m_data->bodies.records) {
        record.stillTime = 0;
    }
}

void World::setRecordsImpulses(bool records) {
    m_data->impulses = {};
    m_data->impulses.on = records;
}

bool World::recordsImpulses() const {
    return m_data->impulses.on;
}

const UpdateParameters& World::parameters() const {
    return m_data->parameters;
}

void World::setParameters(const UpdateParameters& parameters) {
    EXPECTS(isUsable(parameters));
    m_data->parameters = parameters;
}

const Events& World::events() const {
    return m_data->events;
}

bool World::contains(BodyId body) const {
    return m_data->bodies.contains(body);
}

BodyState World::body(BodyId body) const {
    EXPECTS(contains(body));
    const BodyRecord& r = m_data->bodies.records[body.index];
    const BodyMotion& m = m_data->bodies.motions[body.index];
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const bool dynamic = r.kind == BodyKind::Dynamic;
    return {.kind = r.kind,
            .pose = {m.center - m.rotation * r.localCenter, m.rotation},
            .angle = m.rotation.angle(),
            .velocity = m.velocity,
            .angularVelocity = m.angularVelocity,
            .massCenter = m.center,
            .mass = dynamic ? r.mass : infinite,
            .inertia = dynamic ? r.inertia : infinite,
            .filter = r.filter,
            .touchedTags =
                body.index < m_data->bodies.touchedTags.size() ? m_data->bodies.touchedTags[body.index] : TagMask{},
            .tangible = r.tangible,
            .active = r.active,
            .asleep = r.asleep,
            .positionFrozen = r.positionFrozen,
            .rotationFrozen = r.rotationFrozen,
            .user = r.user};
}

const std::vector<Shape>& World::shapes(BodyId body) const {
    EXPECTS(contains(body));
    return *m_data->bodies.records[body.index].shapes;
}

Aabb World::bounds(BodyId body) const {
    EXPECTS(contains(body));
    const BodyRecord& record = m_data->bodies.records[body.index];
    Aabb box = record.bounds;
    if (record.kind == BodyKind::Static && !box.isEmpty()) {
        return box; // valid until the body is moved; spares a pass over its parts
    }
    // Position correction may move the body out of its fat AABB in the last iteration.
    box.include(boundsOf(*record.parts, m_data->bodies.pose(body.index)));
    return box;
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    for (Slot slot = 0; slot < m_data->bodies.records.size(); ++slot) {
        if (m_data->bodies.records[slot].used) {
            ids.push_back(m_data->bodies.idOf(slot));
        }
    }
    std::sort(ids.begin(), ids.end(), [this](BodyId a, BodyId b) {
        return m_data->bodies.records[a.index].serial < m_data->bodies.records[b.index].serial;
    });
    return ids;
}

int World::bodyCount() const {
    return static_cast<int>(m_data->bodies.records.size() - m_data->bodies.freeSlots.size());
}

} // namespace spacetow
