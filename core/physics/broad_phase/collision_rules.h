#pragma once
// Which bodies may collide, whatever their poses.

#include "core/physics/state/world_parts.h"

#include <algorithm>

namespace spacetow {

/// Whether neither body is a sensor.
inline bool areTangible(const Bodies& bodies, Slot a, Slot b) {
    return bodies.records[a].tangible && bodies.records[b].tangible;
}

/// Whether two bodies of these kinds have contacts or sensor events: one of them is dynamic or a sensor.
inline bool haveCollidingKinds(const Bodies& bodies, Slot a, Slot b) {
    return bodies.records[a].kind == BodyKind::Dynamic || bodies.records[b].kind == BodyKind::Dynamic ||
           !areTangible(bodies, a, b);
}

/// Whether a connector joins the bodies and keeps them from colliding.
inline bool areKeptApart(const Forces& forces, Slot a, Slot b) {
    return !forces.notColliding.empty() &&
           std::binary_search(forces.notColliding.begin(), forces.notColliding.end(), SlotPair(std::minmax(a, b)));
}

/// Whether the bodies would collide if their filters admitted each other.
inline bool mayCollideButForFilters(const Bodies& bodies, const Forces& forces, Slot a, Slot b) {
    return a != b && haveCollidingKinds(bodies, a, b) && !areKeptApart(forces, a, b);
}

/// Whether the pair table may have pairs of the two bodies.
inline bool mayCollide(const Bodies& bodies, const Forces& forces, Slot a, Slot b) {
    return mayTouch(bodies.records[a].filter, bodies.records[b].filter) &&
           mayCollideButForFilters(bodies, forces, a, b);
}

} // namespace spacetow
