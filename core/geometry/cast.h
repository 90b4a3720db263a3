#pragma once
// The time of impact of moving parts. Metres and radians; times are fractions of a motion, 0 … 1.

#include "core/geometry/part.h"
#include "core/math/transform.h"

#include <optional>

namespace spacetow {

/// A motion at constant velocity: the point `pivot` of the part moves along a line by `translation`, and the part turns
/// about it by `turn`, which may be more than a full turn.
struct Sweep {
    Transform start;
    Vec2 translation{0, 0}; // m
    double turn = 0;        // rad
    Vec2 pivot{0, 0};       // local; the centre of mass of a free body

    Transform at(double fraction) const;
};

/// The first fraction at which the distance of the parts is `targetGap` metres (> 0) and decreasing; 0 if they are that
/// near from the start. None if that never happens. The distance at that time may be a quarter smaller than
/// `targetGap`, and an approach that comes no nearer may be missed; no part ever passes through another one. One-way
/// walls stop parts whose centre is in front of the wall at the start; free ends of walls stop all parts. A part that
/// slides across the joint of two walls is not stopped. Conservative advancement (Mirtich, 1996) with support planes.
std::optional<double> timeOfImpact(const Part& a, const Sweep& motionA, const Part& b, const Sweep& motionB,
                                   double targetGap);

/// The same if one of the parts is a wall that is open for the other: only the free ends of the wall stop it.
std::optional<double> timeOfImpactAtOpenWall(const Part& a, const Sweep& motionA, const Part& b, const Sweep& motionB,
                                             double targetGap);

} // namespace spacetow
