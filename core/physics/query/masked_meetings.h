#pragma once
// Who meets and passes through the other, because a mask says so.

#include "core/physics/world/world.h"

#include <utility>
#include <vector>

namespace spacetow {

/// Pairs of bodies that would be in contact where they are now, were it not for their masks; each once, the body that
/// was added first in front. Costs next to nothing where every mask meets every tag.
std::vector<std::pair<BodyId, BodyId>> maskedMeetings(const World& world);

} // namespace spacetow
