#pragma once
// From touching pairs to events: what began, what ended, and the tags each body touched.

#include "core/physics/world_data.h"

namespace spacetow {

/// Merges the sorted body pairs of this iteration with those of the last one.
void reportTouches(WorldData& data, int iteration);

} // namespace spacetow
