#pragma once
// A regular loose quadtree for moving boxes, of depth ⌈log₄ n⌉. All levels are regular grids, so there are no nodes:
// the cell of a point is computed from its coordinates. A box is stored once, in the cell of its lower corner, at the
// deepest level whose cells are no smaller than the box; it may overlap neighbouring cells. The cells of a row are
// contiguous in memory. T. Ulrich, "Loose Octrees", Game Programming Gems (2000).

#include "core/math/aabb.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace spacetow {

class MovingQuadtree {
  public:
    /// Replaces the contents by these boxes, numbered in their order. O(n). Allocates only if it has never been as
    /// large.
    void fill(std::span<const Aabb> boxes);

    /// Appends the numbers of the boxes that overlap `area`, borders included, each once and always in the same order.
    void query(const Aabb& area, std::vector<std::uint32_t>& out) const;

    /// Two boxes, by number.
    struct BoxPair {
        std::uint32_t a, b;
    };
    /// Appends all pairs of boxes that overlap, borders included, each once and always in the same order. Costs less
    /// than a query for every box. Stops some time after `most` pairs.
    void queryAll(std::vector<BoxPair>& out, std::size_t most = std::numeric_limits<std::size_t>::max()) const;

    int depth() const { return m_depth; }
    /// The cells that a box of their level overlaps.
    std::vector<Aabb> cells() const;

  private:
    static constexpr int maxDepth = 10; // a million leaves
    struct Entry {
        Aabb box;
        std::uint32_t number;
    };
    struct Level {
        std::uint32_t count = 0; // of boxes
        std::uint32_t side = 1;  // cells along each axis
        std::uint32_t first = 0; // of its cells in m_starts
        Vec2 perMeter{0, 0};     // cells a metre
        Vec2 largest{0, 0};      // size of its boxes
    };
    /// Of a level's cells.
    struct Range {
        std::uint32_t left, right, bottom, top;
    };
    struct Entries {
        std::uint32_t first, end;
    };
    std::uint32_t cellAlong(const Level& level, int axis, double coordinate) const;
    Range rangeFor(const Level& level, const Aabb& area) const;
    Entries entriesIn(const Level& level, std::uint32_t row, const Range& range) const;
    /// The result of queryAll(), and its limit.
    struct Found {
        std::vector<BoxPair>& all;
        std::size_t most;
    };
    void appendOverlapping(const Entry& entry, Entries with, const Found& found) const;
    void appendLater(const Level& level, std::uint32_t row, const Found& found) const;
    int levelFor(const Aabb& box) const;
    void layOut(std::span<const Aabb> boxes);

    Aabb m_bounds;
    int m_depth = 0;
    std::array<Level, maxDepth + 1> m_levels;
    std::vector<std::uint8_t> m_levelOf; // by number
    std::vector<std::uint32_t> m_cellOf; // by number, while it is filled
    std::vector<std::uint32_t> m_starts; // by cell: its first entry; those end where the next cell's start
    std::vector<Entry> m_entries;
};

} // namespace spacetow
