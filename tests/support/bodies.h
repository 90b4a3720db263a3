#pragma once
// The bodies that tests put into worlds. SI units.

#include "core/physics/world/world.h"

namespace spacetow::test {

/// A static edge body; solid for what comes from the left of a→b.
BodyDef edgeBody(const Vec2& a, const Vec2& b, double depth = noBack);
BodyDef lineBody(const Vec2& a, const Vec2& b);
BodyDef ball(const Vec2& at, double radius);
/// A box with the given half sizes.
BodyDef box(const Vec2& at, double halfWidth, double halfHeight);
/// Adds a body that must be fine.
BodyId add(World& world, const BodyDef& def);

} // namespace spacetow::test
