#pragma once
// Which bodies overlap and pass through each other because of their filters.

#include "core/physics/world/world.h"

#include <utility>
#include <vector>

namespace spacetow {

/// Pairs of bodies that overlap now and would collide but for their filters; each pair once, first the body that was
/// added first. Returns at once when the filters of all bodies admit each other.
std::vector<std::pair<BodyId, BodyId>> maskedMeetings(const World& world);

} // namespace spacetow
