#pragma once
// A regular quadtree for boxes that move: all leaves lie at depth ⌈log₄ n⌉ of the bounds halved again and again. Being
// regular it needs no nodes: a coordinate tells its leaf. Boxes are checked against earlier ones on their way in.

#include "core/math/aabb.h"

#include <cstdint>
#include <vector>

namespace spacetow {

class MovingQuadtree {
  public:
    /// Empties the tree and lays it out for about `count` boxes within `bounds`; boxes outside go to the leaves at the
    /// border. Keeps its memory: no allocation when it was as large before.
    void reset(const Aabb& bounds, std::uint32_t count);

    void insert(std::uint32_t number, const Aabb& box);

    /// Appends the numbers of the boxes inserted before that overlap `box`, borders included, each once; then inserts
    /// it.
    void insertAndQuery(std::uint32_t number, const Aabb& box, std::vector<std::uint32_t>& out);

    int depth() const { return m_depth; }
    /// The rectangles of the leaves that hold a box.
    std::vector<Aabb> cells() const;

  private:
    static constexpr std::uint32_t none = 0xffffffffu;
    struct Entry {
        std::uint32_t number;
        std::uint32_t next; // in the same leaf
        Aabb box;
    };
    std::uint32_t column(double x) const { return cellAlong(0, x); }
    std::uint32_t row(double y) const { return cellAlong(1, y); }
    std::uint32_t cellAlong(int axis, double coordinate) const;

    Aabb m_bounds;
    Vec2 m_perMeter{0, 0}; // leaves a metre
    int m_depth = 0;
    std::uint32_t m_side = 1;            // leaves along each axis
    std::vector<std::uint32_t> m_leaves; // first entry of each
    std::vector<Entry> m_entries;
};

} // namespace spacetow
