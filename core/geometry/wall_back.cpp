#include "core/geometry/wall_back.h"

namespace spacetow {

namespace {

constexpr double backSlack = 1e-6; // m, for rounding

void limit(WallBack& back, const Vec2& from, const Vec2& inward) {
    back.limits[static_cast<std::size_t>(back.count++)] = {inward, inward.dot(from) - backSlack};
}

/// `sense` is 1 at the start and −1 at the end of a wall. Returns the way along which the region goes on there.
Vec2 limitAt(WallBack& back, const WallSide& side, const WallEnd& end, double sense) {
    const Vec2& along = end.kind == WallEnd::Kind::Smooth ? end.nextDirection : side.direction;
    if (along.dot(side.direction) <= 0) { // there is more behind the joint than a half plane
        return -sense * side.direction;
    }
    limit(back, end.point, sense * along);
    return -leftOf(along);
}

} // namespace

bool WallBack::meets(const Aabb& box) const {
    for (int i = 0; i < count; ++i) {
        const auto& [inward, least] = limits[static_cast<std::size_t>(i)];
        const double x = inward.x() > 0 ? box.max.x() : box.min.x();
        const double y = inward.y() > 0 ? box.max.y() : box.min.y();
        if (!(inward.x() * x + inward.y() * y >= least)) {
            return false;
        }
    }
    return true;
}

WallBack backOf(const WallSide& side) {
    WallBack back;
    limit(back, side.start.point, -side.normal);
    back.first = limitAt(back, side, side.start, 1);
    back.last = limitAt(back, side, side.end, -1);
    return back;
}

} // namespace spacetow
