#pragma once
// Whether two parts meet at all, for sensors: bodies that are felt without exerting a force.

#include "core/geometry/cast.h"
#include "core/geometry/part.h"
#include "core/math/transform.h"

namespace spacetow {

/// Whether a sensor feels the other: the parts meet anywhere, walls from either side and with one another included, or
/// collide() would let them touch at a margin of 0.
bool overlaps(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB);

/// A motion about the origin of the part, whose end is known to the bit.
struct ExactSweep {
    Sweep motion;
    Transform end;

    explicit ExactSweep(const Transform& resting) : motion{.start = resting}, end(resting) {}
    ExactSweep(const Sweep& m, const Transform& e) : motion(m), end(e) {}
    Transform at(double fraction) const { return fraction < 1 ? motion.at(fraction) : end; }
};

/// Whether parts that do not overlap at the ends of their ways do so in between; also walls that pass through each
/// other flat. Where one way ends and the next begins with the same bits, no crossing is missed or found twice. May
/// miss what overlaps by less than 1e-8 m, and a graze of bodies that turn several times. Conservative advancement.
bool overlapsDuring(const Part& a, const ExactSweep& wayA, const Part& b, const ExactSweep& wayB);

} // namespace spacetow
