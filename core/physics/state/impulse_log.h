#pragma once
// The log of contact impulses in one update, for explanations after the update. The simulation never reads the log, and
// no hash of a world includes the log.

#include "core/math/vec.h"
#include "core/physics/lanes/wide.h"

#include <cstdint>
#include <vector>

namespace spacetow {

/// The sums of the impulses of one contact over all iterations of an update. Impulses act on b, and opposite on a.
struct LoggedImpulse {
    Slot a = 0, b = 0;
    double normal = 0;      // N s, along the normal (from a to b) of each iteration
    double friction = 0;    // N s, along the tangent, to the left of the normal
    Vec2 normalOnB{0, 0};   // N s, vector sum of the normal impulses, world
    Vec2 frictionOnB{0, 0}; // N s, vector sum of the friction impulses, world
    double turnA = 0;       // N m s, angular impulse on a, about its centre of mass
    double turnB = 0;       // N m s, angular impulse on b, about its centre of mass
    Vec2 moment{0, 0};      // N s m: sum of normal impulse times contact point; divided by `normal`, the mean point
};

/// Off unless World::setRecordsImpulses turns the log on.
struct ImpulseLog {
    bool on = false;
    double seconds = 0;                  // duration of the last update, s
    std::vector<LoggedImpulse> impulses; // of the last update, in the order of their first impulses
    std::vector<std::uint32_t> places;   // by index in the contact pool: index in `impulses` + 1; 0 for none
    std::vector<std::uint32_t> placed;   // contacts whose entry in `places` is not 0
};

} // namespace spacetow
