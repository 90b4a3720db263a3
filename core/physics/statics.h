#pragma once
// The static bodies' parts, in world coordinates, and their tree.

#include "core/physics/world_data.h"

namespace spacetow {

/// Replaces `statics` when a static body has been added, moved, switched or removed since it was made.
void refreshStatics(WorldData& data);

} // namespace spacetow
