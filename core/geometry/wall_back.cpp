#include "core/geometry/wall_back.h"

#include <vector>

namespace spacetow {

namespace {

constexpr double backSlack = 1e-6; // m, for rounding

void limit(WallBack& back, const Vec2& from, const Vec2& inward) {
    back.limits[static_cast<std::size_t>(back.count++)] = {inward, inward.dot(from) - backSlack};
}

/// `sense` is 1 at the start and −1 at the end of a wall.
void limitAt(WallBack& back, const WallSide& side, const WallEnd& end, double sense) {
    if (end.kind != WallEnd::Kind::Smooth) {
        limit(back, end.point, sense * side.direction);
    } else if (end.nextDirection.dot(side.direction) > 0) { // else there is more behind the joint than a half plane
        limit(back, end.point, sense * end.nextDirection);
    }
}

/// The corners of what of the outline is inside the limit (Sutherland and Hodgman, 1974).
std::vector<Vec2> clipped(const std::vector<Vec2>& outline, const WallBack::Limit& limit) {
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2& p = outline[i];
        const Vec2& q = outline[(i + 1) % outline.size()];
        const double atP = limit.inward.dot(p) - limit.least;
        const double atQ = limit.inward.dot(q) - limit.least;
        if (atP >= 0) {
            result.push_back(p);
        }
        if ((atP >= 0) != (atQ >= 0)) {
            result.emplace_back(p + atP / (atP - atQ) * (q - p));
        }
    }
    return result;
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

Aabb WallBack::within(const Aabb& area) const {
    Aabb box;
    if (area.isEmpty()) {
        return box;
    }
    std::vector<Vec2> outline{area.min, {area.max.x(), area.min.y()}, area.max, {area.min.x(), area.max.y()}};
    for (int i = 0; i < count; ++i) {
        outline = clipped(outline, limits[static_cast<std::size_t>(i)]);
    }
    for (const Vec2& p : outline) {
        box.include(p);
    }
    return box;
}

WallBack backOf(const WallSide& side) {
    WallBack back;
    limit(back, side.start.point, -side.normal);
    limitAt(back, side, side.start, 1);
    limitAt(back, side, side.end, -1);
    return back;
}

} // namespace spacetow
