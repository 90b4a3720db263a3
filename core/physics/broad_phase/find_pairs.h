#pragma once
// The search of the broad phase: which parts of the bodies that have left their fat AABBs are near which others.

#include "core/physics/broad_phase/pair_stage.h"

namespace spacetow {

/// Lists the parts of all moving bodies, all of which then have to be found.
void listProxies(const Bodies& bodies, BroadPhase& broadPhase, const Sleep& sleep, PairSearch& search);

/// Gives moved bodies new fat AABBs, large enough for so many seconds.
void enlargeAabbs(Bodies& bodies, BroadPhase& broadPhase, const PairSearch& search, double seconds);

/// So many pairs of moving bodies are kept, many times what the densest heap has. Where thousands of bodies are at one
/// place there are more, as many as would fill all memory; whoever finds nobody then has to push his way out later.
std::size_t mostPairs(const BroadPhase& broadPhase);

/// Fills `foundPairs` with all pairs of those, sorted as the table is; with as many as are kept when the place is
/// `crowded`.
void collectPairs(const PairStage& stage);

} // namespace spacetow
