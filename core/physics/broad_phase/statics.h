#pragma once
// The static bodies' parts, in world coordinates, and their tree.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Replaces `statics` when a static body has been added, moved, switched or removed since it was made.
void refreshStatics(WorldData& data);

/// The indices of the parts that reach into the box, each once and always in the same order.
void findStatics(const StaticGeometry& geometry, const Aabb& box, std::vector<std::uint32_t>& out);

} // namespace spacetow
