#pragma once
// Paints one-way walls so that anyone sees which side is solid: a band on the solid side, as deep as the wall, or
// fading out where the wall has no back; behind closed walls without a back lies rock. World coordinates, metres.

#include "core/level/level.h"
#include "core/math/transform.h"
#include "editor/canvas/stage.h"

#include <QPainterPath>

#include <span>
#include <vector>

namespace spacetow {

/// Walls joined end to end, solid on the right on the way from point to point.
struct WallRun {
    std::vector<Vec2> points; // world
    bool closed = false;
    double depth = noBack; // m
    bool hollow = false;   // closed anticlockwise: what is behind it lies outside
};

/// Single edges strung together where one begins exactly where the one before ends.
std::vector<WallRun> wallRuns(std::span<const Shape> shapes, const Transform& pose);

/// The run without the points that are not missed at this zoom.
WallRun thinned(const Stage& stage, WallRun run);
/// How far from where it is an outline may be painted, m.
double finestDetail(const Stage& stage);

/// How far the band of a wall without a back reaches, m.
constexpr double fadeDepth = 0.45;

/// Walls of which the points may be left out that have nothing to do with what is in view.
struct Ground {
    std::vector<WallRun> runs;
    bool hollow = false; // of all closed walls without a back, in view or not, one is
};

/// Everything behind closed walls without a back: what lies outside anticlockwise loops and inside clockwise ones.
/// Empty when there is no such loop.
QPainterPath rockBehind(const Stage& stage, const Ground& ground);

/// How many times the band of a wall without a back is filled, one over the other, at this zoom (pixels a metre).
int rimLayers(double scale);
/// The solid side of each run in one colour, without darker spots at its corners.
void paintRims(const Stage& stage, std::span<const WallRun> runs, const QColor& color);
/// Likewise of static walls that can be touched, in the colour of the ground; what lies behind closed walls stays in
/// their rock.
void paintGroundRims(const Stage& stage, const Ground& ground);
/// A polyline with the painter's pen; what is out of view is left out.
void paintPolyline(const Stage& stage, std::span<const Vec2> points, bool closed);

} // namespace spacetow
