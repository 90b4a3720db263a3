#pragma once
// The broad phase: which parts may meet. A moving body has a fat AABB, larger than its motion in the update; its pairs
// are found again only when it leaves that.

#include "core/physics/broad_phase/pair_stage.h"
#include "core/physics/state/world_data.h"

namespace spacetow {

/// Lists the active bodies that are awake. What the solver and the time of impact keep of those listed before begins
/// anew.
void listMoving(Bodies& bodies, SolverScratch& solver, ToiSearch& toi);
/// Lists the pairs of sensors.
void listSensors(Contacts& contacts, StepFlags& flags);

/// Measures the planned motion of each moving body. Notes which bodies are fast, and which leave their fat AABBs in
/// this iteration or, at their present velocity, within `ahead` seconds more.
void measureMotion(Bodies& bodies, StepFlags& flags, PairSearch& search, double ahead);

/// Finds the pairs of the bodies that have left their fat AABBs, or all pairs when the pairs are stale. Returns whether
/// the table has to change. The table does not change yet: first the contacts of the `dropped` pairs have to be freed.
bool findPairs(const PairStage& stage, const IterationStep& step);

/// Changes the table, which stays sorted and unique; pairs that remain keep what is known of their contacts. Those
/// in `runs` have other indices from now on.
void changePairs(const Bodies& bodies, Contacts& contacts, StepFlags& flags, PairChanges& changes);

} // namespace spacetow
