#include "core/physics/solver/carriers.h"

namespace spacetow {

namespace {

void findCarrier(WorldData& data, Slot a, Slot b, std::uint32_t pair) {
    if ((data.movable[a] & data.movable[b]) != 0 || !data.table.flags[pair].touching ||
        data.table.pairs[pair].staticB) {
        return;
    }
    if (!data.motions[a].isMovable()) {
        data.steps[b].carrier = a;
    } else if (!data.motions[b].isMovable()) {
        data.steps[a].carrier = b;
    }
}

bool anyKinematic(const WorldData& data) {
    return !data.moving.empty() && data.records[data.moving.front()].kind == BodyKind::Kinematic;
}

void carry(WorldData& data, Slot slot) {
    BodyStep& s = data.steps[slot];
    const BodyStep& by = data.steps[s.carrier];
    const double rest = 1 - s.fraction;
    const Vec2 start = data.motions[slot].center + s.fraction * s.deltaPosition;
    const Vec2 arm = start - data.motions[s.carrier].center - s.fraction * by.deltaPosition;
    s.correction += rest * by.deltaPosition;
    if (by.deltaAngle != 0) {
        s.correction += turned(Rot{}, rest * by.deltaAngle) * arm - arm;
        s.angleCorrection += s.isCircle ? 0 : rest * by.deltaAngle;
    }
}

} // namespace

void findCarriers(WorldData& data) {
    if (!anyKinematic(data)) {
        return;
    }
    for (const CircleContact& c : data.circleContacts) {
        findCarrier(data, c.a, c.b, c.pair);
    }
    for (const GeneralContact& c : data.generalContacts) {
        findCarrier(data, c.a, c.b, c.points[0].pair);
    }
}

void carryStopped(WorldData& data) {
    if (!anyKinematic(data)) {
        return;
    }
    for (const Slot slot : data.moving) {
        if (data.steps[slot].fraction < 1 && data.steps[slot].carrier != noSlot) {
            carry(data, slot);
        }
    }
}

} // namespace spacetow
