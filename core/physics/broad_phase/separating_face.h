#pragma once
// For long parts the broad phase's boxes are mostly empty; what is in one of them may still stay in front of a face.

#include "core/physics/state/body_data.h"

namespace spacetow {

/// Whether a part's box is mostly empty when the part stands at an angle.
bool isSlender(const Part& part);

/// Whether whatever stays in the box stays in front of one face of the part, by more than the slop, while the body of
/// that stays in its fat AABB.
bool isInFrontOfFace(const Aabb& box, const ConvexPart& part, const Rot& rotation, const FatAabb& fat);

} // namespace spacetow
