#pragma once
// What a press drives against something that stands still: it stays on its side of that, the press overlaps it, and an
// event says that it is crushed.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Notes who is taken out of its fat AABB by pushes out of overlaps, or by what carries him along: for bodies that
/// something drives which cannot be stopped.
void measureCorrections(WorldData& data);

/// Limits the ways of such bodies, pushes out of overlaps included: none goes
/// further into what stands still than the slop. Who is crushed thereby and was not in the iteration before is among
/// the events. To be called when the motion is about to be carried out.
void keepOutOfStatics(WorldData& data, int iteration);

} // namespace spacetow
