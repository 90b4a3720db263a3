#include "core/physics/solver/moving_platforms.h"

namespace spacetow {

namespace {

/// Of a pair that touches.
void findPlatform(Bodies& bodies, const Pair& pair) {
    const Slot a = pair.bodyA;
    const Slot b = pair.bodyB;
    if ((bodies.movable[a] & bodies.movable[b]) != 0 || pair.staticB) {
        return;
    }
    if (!bodies.motions[a].isMovable()) {
        bodies.steps[b].platform = a;
    } else if (!bodies.motions[b].isMovable()) {
        bodies.steps[a].platform = b;
    }
}

bool anyKinematic(const Bodies& bodies) {
    return !bodies.moving.empty() && bodies.records[bodies.moving.front()].kind == BodyKind::Kinematic;
}

void moveWithPlatform(Bodies& bodies, Slot slot) {
    BodyStep& s = bodies.steps[slot];
    const BodyStep& by = bodies.steps[s.platform];
    const double rest = 1 - s.fraction;
    const Vec2 start = bodies.motions[slot].center + s.fraction * s.deltaPosition;
    const Vec2 arm = start - bodies.motions[s.platform].center - s.fraction * by.deltaPosition;
    s.correction += rest * by.deltaPosition;
    if (by.deltaAngle != 0) {
        s.correction += turned(Rot{}, rest * by.deltaAngle) * arm - arm;
        s.angleCorrection += s.isCircle ? 0 : rest * by.deltaAngle;
    }
}

} // namespace

void findPlatforms(Bodies& bodies, const PairTable& table, const Constraints& constraints) {
    if (!anyKinematic(bodies)) {
        return;
    }
    const auto find = [&](std::uint32_t pair) {
        if (table.flags[pair].touching) {
            findPlatform(bodies, table.pairs[pair]);
        }
    };
    for (const CircleContact& c : constraints.circleContacts) {
        find(c.pair);
    }
    for (const GeneralContact& c : constraints.generalContacts) {
        find(c.points[0].pair);
    }
}

void moveWithPlatforms(Bodies& bodies) {
    if (!anyKinematic(bodies)) {
        return;
    }
    for (const Slot slot : bodies.moving) {
        if (bodies.steps[slot].fraction < 1 && bodies.steps[slot].platform != noSlot) {
            moveWithPlatform(bodies, slot);
        }
    }
}

} // namespace spacetow
