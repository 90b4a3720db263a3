#pragma once
// From the pairs that the broad phase has found to the table of pairs.

#include "core/physics/broad_phase/pair_stage.h"

namespace spacetow {

/// What has to change in the table; nothing does yet. Both are sorted. Old pairs of bodies that stayed in their fat
/// AABBs remain; the others must have been found again. False when nothing has to.
bool comparePairs(const PairStage& stage);

/// Makes the change, after what is known of the contacts of `dropped` pairs has been forgotten.
void changeTable(const Bodies& bodies, Contacts& contacts, const StepFlags& flags, PairChanges& changes);

} // namespace spacetow
