#pragma once
// The fan of where the ship, and the payload on its rope, can be in the next seconds, and the way they go with the keys
// as they are held.

#include "core/game/reach.h"
#include "editor/canvas/stage.h"

#include <vector>

namespace spacetow {

struct ShownReach {
    std::vector<ReachOutline> outlines; // the nearest first
    HeldPath path;
};

/// Outlines of the ship are solid, those of the payload dashed; each of the ship has its time at its top.
void paintReach(const Stage& stage, const ShownReach& reach);

} // namespace spacetow
