#pragma once
// How much memory a copy of a world takes.

#include "core/physics/world/world.h"

#include <cstddef>

namespace spacetow {

/// An estimate, within about 25 %: the arrays of bodies, pairs and contacts count; data that copies share does not.
std::size_t copyBytes(const World& world);

} // namespace spacetow
