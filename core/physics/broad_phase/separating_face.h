#pragma once
// A separating-axis test of the broad phase for slender parts, whose AABBs are mostly empty: an AABB in front of one
// face of the part makes no pair.

#include "core/physics/state/body_data.h"

namespace spacetow {

/// Whether the AABB of the part is mostly empty when the part is turned.
bool isSlender(const Part& part);

/// Whether `box` lies in front of one face of the part, by more than the slop, for every pose that the part can have
/// within its fat AABB.
bool isInFrontOfFace(const Aabb& box, const ConvexPart& part, const Rot& rotation, const FatAabb& fat);

} // namespace spacetow
