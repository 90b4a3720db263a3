#pragma once
// The sleeping bodies and their pairs; see sleep.h.

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

/// The sleeping bodies, and the data that replaces their place in the lists of the update.
struct Sleep {
    bool allowed = false;                 // see World::setSleeping
    Vec2 gravity{0, 0};                   // m/s², of the last update; another gravity wakes all
    std::vector<Slot> sleepers;           // sorted
    std::vector<Slot> wakeRequests;       // bodies since the last update, see requestWake()
    PairTable table;                      // pairs of two sleeping bodies, or of a sleeping and a static one
    std::vector<TouchedTags> touchedTags; // of the bodies in `table`; sorted by body
};

} // namespace spacetow
