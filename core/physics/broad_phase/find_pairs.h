#pragma once
// The search of the broad phase: the pairs of moved proxies.

#include "core/physics/broad_phase/pair_stage.h"

namespace spacetow {

/// Lists the parts of all moving bodies as proxies, all of them moved.
void listProxies(const Bodies& bodies, BroadPhase& broadPhase, const Sleep& sleep, PairSearch& search);

/// Enlarges the fat AABBs of moved bodies for `seconds` of motion at their present velocity.
void enlargeAabbs(Bodies& bodies, BroadPhase& broadPhase, const PairSearch& search, double seconds);

/// The limit on pairs, many times the number of the densest heap: the square of thousands of bodies at one place would
/// fill the memory. The pairs beyond the limit are found once the bodies have come apart.
std::size_t mostPairs(const BroadPhase& broadPhase);

/// Fills `foundPairs` with all pairs of moved proxies, in the order of the pair table. Stops at `mostPairs` and sets
/// `crowded`.
void collectPairs(const PairStage& stage);

} // namespace spacetow
