#include "editor/exchange/svg_arc.h"

#include "core/math/rot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

std::optional<PathPiece> svgArc(const Vec2& from, const Vec2& to, const SvgArc& arc) {
    if (from == to) {
        return {};
    }
    Vec2 radii(std::abs(arc.radiusX), std::abs(arc.radiusY));
    if (!(radii.x() > 0 && radii.y() > 0)) {
        return LinePiece{to};
    }
    const Rot turn = Rot::fromAngle(std::fmod(arc.degrees, 360) * std::numbers::pi / 180);
    // In the frame of the ellipse, from the middle of the chord, with the ellipse as the unit circle.
    const Vec2 half = turn.inverse() * Vec2((from - to) / 2);
    Vec2 a = half.cwiseQuotient(radii);
    if (a.norm() > 1) {
        radii *= a.norm();
        a /= a.norm();
    }
    const double rest = std::sqrt(std::max(0.0, 1 - a.squaredNorm()));
    const double chord = a.norm();
    if (!(chord > 0)) {
        return LinePiece{to}; // an ellipse so large that the arc is straight
    }
    const double side = arc.large == arc.sweep ? -1 : 1;
    const Vec2 center = side * rest / chord * Vec2(a.y(), -a.x());
    const Vec2 first = a - center;
    const Vec2 last = -a - center;
    constexpr double full = 2 * std::numbers::pi;
    const double begin = arcTangent(first.y(), first.x());
    double sweep = arcTangent(last.y(), last.x()) - begin;
    if (arc.sweep && sweep < 0) {
        sweep += full;
    } else if (!arc.sweep && sweep > 0) {
        sweep -= full;
    }
    const Vec2 middle = (from + to) / 2 + turn * Vec2(center.cwiseProduct(radii));
    return ArcPiece{middle, radii.x() * turn.right(), radii.y() * turn.up(), begin, sweep, to};
}

} // namespace spacetow
