#pragma once
// The picture between two updates, for displays that are faster than the simulation.

#include "core/game/snapshot.h"

namespace spacetow {

/// `before` at share 0, `now` at share 1. Bodies that are in one of them only, and all that is not a place or an angle,
/// are as in `now`; the camera jumps with a new attempt. Linear in the number of bodies that move.
Snapshot blended(const Snapshot& before, const Snapshot& now, double share);

} // namespace spacetow
