#pragma once
// Data of the broad phase: proxies, and runs of the pair table.

#include "core/physics/lanes/wide.h"

#include <cstdint>

namespace spacetow {

/// One part of a moving or sleeping body in the broad phase.
struct MovingProxy {
    Slot body;
    std::uint32_t part;
    bool slender = false;       // a long part: most of its AABB is empty
    bool movedProxy = false;    // the body has left its fat AABB; set only while the broad phase searches
    bool isStaleInTree = false; // the tree still holds an older AABB of the part
};

/// A run of consecutive pairs that stay consecutive when the pair table changes.
struct Run {
    std::uint32_t begin = 0, end = 0; // indices in the old table, without `end`
    std::uint32_t to = 0;             // index of the first pair in the new table
};

} // namespace spacetow
