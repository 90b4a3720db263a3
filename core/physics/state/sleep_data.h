#pragma once
// Who sleeps; see sleep.h.

#include "core/math/vec.h"
#include "core/physics/def/tags.h"
#include "core/physics/state/contact_data.h"

#include <cstdint>
#include <vector>

namespace spacetow {

/// The tags that a body touches.
struct TouchedTags {
    Slot body;
    TagMask tags;
};

/// Who sleeps, and what is kept for them. Empty while nobody does.
struct Sleep {
    bool allowed = false;
    Vec2 gravity{0, 0};                   // under which they fell asleep
    std::vector<Slot> sleepers;           // sorted
    std::vector<Slot> wakeRequests;       // since the last update
    PairTable table;                      // pairs of sleepers, with each other and with static bodies
    std::vector<TouchedTags> touchedTags; // of those pairs; sorted
};

} // namespace spacetow
