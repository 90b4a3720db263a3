#pragma once
// Merges contacts of one body that lie in one plane.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// Replaces general contacts of one body in one plane by a single contact with their outermost points, at most two.
/// Examples: a flat face on several walls, or several parts of the body on one wall. The block solver then solves both
/// points at once, so the result does not depend on the order of walls and parts. Only contacts with the same friction
/// and restitution are merged. Works on `NarrowPhase::constraints`, before the contacts get lanes. Appends all pairs of
/// merged contacts to `mergedPairs`; these pairs are not updated while the merged contact has a lane.
void mergeContacts(const ContactStage& stage);

} // namespace spacetow
