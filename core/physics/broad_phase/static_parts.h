#pragma once
// From static bodies to their geometry.

#include "core/physics/state/world_data.h"

#include <span>

namespace spacetow {

/// The part of a static body in world coordinates, joined to nothing but other parts of its body.
StaticGeometry::Collider staticColliderOf(const Bodies& bodies, Slot body, std::uint32_t part);

/// Static bodies that continue one another are as smooth as one body.
void joinStatics(StaticGeometry& geometry);

/// What finds the colliders by where they are.
void buildStaticTrees(StaticGeometry& geometry);

/// Notes where a static body is, from its colliders.
void noteStaticBounds(Bodies& bodies, std::span<const StaticGeometry::Collider> colliders);

/// Takes a few changes up; false when there are so many that making all anew costs less.
bool patchStatics(Bodies& bodies, BroadPhase& broadPhase);

} // namespace spacetow
