#pragma once
// Finds points that coincide within rounding errors. Metres.

#include "core/math/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace spacetow {

/// Ends of walls, and corners of parts, that are no further apart than this are joined, m. Coordinates rounded to six
/// decimals differ by up to 1.42e-6 m, coordinates computed in another order by about 1e-12 m. A gap of this size is
/// far below linearSlop.
constexpr double jointTolerance = 2e-6;

/// If more than this many points coincide, none of them is joined.
constexpr int jointCrowd = 200;

/// The joint tolerance for the ends of two sides, m: at most a hundredth of the shorter one, so that the two ends of a
/// tiny side do not coincide.
inline double meetingDistance(double length, double otherLength) {
    return std::min(jointTolerance, 0.01 * std::min(length, otherLength));
}

class NearPoints {
  public:
    explicit NearPoints(std::span<const Vec2> points);

    /// Calls `visit(index)` for the points within the tolerance of `at`. Returns false, without visiting all of them,
    /// if there are more than `jointCrowd`.
    template <class Visit>
    bool visit(const Vec2& at, const Visit& visit) const {
        const Cell low = cellOf(at - Vec2(jointTolerance, jointTolerance));
        const Cell high = cellOf(at + Vec2(jointTolerance, jointTolerance));
        int count = 0;
        for (double x = low.x; x <= high.x; ++x) {
            for (double y = low.y; y <= high.y; ++y) {
                const auto first = std::lower_bound(m_entries.begin(), m_entries.end(), Cell{x, y});
                for (auto it = first; it != m_entries.end() && it->cell == Cell{x, y}; ++it) {
                    if ((it->point - at).squaredNorm() > jointTolerance * jointTolerance) {
                        continue;
                    }
                    if (++count > jointCrowd) {
                        return false;
                    }
                    visit(it->index);
                }
            }
        }
        return true;
    }

  private:
    struct Cell {
        double x, y; // whole numbers
        bool operator==(const Cell&) const = default;
        bool operator<(const Cell& o) const { return x != o.x ? x < o.x : y < o.y; }
    };
    struct Entry {
        Cell cell;
        Vec2 point;
        std::uint32_t index;
        bool operator<(const Cell& o) const { return cell < o; }
    };

    // A grid that no level design grid coincides with, so that few points lie on the border of two cells.
    static Cell cellOf(const Vec2& p) {
        constexpr double perMetre = 9973;
        constexpr double shift = 0.3719;
        return {wholeBelow(p.x() * perMetre + shift), wholeBelow(p.y() * perMetre + shift)};
    }
    static double wholeBelow(double x) { // std::floor without a library call
        if (!(std::abs(x) < 1e18)) {
            return x;
        }
        const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
        return whole > x ? whole - 1 : whole;
    }

    std::vector<Entry> m_entries;
};

inline NearPoints::NearPoints(std::span<const Vec2> points) {
    m_entries.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        m_entries.push_back({cellOf(points[i]), points[i], static_cast<std::uint32_t>(i)});
    }
    std::sort(m_entries.begin(), m_entries.end(),
              [](const Entry& a, const Entry& b) { return a.cell == b.cell ? a.index < b.index : a.cell < b.cell; });
}

} // namespace spacetow
