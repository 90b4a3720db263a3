#pragma once
// Brings the pair table up to date with the pairs that the broad phase has found.

#include "core/physics/broad_phase/pair_stage.h"

namespace spacetow {

/// Computes the changes without applying them. Old pairs of which neither body is a moved proxy remain; the other old
/// pairs are dropped unless they were found again. Needs sorted lists. Returns false if nothing changes.
bool comparePairs(const PairStage& stage);

/// Applies the changes. The caller has freed the contacts of the `dropped` pairs.
void changeTable(const Bodies& bodies, Contacts& contacts, const StepFlags& flags, PairChanges& changes);

} // namespace spacetow
