#pragma once
// The time of impact of moving parts. Metres and radians; times are fractions of a motion, 0 … 1.

#include "core/geometry/part.h"
#include "core/math/transform.h"

#include <optional>

namespace spacetow {

/// A pose that changes at constant speed: the point `pivot` of the part moves straight by `translation` while all else
/// turns round it by `turn`, which may be many turns.
struct Sweep {
    Transform start;
    Vec2 translation{0, 0}; // m
    double turn = 0;        // rad
    Vec2 pivot{0, 0};       // local; the centre of mass of a free body

    Transform at(double fraction) const;
};

/// The first fraction at which the parts have come within `targetGap` metres (> 0) of each other and still approach;
/// 0 when they are that near from the start. Nothing when they never are, or only while at rest or moving apart.
/// The gap left may be a quarter smaller than asked for, and an approach that comes no nearer than that may be missed:
/// nothing ever gets through. One-way walls are met from the front, by what has its centre in
/// front of them at the start; their free ends are met from everywhere. Where walls are joined, contacts that slide
/// across are none. Conservative advancement (Mirtich, 1996) with support planes.
std::optional<double> timeOfImpact(const Part& a, const Sweep& motionA, const Part& b, const Sweep& motionB,
                                   double targetGap);

/// The same where one of the parts is a wall whose face is open for the other: its free ends only.
std::optional<double> timeOfImpactAtOpenWall(const Part& a, const Sweep& motionA, const Part& b, const Sweep& motionB,
                                             double targetGap);

} // namespace spacetow
