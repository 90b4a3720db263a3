#include "core/geometry/polygon.h"

#include "core/base/contract.h"
#include "core/geometry/intersect.h"
#include "core/math/aabb.h"
#include "core/math/trig.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace spacetow {

namespace {

struct Side {
    Vec2 a, b;
    double minX, maxX;
    std::size_t index;
};

bool areNeighbours(std::size_t i, std::size_t j, std::size_t count) {
    return (i + 1) % count == j || (j + 1) % count == i;
}

/// Sides that share a vertex may not fold back over one another.
bool foldBack(const Side& s, const Side& t) {
    const Side& first = s.b == t.a ? s : t;
    const Side& second = s.b == t.a ? t : s;
    const Vec2 u = first.b - first.a;
    const Vec2 v = second.b - second.a;
    return cross(u, v) == 0 && u.dot(v) < 0;
}

bool sidesClash(const Side& s, const Side& t, std::size_t count) {
    const bool yApart = std::max(s.a.y(), s.b.y()) < std::min(t.a.y(), t.b.y()) ||
                        std::max(t.a.y(), t.b.y()) < std::min(s.a.y(), s.b.y());
    if (yApart) {
        return false;
    }
    return areNeighbours(s.index, t.index, count) ? foldBack(s, t) : segmentsMeet(s.a, s.b, t.a, t.b);
}

} // namespace

double signedArea(std::span<const Vec2> outline) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        // Measured from the first vertex, so that outlines far from the origin lose no digits.
        twice += cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
    }
    return 0.5 * twice;
}

Vec2 centroid(std::span<const Vec2> outline) {
    EXPECTS(!outline.empty());
    Vec2 weighted(0, 0);
    Vec2 sum(0, 0);
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 p = outline[i] - outline[0];
        const Vec2 q = outline[(i + 1) % outline.size()] - outline[0];
        const double c = cross(p, q);
        twice += c;
        weighted += c * (p + q);
        sum += p;
    }
    const Vec2 fromFirst = weighted / (3 * twice);
    return outline[0] + (isFinite(fromFirst) ? fromFirst : Vec2(sum / static_cast<double>(outline.size())));
}

bool isSimple(std::span<const Vec2> outline) {
    const std::size_t count = outline.size();
    if (count < 3) {
        return false;
    }
    std::vector<Side> sides(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2& a = outline[i];
        const Vec2& b = outline[(i + 1) % count];
        if (!isFinite(a) || a == b) {
            return false;
        }
        sides[i] = {a, b, std::min(a.x(), b.x()), std::max(a.x(), b.x()), i};
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& s, const Side& t) { return s.minX != t.minX ? s.minX < t.minX : s.index < t.index; });
    std::vector<Side> open; // those that reach the current x
    for (const Side& side : sides) {
        std::erase_if(open, [&](const Side& other) { return other.maxX < side.minX; });
        for (const Side& other : open) {
            if (sidesClash(side, other, count)) {
                return false;
            }
        }
        open.push_back(side);
    }
    return true;
}

bool contains(std::span<const Vec2> outline, const Vec2& p) {
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2& a = outline[j];
        const Vec2& b = outline[i];
        if ((a.y() >= p.y()) != (b.y() >= p.y())) {
            const double side = cross(b - a, p - a);
            inside ^= (b.y() > a.y()) == (side > 0);
        }
    }
    return inside;
}

double incircleRadius(std::span<const Vec2> outline, const Vec2& center) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 nearest = closestOnSegment(outline[i], outline[(i + 1) % outline.size()], center);
        smallest = std::min(smallest, (nearest - center).squaredNorm());
    }
    return std::sqrt(smallest);
}

double outerRadius(std::span<const Vec2> outline, const Vec2& center) {
    double largest = 0;
    for (const Vec2& vertex : outline) {
        largest = std::max(largest, (vertex - center).squaredNorm());
    }
    return std::sqrt(largest);
}

std::optional<Vec2> outlinePoint(std::span<const Vec2> outline, const Vec2& from, const Vec2& direction) {
    Aabb bounds;
    bounds.include(from);
    for (const Vec2& vertex : outline) {
        bounds.include(vertex);
    }
    const double length = direction.norm();
    if (!(length > 0)) {
        return std::nullopt;
    }
    const Vec2 to = from + direction * (2 * bounds.size().norm() / length);
    std::optional<double> first;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto hit = segmentFraction(from, to, outline[i], outline[(i + 1) % outline.size()]);
        if (hit && (!first || *hit < *first)) {
            first = hit;
        }
    }
    return first ? std::optional<Vec2>(from + *first * (to - from)) : std::nullopt;
}

std::vector<Vec2> regularPolygon(int count, double radius) {
    EXPECTS(count >= 3 && radius > 0);
    std::vector<Vec2> vertices;
    vertices.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const SinCos turn = sinCos(2 * std::numbers::pi * i / count);
        vertices.emplace_back(-radius * turn.sin, radius * turn.cos);
    }
    return vertices;
}

} // namespace spacetow
