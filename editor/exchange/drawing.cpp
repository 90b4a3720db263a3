#include "editor/exchange/drawing.h"

#include "core/base/overloaded.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

Vec2 endOf(const DrawnPath& path) {
    if (path.pieces.empty()) {
        return path.start;
    }
    return std::visit([](const auto& piece) -> Vec2 { return piece.to; }, path.pieces.back());
}

DrawnPath mapped(const DrawnPath& path, const Affine& map) {
    DrawnPath out{map(path.start), {}, path.closed};
    out.pieces.reserve(path.pieces.size());
    const Overloaded mappedPiece{[&map](const LinePiece& line) -> PathPiece { return LinePiece{map(line.to)}; },
                                 [&map](const CubicPiece& cubic) -> PathPiece {
                                     return CubicPiece{map(cubic.control1), map(cubic.control2), map(cubic.to)};
                                 },
                                 [&map](const ArcPiece& arc) -> PathPiece {
                                     return ArcPiece{map(arc.center), map.linear(arc.u), map.linear(arc.v),
                                                     arc.from,        arc.sweep,         map(arc.to)};
                                 }};
    for (const PathPiece& piece : path.pieces) {
        out.pieces.push_back(std::visit(mappedPiece, piece));
    }
    return out;
}

DrawnPath ellipsePath(const Vec2& center, const Vec2& u, const Vec2& v) {
    const Vec2 start = center + u;
    return {start, {ArcPiece{center, u, v, 0, 2 * std::numbers::pi, start}}, true};
}

DrawnPath polygonPath(std::vector<Vec2> points, bool closed) {
    DrawnPath path;
    path.closed = closed;
    if (!points.empty()) {
        path.start = points.front();
        std::for_each(points.begin() + 1, points.end(),
                      [&path](const Vec2& point) { path.pieces.emplace_back(LinePiece{point}); });
    }
    return path;
}

std::optional<double> similarityOf(const Affine& map) {
    constexpr double slack = 1e-9;
    const double x = map.x.norm();
    const double y = map.y.norm();
    const bool keepsCircles = x > 0 && std::abs(x - y) <= slack * x && std::abs(map.x.dot(map.y)) <= slack * x * y;
    return keepsCircles ? std::optional(x) : std::nullopt;
}

} // namespace spacetow
