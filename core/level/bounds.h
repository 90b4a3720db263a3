#pragma once
// How much room the objects of a level take, in world coordinates (m).

#include "core/level/level.h"
#include "core/math/aabb.h"

#include <span>

namespace spacetow {

/// Bounds of one object (walls without their depth, the ship by its outline, connectors by their anchors; empty when
/// an end is missing; groups by their members, which is a search through the level).
Aabb boundsOf(const Level& level, const Object& object);
/// Of the objects together, groups by their members.
Aabb boundsOf(const Level& level, std::span<const Key> keys);
/// Of everything in the level; empty for an empty level.
Aabb boundsOf(const Level& level);

} // namespace spacetow
