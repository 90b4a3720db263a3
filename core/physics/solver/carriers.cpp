#include "core/physics/solver/carriers.h"

namespace spacetow {

namespace {

void findCarrier(WorldData& data, Slot a, Slot b, std::uint32_t pair) {
    if ((data.bodies.movable[a] & data.bodies.movable[b]) != 0 || !data.contacts.table.flags[pair].touching ||
        data.contacts.table.pairs[pair].staticB) {
        return;
    }
    if (!data.bodies.motions[a].isMovable()) {
        data.bodies.steps[b].carrier = a;
    } else if (!data.bodies.motions[b].isMovable()) {
        data.bodies.steps[a].carrier = b;
    }
}

bool anyKinematic(const Bodies& bodies) {
    return !bodies.moving.empty() && bodies.records[bodies.moving.front()].kind == BodyKind::Kinematic;
}

void carry(Bodies& bodies, Slot slot) {
    BodyStep& s = bodies.steps[slot];
    const BodyStep& by = bodies.steps[s.carrier];
    const double rest = 1 - s.fraction;
    const Vec2 start = bodies.motions[slot].center + s.fraction * s.deltaPosition;
    const Vec2 arm = start - bodies.motions[s.carrier].center - s.fraction * by.deltaPosition;
    s.correction += rest * by.deltaPosition;
    if (by.deltaAngle != 0) {
        s.correction += turned(Rot{}, rest * by.deltaAngle) * arm - arm;
        s.angleCorrection += s.isCircle ? 0 : rest * by.deltaAngle;
    }
}

} // namespace

void findCarriers(WorldData& data) {
    if (!anyKinematic(data.bodies)) {
        return;
    }
    for (const CircleContact& c : data.constraints.circleContacts) {
        findCarrier(data, c.a, c.b, c.pair);
    }
    for (const GeneralContact& c : data.constraints.generalContacts) {
        findCarrier(data, c.a, c.b, c.points[0].pair);
    }
}

void carryStopped(Bodies& bodies) {
    if (!anyKinematic(bodies)) {
        return;
    }
    for (const Slot slot : bodies.moving) {
        if (bodies.steps[slot].fraction < 1 && bodies.steps[slot].carrier != noSlot) {
            carry(bodies, slot);
        }
    }
}

} // namespace spacetow
