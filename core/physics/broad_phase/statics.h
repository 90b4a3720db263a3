#pragma once
// The static geometry: the parts of static bodies in world coordinates, with their trees. Changes since it was built
// are in a small second geometry (StaticChanges). Every search gives the same result as a rebuilt geometry would: the
// joints of all parts near a change are computed again.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Applies the changes of static bodies since the last call. A few changes cost time with their own number, not with
/// that of the bodies. `asleep`, the pairs of sleeping bodies, gets the new indices of the parts.
void refreshStatics(Bodies& bodies, BroadPhase& broadPhase, PairTable& asleep, StepFlags& flags);

/// The present index of a part.
std::uint32_t staticIndex(const Bodies& bodies, const BroadPhase& broadPhase, Slot body, std::uint32_t part);

/// The indices of the parts whose solid region may overlap the box, each once, in a deterministic order. A one-way wall
/// is solid behind, to its depth. Clears `out` first.
void findStatics(const BroadPhase& broadPhase, const Aabb& box, std::vector<std::uint32_t>& out);

} // namespace spacetow
