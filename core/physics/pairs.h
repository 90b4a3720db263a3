#pragma once
// The broad phase: which parts may meet. Boxes cover the motion of the whole rest of the update, so that the trees are
// refilled only when a body leaves its box.

#include "core/physics/world_data.h"

namespace spacetow {

/// Lists the moving bodies and, when static bodies have changed, builds their tree anew.
void prepareStructure(WorldData& data);

/// Fills the trees and replaces `pairs`, sorted and unique; impulses of pairs that stay are kept.
void findPairs(WorldData& data, const IterationStep& step);

/// Whether the motion planned for this iteration stays within the boxes.
bool pairsCover(const WorldData& data);

} // namespace spacetow
