#pragma once
// Writes a constraint to its lane of a SIMD batch.

#include "core/physics/contacts/contact_stage.h"
#include "core/physics/state/contact_data.h"

namespace spacetow {

/// Sets one lane of the mask to all ones (true) or all zeros (false).
inline void setLane(Mask& mask, std::uint32_t lane, bool value) {
    mask[lane] = value ? -1 : 0;
}

/// Writes solver data and anchors of `constraint` to the lane of `contact`, and the points of `constraint` to
/// `contact`. The lane has to be open. `perSecond` is iterations per second.
void pack(const ContactStage& stage, const Constraint& constraint, GeneralContact& contact, double perSecond);

/// For the singular contact in lane i: the effects of the two points are nearly the same, so the block matrix cannot be
/// inverted safely. The deeper point takes the impulses of both, and the other point gets no impulse.
void keepDeeperPoint(ConstraintBatch& batch, std::uint32_t i);

} // namespace spacetow
