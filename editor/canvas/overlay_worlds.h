#pragma once
// What the physics makes of a level at its start, for overlays while nothing runs.

#include "core/level/level.h"
#include "core/physics/query/debug_draw.h"

#include <memory>
#include <vector>

namespace spacetow {

struct OverlayWorlds {
    World start;   // everything where the level has it, with quadtrees
    World touched; // after the first update, with contacts and islands; empty unless an overlay needs it
    std::vector<DebugTrail> trails; // of the first second; likewise
    OverlayFlags made;              // for which of the overlays
};

/// Costs as much as the level takes to be built; for contacts and islands, an update more; for trails, a second's.
std::shared_ptr<const OverlayWorlds> overlayWorlds(const Level& level, const OverlayFlags& overlays);

/// As many segments that are painted take as long; more than some thousands are not counted.
int workOfWorlds(const Level& level, const OverlayFlags& overlays);

/// Whether worlds that were made for the one will do for the other.
bool covers(const OverlayFlags& made, const OverlayFlags& wanted);

} // namespace spacetow
