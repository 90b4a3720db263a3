#pragma once
// The elliptical arcs of SVG paths, which are told by their ends.

#include "editor/exchange/drawing.h"

namespace spacetow {

struct SvgArc {
    double radiusX, radiusY;
    double degrees; // by which the ellipse is turned
    bool large, sweep;
};

/// The arc as SVG 1.1, F.6, tells: radii that are too small grow, one of zero makes a line. Nothing for an arc that
/// ends where it begins.
std::optional<PathPiece> svgArc(const Vec2& from, const Vec2& to, const SvgArc& arc);

} // namespace spacetow
