#pragma once
// The broad phase: which parts may meet. A moving body has room around it, larger than its motion in the update; its
// pairs are found again only when it leaves that.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Lists the moving bodies and, when static bodies have changed, builds their tree anew.
void prepareStructure(WorldData& data);

/// The active bodies that are awake, and the pairs that are felt only. For who changes these by himself.
void listMoving(WorldData& data);
void listFelt(WorldData& data);

/// How far each moving body would go in this iteration: notes what travels far, and what would leave its room now or,
/// as it is going, within `ahead` seconds more.
void measureMotion(WorldData& data, double ahead);

/// Finds the pairs of the bodies that have left their rooms, or all pairs when they are stale. Whether the table has to
/// change. It does not yet: `dropped` has the pairs whose contacts are to be forgotten before.
bool findPairs(WorldData& data, const IterationStep& step);

/// Changes the table, which stays sorted and unique; pairs that remain keep what is known of their contacts. Those
/// in `stretches` have other indices from now on.
void changePairs(WorldData& data);

} // namespace spacetow
