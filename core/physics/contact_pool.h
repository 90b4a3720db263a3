#pragma once
// What is known of contacts, for the pairs that have come near each other.

#include "core/physics/world_data.h"

namespace spacetow {

/// The pair's contact; a new one without points if it has none.
Contact& contactOf(WorldData& data, Pair& pair);

void forgetContact(WorldData& data, Pair& pair);

} // namespace spacetow
