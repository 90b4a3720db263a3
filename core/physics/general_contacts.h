#pragma once
// Contacts of one or two points between parts of any shape. A manifold is kept while its parts move little against each
// other: its points stay with their bodies, and what changes is how far apart they are.

#include "core/physics/world_data.h"

namespace spacetow {

/// Adds the contact of a pair to `constraints`, from its kept manifold or from a new one.
void meetGeneral(WorldData& data, std::uint32_t index, double dt);

/// What needs to know of all constraints: those that lie in one plane become one.
void finishGeneral(WorldData& data);

} // namespace spacetow
