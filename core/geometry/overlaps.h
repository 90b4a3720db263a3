#pragma once
// Overlap tests for sensors.

#include "core/geometry/cast.h"
#include "core/geometry/part.h"
#include "core/math/transform.h"

namespace spacetow {

/// Whether a sensor detects the other part: the parts overlap, where a wall is a segment, or collide() with a margin of
/// 0 finds a contact. Two walls may overlap.
bool overlaps(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB);

/// A sweep about the origin of the part whose final pose is given, so that the next sweep begins with the same bits.
struct ExactSweep {
    Sweep motion;
    Transform end;

    explicit ExactSweep(const Transform& resting) : motion{.start = resting}, end(resting) {}
    ExactSweep(const Sweep& m, const Transform& e) : motion(m), end(e) {}
    Transform at(double fraction) const { return fraction < 1 ? motion.at(fraction) : end; }
};

/// Whether parts that overlap at neither end of their sweeps overlap in between, including two walls that pass through
/// each other while parallel. If a sweep begins with the bits of the end of the last one, no crossing is missed or
/// found twice. May miss an overlap of less than 1e-8 m, and a short overlap of bodies that turn several times.
/// Conservative advancement.
bool overlapsDuring(const Part& a, const ExactSweep& wayA, const Part& b, const ExactSweep& wayB);

} // namespace spacetow
