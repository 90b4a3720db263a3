#pragma once
// The broad phase: which parts may meet. A moving body has room around it, larger than its motion in the update; its
// pairs are found again only when it leaves that.

#include "core/physics/world_data.h"

namespace spacetow {

/// Lists the moving bodies and, when static bodies have changed, builds their tree anew.
void prepareStructure(WorldData& data);

/// The active bodies that are awake, and the pairs that are felt only. For who changes these by himself.
void listMoving(WorldData& data);
void listFelt(WorldData& data);

/// How far each moving body would go in this iteration: notes what travels far, and what would leave its room now or,
/// as it is going, within `ahead` seconds more.
void measureMotion(WorldData& data, double ahead);

/// Finds the pairs of the bodies that have left their rooms, or all pairs when they are stale. The table stays sorted
/// and unique; pairs that remain keep their impulses.
void findPairs(WorldData& data, const IterationStep& step);

} // namespace spacetow
