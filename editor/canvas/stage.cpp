#include "editor/canvas/stage.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// Narrows [first, last] to the part of a line, from + t * way, that lies between two bounds in one axis.
void narrow(double& first, double& last, double from, double way, const Vec2& bounds) {
    if (way == 0) {
        last = from < bounds.x() || from > bounds.y() ? first : last;
        return;
    }
    const double in = (bounds.x() - from) / way;
    const double out = (bounds.y() - from) / way;
    first = std::max(first, std::min(in, out));
    last = std::min(last, std::max(in, out));
}

} // namespace

void paintDashed(const Stage& stage, const Vec2& a, const Vec2& b, const Dashes& dashes) {
    constexpr double pens = 8; // px around the view
    const Vec2 from = stage.view.toScreen(a);
    const Vec2 way = stage.view.toScreen(b) - from;
    const double length = way.norm();
    if (!(length > 0) || !std::isfinite(length)) {
        return;
    }
    const Vec2 along = way / length;
    double first = 0;
    double last = length;
    narrow(first, last, from.x(), along.x(), {-pens, stage.view.size.x() + pens});
    narrow(first, last, from.y(), along.y(), {-pens, stage.view.size.y() + pens});
    const double period = dashes.dash + dashes.gap;
    for (double start = std::floor(first / period) * period; start < last; start += period) {
        const Vec2 p = from + start * along;
        const Vec2 q = from + std::min(start + dashes.dash, length) * along;
        stage.painter.drawLine(QPointF(p.x(), p.y()), QPointF(q.x(), q.y()));
    }
}

} // namespace spacetow
