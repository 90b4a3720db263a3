#pragma once
// What the play view adds to the scene painters' picture: the flame of the thruster and the range of the tow rope.

#include "core/game/snapshot.h"
#include "editor/canvas/stage.h"

namespace spacetow {

/// Below the ship; flickers with the update, so that equal snapshots look equal.
void paintFlame(const Stage& stage, const Snapshot& snapshot);
/// A ring round the waiting payload while the ship is near; `range` in metres.
void paintTowRange(const Stage& stage, const Snapshot& snapshot, double range);

} // namespace spacetow
