#pragma once
// The search of the broad phase: which parts of the bodies that have left their fat AABBs are near which others.

#include "core/physics/broad_phase/pair_stage.h"

namespace spacetow {

/// Lists the parts of all moving bodies, all of which then have to be found.
void listProxies(const Bodies& bodies, BroadPhase& broadPhase, const Sleep& sleep, PairSearch& search);

/// Gives moved bodies new fat AABBs, large enough for so many seconds.
void enlargeAabbs(Bodies& bodies, BroadPhase& broadPhase, const PairSearch& search, double seconds);

/// The most pairs of moving bodies that are kept: many times what the densest heap has. Thousands of bodies at one
/// place have more pairs, which would fill all memory; the pairs that are left out are found when the crowd has come
/// apart.
std::size_t mostPairs(const BroadPhase& broadPhase);

/// Fills `foundPairs` with all pairs of moved bodies, in the order of the table. When there are more than are kept,
/// finds no more than that and sets `crowded`.
void collectPairs(const PairStage& stage);

} // namespace spacetow
