#pragma once
// How much memory a copy of a world takes.

#include "core/physics/world/world.h"

#include <cstddef>

namespace spacetow {

/// To a quarter or so: what grows with bodies, pairs and contacts is counted. What copies share is not.
std::size_t copyBytes(const World& world);

} // namespace spacetow
