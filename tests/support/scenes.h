#pragma once
// Worlds for tests and benchmarks alike. SI units.

#include "core/physics/world.h"

#include <optional>
#include <string_view>

namespace spacetow::test {

/// A static edge body; solid for what comes from the left of a→b.
BodyDef edgeBody(const Vec2& a, const Vec2& b, double depth = noBack);
BodyDef lineBody(const Vec2& a, const Vec2& b);
BodyDef ball(const Vec2& at, double radius);
/// A box with the given half sizes.
BodyDef box(const Vec2& at, double halfWidth, double halfHeight);
/// Adds a body that must be fine.
BodyId add(World& world, const BodyDef& def);

/// The benchmark scenes by name: balls, pyramid, cave, tumbler, tow, mesh; `n` as each defines it.
std::optional<World> scene(std::string_view name, int n, const UpdateParameters& parameters);
/// The parameters of a scene's default run.
UpdateParameters sceneParameters(std::string_view name);

} // namespace spacetow::test
