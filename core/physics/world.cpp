#include "core/physics/world.h"

#include "core/base/contract.h"
#include "core/geometry/bounds.h"
#include "core/physics/changes.h"
#include "core/physics/contact_lanes.h"
#include "core/physics/contact_pool.h"
#include "core/physics/contacts.h"
#include "core/physics/continuous.h"
#include "core/physics/field_forces.h"
#include "core/physics/hold_back.h"
#include "core/physics/integrate.h"
#include "core/physics/islands.h"
#include "core/physics/make_body.h"
#include "core/physics/pairs.h"
#include "core/physics/sleep.h"
#include "core/physics/solve.h"
#include "core/physics/touches.h"
#include "core/physics/world_data.h"

#include <algorithm>

namespace spacetow {

namespace {

bool isUsable(const UpdateParameters& p) {
    return isFinite(p.gravity) && std::isfinite(p.seconds) && p.seconds > 0 && p.iterations >= 1 && p.substeps >= 1;
}

IterationStep iterationStep(const UpdateParameters& p) {
    const double dt = p.seconds / p.iterations;
    // A few passes over coarse iterations; fine ones converge from one iteration to the next.
    const int passes = std::clamp(8 / p.iterations, 2, 4);
    return {dt, dt / p.substeps, p.substeps, p.seconds, 0, passes};
}

// Into so many parts an iteration may be divided.
constexpr int maxParts = 64;

/// The motion as if nothing were touched, and the pairs for it. False when something was not finite.
bool planMotion(WorldData& data, const IterationStep& step, bool first) {
    const double ahead = first ? step.remaining - step.dt : 0; // rooms for a whole update, if they will do
    integrateVelocities(data, step);
    measureMotion(data, ahead);
    const bool fault = data.anyFault;
    if (fault) {
        isolateFaults(data, step.index);
        measureMotion(data, ahead);
    }
    if (data.anyEscaped) {
        findPairs(data, step);
    }
    return !fault;
}

void makeMotion(WorldData& data, const IterationStep& step) {
    findContacts(data, step);
    while (wakeTouched(data, step)) {
        planMotion(data, step, false);
        findContacts(data, step);
    }
    findIslands(data);
    findDriven(data);
    solveVelocities(data, step);
    findCarriers(data);
    if (data.anyFast || data.anySweep || data.anyDiverted) {
        measureMotion(data, 0);
        if (data.anyEscaped) {
            findPairs(data, step);
        }
        stopAtImpacts(data);
        holdBackFollowers(data, step.dt);
    }
    carryStopped(data);
    advance(data, step.dt);
    findOverlaps(data);
    reportTouches(data, step.index);
}

void setDuration(WorldData& data, IterationStep& step, double dt) {
    step.dt = dt;
    step.substep = dt / step.substeps;
    prepareSteps(data, step);
}

void makePart(WorldData& data, const IterationStep& step, double whole) {
    beginPart(data, step.dt / whole);
    makeMotion(data, step);
    endPart(data, step.dt / whole);
}

/// The iteration as planned is too long: it is made in parts.
void iterateInParts(WorldData& data, IterationStep step, double share) {
    const double whole = step.dt;
    const std::size_t reports = data.events.tagsTouched.size();
    double left = whole;
    for (int parts = maxParts - 1; share < 1; --parts) {
        takeBackVelocities(data);
        setDuration(data, step, share * left);
        planMotion(data, step, false);
        makePart(data, step, whole);
        left -= step.dt;
        step.remaining -= step.dt;
        setDuration(data, step, left);
        const bool sound = planMotion(data, step, false);
        share = sound && data.anyFast && parts > 1 ? coveredShare(data, 1.0 / parts) : 1;
    }
    makePart(data, step, whole);
    setDuration(data, step, whole);
    joinTagReports(data, reports);
}

void iterate(WorldData& data, const IterationStep& step) {
    if (data.moving.empty() && !data.sleep.sleepers.empty()) {
        reportTouches(data, step.index);
        return;
    }
    const bool sound = planMotion(data, step, step.index == 0);
    const double share = sound && data.anyFast ? coveredShare(data, 1.0 / maxParts) : 1;
    if (share < 1) {
        iterateInParts(data, step, share);
    } else {
        makeMotion(data, step);
    }
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
    WorldData& data = *m_data;
    data.events.clear();
    beginSleep(data, parameters.gravity);
    applyPending(data, -1);
    IterationStep step = iterationStep(parameters);
    prepareStructure(data);
    prepareMotion(data, step, parameters.gravity);
    for (step.index = 0; step.index < parameters.iterations; ++step.index) {
        iterate(data, step);
        step.remaining -= step.dt;
        if (applyPending(data, step.index)) {
            prepareStructure(data);
            prepareSteps(data, step);
        }
    }
    saveImpulses(data);
    fallAsleep(data, parameters.seconds, parameters.iterations - 1);
    collectTouchedTags(data);
}

Result<BodyId> World::addBody(const BodyDef& def) {
    Result<MadeBody> made = makeBody(def);
    if (!made) {
        return made.error();
    }
    WorldData& data = *m_data;
    Slot slot = static_cast<Slot>(data.records.size());
    if (data.freeSlots.empty()) {
        data.records.emplace_back();
        data.motions.emplace_back();
        data.steps.emplace_back();
    } else {
        slot = data.freeSlots.back();
        data.freeSlots.pop_back();
    }
    const std::uint32_t generation = data.records[slot].generation;
    data.records[slot] = made.value().record;
    data.records[slot].generation = generation;
    data.records[slot].used = true;
    data.records[slot].serial = data.nextSerial++;
    data.motions[slot] = made.value().motion;
    data.steps[slot] = made.value().step;
    refreshInverseMass(data, slot);
    data.staticsChanged |= def.kind == BodyKind::Static;
    data.bodiesChanged = true;
    refreshFields(data);
    disturb(data, slot);
    return data.idOf(slot);
}

void World::removeBody(BodyId body) {
    EXPECTS(contains(body));
    m_data->pending.push_back({PendingChange::Kind::Remove, body});
}

void World::setActive(BodyId body, bool active) {
    EXPECTS(contains(body));
    m_data->pending.push_back({PendingChange::Kind::Active, body, active});
}

void World::setTangible(BodyId body, bool tangible) {
    EXPECTS(contains(body));
    m_data->pending.push_back({PendingChange::Kind::Tangible, body, tangible});
}

void World::setFrozen(BodyId body, bool position, bool rotation) {
    EXPECTS(contains(body));
    m_data->pending.push_back({PendingChange::Kind::Frozen, body, position, rotation});
}

void World::setPose(BodyId body, const Vec2& position, double angle) {
    EXPECTS(contains(body) && isFinite(position) && std::isfinite(angle));
    BodyMotion& m = m_data->motions[body.index];
    BodyRecord& record = m_data->records[body.index];
    m.rotation = Rot::fromAngle(angle);
    m.center = position + m.rotation * record.localCenter;
    record.bounds = Aabb{};
    m_data->pairsStale = true;
    m_data->staticsChanged |= record.kind == BodyKind::Static;
    disturb(*m_data, body.index);
}

void World::setVelocity(BodyId body, const Vec2& velocity, double angularVelocity) {
    EXPECTS(contains(body) && isFinite(velocity) && std::isfinite(angularVelocity));
    const BodyRecord& record = m_data->records[body.index];
    if (record.kind == BodyKind::Static) {
        return;
    }
    BodyMotion& m = m_data->motions[body.index];
    m.velocity = record.positionFrozen ? Vec2(0, 0) : velocity;
    m.angularVelocity = record.rotationFrozen ? 0 : angularVelocity;
    disturb(*m_data, body.index);
}

void World::setFilter(BodyId body, const Filter& filter) {
    EXPECTS(contains(body));
    m_data->records[body.index].filter = filter;
    m_data->pairsStale = true;
    disturb(*m_data, body.index);
    if (!m_data->fields.empty()) {
        refreshSubsteps(*m_data);
    }
}

void World::setReportsTouches(BodyId body, bool reports) {
    EXPECTS(contains(body));
    m_data->records[body.index].reportsTouches = reports;
    std::vector<Slot>& reporters = m_data->reporters;
    const auto at = std::lower_bound(reporters.begin(), reporters.end(), body.index);
    const bool listed = at != reporters.end() && *at == body.index;
    if (reports && !listed) {
        reporters.insert(at, body.index);
    } else if (!reports && listed) {
        reporters.erase(at);
    }
}

void World::setSleeping(bool allowed) {
    m_data->sleep.allowed = allowed;
    for (BodyRecord& record : m_data->records) {
        record.stillFor = 0;
    }
}

bool World::sleeping() const {
    return m_data->sleep.allowed;
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
    return body.index < m_data->records.size() && m_data->records[body.index].used &&
           m_data->records[body.index].generation == body.generation;
}

BodyState World::body(BodyId body) const {
    EXPECTS(contains(body));
    const BodyRecord& r = m_data->records[body.index];
    const BodyMotion& m = m_data->motions[body.index];
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
            .touchedTags = body.index < m_data->touchedTags.size() ? m_data->touchedTags[body.index] : TagMask{},
            .tangible = r.tangible,
            .active = r.active,
            .asleep = r.asleep,
            .positionFrozen = r.positionFrozen,
            .rotationFrozen = r.rotationFrozen,
            .user = r.user};
}

const std::vector<Shape>& World::shapes(BodyId body) const {
    EXPECTS(contains(body));
    return *m_data->records[body.index].shapes;
}

Aabb World::bounds(BodyId body) const {
    EXPECTS(contains(body));
    const BodyRecord& record = m_data->records[body.index];
    Aabb box = record.bounds; // what is pushed out of an overlap may leave it in the last iteration
    for (const Part& part : *record.parts) {
        box.include(boundsOf(part, m_data->pose(body.index)));
    }
    return box;
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    for (Slot slot = 0; slot < m_data->records.size(); ++slot) {
        if (m_data->records[slot].used) {
            ids.push_back(m_data->idOf(slot));
        }
    }
    std::sort(ids.begin(), ids.end(),
              [this](BodyId a, BodyId b) { return m_data->records[a.index].serial < m_data->records[b.index].serial; });
    return ids;
}

int World::bodyCount() const {
    return static_cast<int>(m_data->records.size() - m_data->freeSlots.size());
}

} // namespace spacetow
