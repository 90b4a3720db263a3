#pragma once
// From a constraint to its lane.

#include "core/physics/contacts/contact_stage.h"
#include "core/physics/state/contact_data.h"

namespace spacetow {

inline void setLane(Mask& mask, std::uint32_t lane, bool value) {
    mask[lane] = value ? -1 : 0;
}

/// Writes all that the solver needs of a constraint to the contact's lane.
void pack(const ContactStage& stage, const Constraint& constraint, GeneralContact& contact, double perSecond);

/// Of the singular contact in lane i, whose points have nearly the same effect, the one that overlaps more acts for
/// both.
void keepDeeperPoint(ConstraintBatch& batch, std::uint32_t i);

} // namespace spacetow
