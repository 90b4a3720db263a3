#pragma once
// The geometry of static bodies: colliders in world coordinates, and their trees.

#include "core/physics/state/world_data.h"

#include <span>

namespace spacetow {

/// Whether the static geometry has the parts of the body.
bool isActiveStatic(const BodyRecord& record);

/// A part of a static body in world coordinates. Joints to other bodies are not set; joinStatics sets them.
StaticGeometry::Collider staticColliderOf(const Bodies& bodies, Slot body, std::uint32_t part);

/// Joins walls and parts of different static bodies that meet, so that nothing trips where one continues the other.
void joinStatics(StaticGeometry& geometry);

/// Builds the trees over all colliders.
void buildStaticTrees(StaticGeometry& geometry);

/// Sets the bounds of static bodies to those of their colliders.
void noteStaticBounds(Bodies& bodies, std::span<const StaticGeometry::Collider> colliders);

/// Applies the changes of static bodies to the patch beside the tree. Returns false, and does nothing, when there are
/// so many that a rebuild costs less.
bool patchStatics(Bodies& bodies, BroadPhase& broadPhase);

} // namespace spacetow
