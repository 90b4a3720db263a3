#pragma once
// The static bodies' parts, in world coordinates, and what finds them. They are looked for in the geometry of all that
// was made at once, and in that of those that have changed since. Whatever is asked for, the answer is that of all made
// anew: where something has changed, joints are made anew as far as they reach.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Takes up what has become of static bodies since the last time: a few changes cost no more than what they change,
/// however many bodies there are. `asleep` are the pairs of sleepers, which find the parts where they are now.
void refreshStatics(Bodies& bodies, BroadPhase& broadPhase, PairTable& asleep, StepFlags& flags);

/// The index of a part as it is now.
std::uint32_t staticIndex(const Bodies& bodies, const BroadPhase& broadPhase, Slot body, std::uint32_t part);

/// The indices of the parts that reach into the box with what is solid, each once and always in the same order.
void findStatics(const BroadPhase& broadPhase, const Aabb& box, std::vector<std::uint32_t>& out);

/// Likewise of shapes themselves; walls are segments.
void findStaticShapes(const BroadPhase& broadPhase, const Aabb& box, std::vector<std::uint32_t>& out);

} // namespace spacetow
