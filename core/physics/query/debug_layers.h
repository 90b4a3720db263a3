#pragma once
// The overlays of drawWorld (debug_draw.h) that need more than one body, or only the outline of a body. Each function
// draws its overlay, whether the overlay is switched on or not.

#include "core/physics/query/debug_view.h"

namespace spacetow {

// Drawing to be looked at has its marks and texts in units of the picture, whatever its scale.
constexpr double leastExtent = 2; // of what is too small to be seen

/// The more a cell holds, the fuller it is; a number where there is room for one.
void drawTrees(const World& world, const DebugView& view, DebugDraw& draw);
/// Filled in the colour of its island, in that of sleep when it sleeps.
void drawIsland(const World& world, BodyId body, const DebugView& view, DebugDraw& draw);
/// Outlined in the colour of its first tag that has one, with a dot for each further one.
void drawTags(const World& world, BodyId body, const DebugView& view, DebugDraw& draw);
/// Marks what the selected bodies would collide with, and what they would pass through.
void drawCollisions(const World& world, const DebugView& view, DebugDraw& draw);
/// The tension as hue, and in newtons where there is room.
void drawConnectors(const World& world, const DebugView& view, DebugDraw& draw);
void drawRisks(const World& world, const DebugView& view, DebugDraw& draw);
void drawTrails(const DebugView& view, DebugDraw& draw);
/// Points; normals; and the force of the last iteration, one metre for as much as the lighter body weighs at 9.81 m/s²:
/// impulse · iterations / seconds / (mass · 9.81), along the normal and, for friction, across it.
void drawContacts(const World& world, const DebugView& view, DebugDraw& draw);
/// A cross along the body's axes.
void drawMassCenter(const BodyState& state, const DebugView& view, DebugDraw& draw);
void drawName(const World& world, BodyId body, const DebugView& view, DebugDraw& draw);

} // namespace spacetow
