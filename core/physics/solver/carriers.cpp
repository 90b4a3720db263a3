#include "core/physics/solver/carriers.h"

namespace spacetow {

namespace {

void findCarrier(WorldData& data, Slot a, Slot b, std::uint32_t pair) {
    if ((data.yields[a + 1] & data.yields[b + 1]) != 0 || !data.table.marks[pair].now ||
        data.table.pairs[pair].staticB) {
        return;
    }
    if (!data.motions[a].yields()) {
        data.steps[b].carrier = a;
    } else if (!data.motions[b].yields()) {
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
    const Vec2 start = data.motions[slot].center + s.fraction * s.shift;
    const Vec2 arm = start - data.motions[s.carrier].center - s.fraction * by.shift;
    s.push += rest * by.shift;
    if (by.turn != 0) {
        s.push += turned(Rot{}, rest * by.turn) * arm - arm;
        s.pushTurn += s.round ? 0 : rest * by.turn;
    }
}

} // namespace

void findCarriers(WorldData& data) {
    if (!anyKinematic(data)) {
        return;
    }
    for (const RoundContact& c : data.roundContacts) {
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
