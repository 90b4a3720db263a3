#pragma once
// The ship: its hull and how it flies. Figures chosen by playing, from the decisions on tuning.

#include "core/game/controls.h"
#include "core/geometry/shape.h"
#include "core/level/ship_figures.h"
#include "core/physics/def/body.h"
#include "core/physics/world/world.h"

namespace spacetow {

namespace ship {
constexpr double steering = 6.0;       // rad/s², while a direction is held
constexpr double angularDamping = 2.5; // 1/s
constexpr double restitution = 0.3;
} // namespace ship

/// The hull about its centroid, nose up, anticlockwise; the third vertex of the outline is the notch at the stern.
Polygon shipHull();
/// Where the tow rope is made fast: the notch, in the ship's local coordinates.
Vec2 shipNotch();
BodyDef shipBody(const Vec2& position, double angle);
/// Applies to the next update what the pilot holds down; left and right together cancel.
void steer(World& world, BodyId ship, const Controls& controls);

} // namespace spacetow
