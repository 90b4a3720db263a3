#include "core/physics/solver/carriers.h"

namespace spacetow {

namespace {

/// Of a pair that touches.
void findCarrier(Bodies& bodies, const Pair& pair) {
    const Slot a = pair.bodyA;
    const Slot b = pair.bodyB;
    if ((bodies.movable[a] & bodies.movable[b]) != 0 || pair.staticB) {
        return;
    }
    if (!bodies.motions[a].isMovable()) {
        bodies.steps[b].carrier = a;
    } else if (!bodies.motions[b].isMovable()) {
        bodies.steps[a].carrier = b;
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

void findCarriers(Bodies& bodies, const PairTable& table, const Constraints& constraints) {
    if (!anyKinematic(bodies)) {
        return;
    }
    const auto find = [&](std::uint32_t pair) {
        if (table.flags[pair].touching) {
            findCarrier(bodies, table.pairs[pair]);
        }
    };
    for (const CircleContact& c : constraints.circleContacts) {
        find(c.pair);
    }
    for (const GeneralContact& c : constraints.generalContacts) {
        find(c.points[0].pair);
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
