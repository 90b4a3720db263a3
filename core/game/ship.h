#pragma once
// The ship: its hull and how it flies. How strong it is, the rules of the level say.

#include "core/game/controls.h"
#include "core/geometry/shape.h"
#include "core/level/level.h"
#include "core/physics/def/body.h"
#include "core/physics/world/world.h"

namespace spacetow {

/// The hull about its centroid, nose up, anticlockwise; the third vertex of the outline is the notch at the stern.
Polygon shipHull();
/// Where the tow rope is made fast: the notch, in the ship's local coordinates.
Vec2 shipNotch();
BodyDef shipBody(const Vec2& position, double angle, const Rules& rules = {});
/// Applies to the next update what the pilot holds down; left and right together cancel.
void steer(World& world, BodyId ship, const Controls& controls, const Rules& rules);

} // namespace spacetow
