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
};

WallRun wallRun(const EdgeChain& chain, const Transform& pose);
/// Single edges strung together where one begins exactly where the one before ends.
std::vector<WallRun> wallRuns(std::span<const Shape> shapes, const Transform& pose);

/// The run without the points that lie within a pixel of the one before.
WallRun thinned(const Stage& stage, WallRun run);

/// Everything behind closed walls without a back: what lies outside anticlockwise loops and inside clockwise ones.
/// Empty when there is no such loop.
QPainterPath rockBehind(const Stage& stage, std::span<const WallRun> runs);

/// The solid side of each run in one colour, without darker spots at its corners.
void paintRims(const Stage& stage, std::span<const WallRun> runs, const QColor& color);
/// The walls themselves, with the painter's pen.
void paintWallLine(const Stage& stage, const WallRun& run);
/// A polyline with the painter's pen; what is out of view or finer than a pixel is left out.
void paintPolyline(const Stage& stage, std::span<const Vec2> points, bool closed);

} // namespace spacetow
