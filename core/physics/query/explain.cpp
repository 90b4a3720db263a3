#include "core/physics/query/explain.h"

#include "core/base/contract.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace spacetow {

namespace {

bool isFree(const BodyRecord& record) {
    return record.used && record.active && record.kind == BodyKind::Dynamic;
}

void addForce(ForceReading& sum, const ForceReading& more) {
    sum.force += more.force;
    sum.torque += more.torque;
}

/// The force and torque that were applied to a dynamic body in the last update: its acceleration without gravity, times
/// mass and inertia.
ForceReading appliedTo(const WorldData& data, Slot slot) {
    const BodyRecord& record = data.bodies.records[slot];
    const bool moved =
        std::find(data.bodies.moving.begin(), data.bodies.moving.end(), slot) != data.bodies.moving.end();
    const bool fresh = std::find(data.bodies.changedBodies.begin(), data.bodies.changedBodies.end(), slot) !=
                       data.bodies.changedBodies.end();
    if (!moved || fresh) {
        return {};
    }
    const BodyStep& s = data.bodies.steps[slot];
    const Vec2 gravity = record.positionFrozen ? Vec2(0, 0) : data.parameters.gravity;
    return {record.mass * (s.acceleration - gravity), record.inertia * s.angularAcceleration};
}

struct Stretch {
    Vec2 a, b; // anchors, world
    Vec2 along{0, 1};
    double distance;
};

Stretch stretchOf(const Bodies& bodies, const ConnectorRecord& c) {
    Stretch stretch{bodies.pose(c.a).toWorld(c.anchorA), bodies.pose(c.b).toWorld(c.anchorB), {0, 1}, 0};
    const Vec2 span = stretch.b - stretch.a;
    stretch.distance = span.norm();
    if (stretch.distance > 0) {
        stretch.along = span / stretch.distance;
    }
    return stretch;
}

ForceReading connectorsOn(const Bodies& bodies, const Forces& forces, Slot slot) {
    ForceReading sum;
    for (const ConnectorRecord& c : forces.connectors) {
        if (!c.used || c.tension == 0 || (c.a != slot && c.b != slot)) {
            continue;
        }
        const Stretch stretch = stretchOf(bodies, c);
        const bool first = c.a == slot;
        const Vec2 force = (first ? c.tension : -c.tension) * stretch.along;
        addForce(sum, {force, cross((first ? stretch.a : stretch.b) - bodies.motions[slot].center, force)});
    }
    return sum;
}

ForceReading contactsOn(const World& world, BodyId body) {
    ForceReading sum;
    for (const ContactReading& contact : contactsOf(world, body)) {
        const bool first = contact.a == body;
        addForce(sum, {first ? Vec2(-contact.impulse) : contact.impulse, first ? contact.turnA : contact.turnB});
    }
    const double seconds = impulseSeconds(world);
    return {sum.force / seconds, sum.torque / seconds};
}

BodyForces forcesOn(const World& world, BodyId body) {
    const WorldData& data = world.data();
    const BodyRecord& record = data.bodies.records[body.index];
    const BodyMotion& m = data.bodies.motions[body.index];
    BodyForces forces;
    if (!isFree(record)) {
        return forces;
    }
    if (!record.positionFrozen) {
        forces.gravity.force = record.mass * data.parameters.gravity;
    }
    forces.applied = appliedTo(data, body.index);
    forces.connectors = connectorsOn(data.bodies, data.forces, body.index);
    forces.contacts = contactsOn(world, body);
    forces.damping = {-record.linearDamping * record.mass * m.velocity,
                      -record.angularDamping * record.inertia * m.angularVelocity};
    return forces;
}

BodyEnergy energyOf(const WorldData& data, Slot slot) {
    const BodyRecord& r = data.bodies.records[slot];
    const BodyMotion& m = data.bodies.motions[slot];
    return {0.5 * r.mass * m.velocity.squaredNorm() + 0.5 * r.inertia * m.angularVelocity * m.angularVelocity,
            -r.mass * data.parameters.gravity.dot(m.center)};
}

template <class Tree>
int cellsOf(const Tree& tree) {
    return static_cast<int>(tree.cells().size());
}

int touchingIn(const PairTable& table) {
    return static_cast<int>(
        std::count_if(table.flags.begin(), table.flags.end(), [](const PairFlags& flags) { return flags.touching; }));
}

/// By slot.
std::vector<Slot> nonStaticOf(const Bodies& bodies) {
    std::vector<Slot> added = bodies.addedNonStatic;
    std::ranges::sort(added);
    std::vector<Slot> all;
    all.reserve(bodies.nonStatic.size() + added.size());
    std::ranges::merge(bodies.nonStatic, added, std::back_inserter(all));
    return all;
}

void countBody(const BodyRecord& record, WorldCounters& count) {
    ++(record.kind == BodyKind::Kinematic ? count.kinematics : count.dynamics);
    ++(record.asleep ? count.asleep : count.awake);
}

} // namespace

ForceReading BodyForces::sum() const {
    ForceReading all;
    for (const ForceReading& one : {gravity, applied, connectors, contacts, damping}) {
        addForce(all, one);
    }
    return all;
}

BodyReading explained(const World& world, BodyId body) {
    EXPECTS(world.contains(body));
    const WorldData& data = world.data();
    const BodyRecord& record = data.bodies.records[body.index];
    const BodyMotion& m = data.bodies.motions[body.index];
    BodyReading reading;
    reading.forces = forcesOn(world, body);
    reading.touchedTags = world.body(body).touchedTags;
    if (isFree(record)) {
        reading.energy = energyOf(data, body.index);
        reading.momentum = record.mass * m.velocity;
        reading.spin = record.inertia * m.angularVelocity;
        reading.angularMomentum = reading.spin + cross(m.center, reading.momentum);
    }
    return reading;
}

ConnectorReading explained(const World& world, ConnectorId connector) {
    EXPECTS(world.contains(connector));
    const ConnectorRecord& c = world.data().forces.connectors[connector.index];
    const double distance = stretchOf(world.data().bodies, c).distance;
    return {distance, c.length, c.tension, storedEnergy(c, distance)};
}

WorldReading totals(const World& world) {
    const WorldData& data = world.data();
    WorldReading sum;
    for (const Slot slot : nonStaticOf(data.bodies)) {
        const BodyRecord& record = data.bodies.records[slot];
        if (!isFree(record)) {
            continue;
        }
        const BodyMotion& m = data.bodies.motions[slot];
        const BodyEnergy energy = energyOf(data, slot);
        sum.kinetic += energy.kinetic;
        sum.potential += energy.potential;
        sum.momentum += record.mass * m.velocity;
        sum.motion += record.mass * m.velocity.norm();
        sum.angularMomentum += record.inertia * m.angularVelocity + record.mass * cross(m.center, m.velocity);
    }
    for (const ConnectorRecord& c : data.forces.connectors) {
        sum.elastic += c.used ? storedEnergy(c, stretchOf(data.bodies, c).distance) : 0;
    }
    return sum;
}

WorldCounters counters(const World& world) {
    const WorldData& data = world.data();
    WorldCounters count;
    const std::vector<Slot> nonStatic = nonStaticOf(data.bodies);
    for (const Slot slot : nonStatic) {
        countBody(data.bodies.records[slot], count);
    }
    count.statics = static_cast<int>(data.bodies.records.size() - data.bodies.freeSlots.size() - nonStatic.size());
    count.pairs = static_cast<int>(data.contacts.table.size() + data.sleep.table.size());
    count.contacts = touchingIn(data.contacts.table) + touchingIn(data.sleep.table);
    count.treeCells = cellsOf(data.broadPhase.tree);
    if (data.broadPhase.statics) {
        count.treeCells += cellsOf(data.broadPhase.statics->tree);
    }
    if (data.broadPhase.staticChanges) {
        count.treeCells += cellsOf(data.broadPhase.staticChanges->geometry.tree);
    }
    count.islands = static_cast<int>(data.bodies.moving.empty() ? 0 : data.contactGraph.componentRoots.size());
    count.connectors = static_cast<int>(data.forces.connectors.size() - data.forces.freeConnectors.size());
    return count;
}

} // namespace spacetow
