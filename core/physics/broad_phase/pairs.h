#pragma once
// The broad phase: which parts may collide. A moving body has a fat AABB, larger than its motion in the update. Its
// pairs are searched again only when it leaves the fat AABB.

#include "core/physics/broad_phase/pair_stage.h"
#include "core/physics/state/world_data.h"

namespace spacetow {

/// Lists the moving bodies: those that are active, awake and not static. Clears the scratch data by slot of the bodies
/// that were listed before.
void listMoving(Bodies& bodies, SolverScratch& solver, ToiSearch& toi);
/// Lists the pairs with a sensor.
void listSensors(Contacts& contacts, StepFlags& flags);

/// Measures the planned motion of each moving body. Flags bodies that are fast, and collects the moved proxies: bodies
/// that leave their fat AABB in this iteration or, at their present velocity, within `ahead` seconds after it.
void measureMotion(Bodies& bodies, StepFlags& flags, PairSearch& search, double ahead);

/// Finds the pairs of the moved proxies, or all pairs if the table is stale. Returns whether the table has to change.
/// The caller first frees the contacts of the `dropped` pairs, then calls changePairs.
bool findPairs(const PairStage& stage, const IterationStep& step);

/// Applies the changes to the pair table, which stays sorted and unique. Pairs that remain keep their contacts; the
/// pairs in `runs` have new indices from then on.
void changePairs(const Bodies& bodies, Contacts& contacts, StepFlags& flags, PairChanges& changes);

} // namespace spacetow
