#pragma once
// Which of many points are at one place but for rounding. Metres.

#include "core/math/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace spacetow {

/// Ends of walls and corners of parts that are no further apart than this, in metres, meet. Coordinates that were
/// rounded to six decimals differ by up to 1.42e-6 m, those that were computed in another order by some 1e-12 m; what a
/// body could feel of such a gap is far below the slop of contacts.
constexpr double jointTolerance = 2e-6;

/// Where more of them meet than this, nothing is joined.
constexpr int jointCrowd = 200;

/// How far apart the ends of two sides may be and still meet: a hundredth of the shorter one at most, so that what is
/// smaller than the tolerance does not collapse.
inline double meetingDistance(double length, double otherLength) {
    return std::min(jointTolerance, 0.01 * std::min(length, otherLength));
}

class NearPoints {
  public:
    explicit NearPoints(std::span<const Vec2> points);

    /// Calls `visit(index)` for the points within the tolerance of `at`; false when they are a crowd, and not all of
    /// them were visited.
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

    // Borders of cells are where no grid that people draw on has its lines, so that few points are near one.
    static Cell cellOf(const Vec2& p) {
        constexpr double perMetre = 9973;
        constexpr double shift = 0.3719;
        return {wholeBelow(p.x() * perMetre + shift), wholeBelow(p.y() * perMetre + shift)};
    }
    static double wholeBelow(double x) { // std::floor, which is a call, for what fits in an integer
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
