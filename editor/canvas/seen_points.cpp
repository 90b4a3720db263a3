#include "editor/canvas/seen_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spacetow {

namespace {

/// The directions from a point in which a line passes all that it should within some distance. Angles are kept as
/// vectors, so that none is computed; narrower than half a turn.
class Sleeve {
  public:
    /// A point may be so far from the line on its side and beyond its end at once.
    Sleeve(const Vec2& from, double tolerance) : m_from(from), m_tolerance(tolerance / std::numbers::sqrt2) {}

    /// Whether a line from the point to `to` passes all points so far; if so, `to` becomes one of them.
    bool admits(const Vec2& to) {
        const Vec2 way = to - m_from;
        const double distance = way.norm();
        if (distance <= m_tolerance) {
            return !m_cone; // a line that turns back would leave out a point further away
        }
        if (m_cone && (cross(m_right, way) < 0 || cross(way, m_left) < 0 || way.dot(m_right + m_left) < 0)) {
            return false;
        }
        if (distance + m_tolerance < m_furthest) {
            return false;
        }
        m_furthest = std::max(m_furthest, distance);
        narrow(way, distance);
        return true;
    }

  private:
    void narrow(const Vec2& way, double distance) {
        const double sine = m_tolerance / distance;
        const double cosine = std::sqrt(1 - sine * sine);
        const Vec2 left(way.x() * cosine - way.y() * sine, way.x() * sine + way.y() * cosine);
        const Vec2 right(way.x() * cosine + way.y() * sine, way.y() * cosine - way.x() * sine);
        m_left = m_cone && cross(left, m_left) < 0 ? m_left : left;
        m_right = m_cone && cross(m_right, right) < 0 ? m_right : right;
        m_cone = true;
    }

    Vec2 m_from;
    double m_tolerance;
    double m_furthest = 0;
    bool m_cone = false;
    Vec2 m_left{0, 0}, m_right{0, 0};
};

/// The area in the coordinates of the outline.
Aabb localArea(const SeenOutline& outline, const Aabb& box) {
    Aabb local;
    for (const Vec2& corner : {box.min, box.max, Vec2(box.min.x(), box.max.y()), Vec2(box.max.x(), box.min.y())}) {
        local.include(outline.pose.toLocal(corner));
    }
    return local;
}

} // namespace

std::vector<Vec2> simplified(std::span<const Vec2> points, double tolerance) {
    std::vector<Vec2> kept;
    if (points.empty()) {
        return kept;
    }
    kept.push_back(points.front());
    std::optional<Sleeve> sleeve;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!sleeve) {
            sleeve.emplace(kept.back(), tolerance);
        }
        if (!sleeve->admits(points[i])) {
            kept.push_back(points[i - 1]);
            sleeve.emplace(kept.back(), tolerance);
            sleeve->admits(points[i]);
        }
    }
    if (points.size() > 1) {
        kept.push_back(points.back());
    }
    return kept;
}

std::vector<Vec2> seenPoints(const SeenOutline& outline, const SeenArea& area) {
    const int count = static_cast<int>(outline.points.size());
    std::vector<Vec2> seen;
    if (outline.tree == nullptr || outline.tree->segments() == 0) {
        seen.reserve(outline.points.size());
        for (const Vec2& point : outline.points) {
            seen.push_back(outline.pose.toWorld(point));
        }
        return seen;
    }
    // What is left out depends on the block alone and not on the area, so that neighbouring areas fit together.
    constexpr int block = SegmentTree::stretch * SegmentTree::stretch;
    std::vector<Vec2> inBlock;
    const auto finishBlock = [&](bool last) {
        const std::vector<Vec2> kept = simplified(inBlock, area.finest);
        seen.insert(seen.end(), kept.begin(), kept.end() - (last ? 0 : 1));
        inBlock.erase(inBlock.begin(), inBlock.end() - 1);
    };
    const auto add = [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            inBlock.push_back(outline.pose.toWorld(outline.points[static_cast<std::size_t>(i)]));
            if (i % block == 0 && i > 0) {
                finishBlock(false);
            }
        }
    };
    const Aabb local = localArea(outline, area.box.grown(area.finest)); // for rounding
    const auto enter = [&](const Aabb& box, int first, int end) {
        // What does not overlap the area lies on one side of it, and so does the line across it.
        const bool outside = end - first > SegmentTree::stretch && !local.overlaps(box);
        if (!outside && box.size().norm() > area.finest) {
            return true;
        }
        add(first, first + 1);
        return false;
    };
    outline.tree->descend(enter, add);
    if (!outline.closed) {
        add(count - 1, count);
    }
    finishBlock(true);
    return seen;
}

} // namespace spacetow
