#pragma once
// What contacts have given in an update, for whoever explains it afterwards. Nothing in the engine reads it, and no
// hash knows of it.

#include "core/math/vec.h"
#include "core/physics/lanes/wide.h"

#include <cstdint>
#include <vector>

namespace spacetow {

/// The impulses of one contact, over the iterations of an update. SI units.
struct LoggedImpulse {
    Slot a = 0, b = 0;
    double normal = 0;      // N s, along the normals of the iterations
    double friction = 0;    // N s, to the left of them
    Vec2 normalOnB{0, 0};   // N s, the normal impulses as one
    Vec2 frictionOnB{0, 0}; // N s, likewise those of friction
    double turnA = 0;       // N m s that a gets about its centre of mass
    double turnB = 0;       // likewise b
    Vec2 moment{0, 0};      // N s m: the points, weighted by the normal impulses there
};

struct ImpulseLog {
    bool on = false;
    double seconds = 0;                  // of the last update
    std::vector<LoggedImpulse> impulses; // of the last update, in the order in which they began
    std::vector<std::uint32_t> places;   // by contact: its place there and one; 0 for none
    std::vector<std::uint32_t> placed;   // contacts that have one
};

} // namespace spacetow
