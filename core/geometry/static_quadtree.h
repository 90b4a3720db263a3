#pragma once
// A quadtree over static boxes. Split points are chosen from the boxes. A box is stored in every leaf that it overlaps.
// Subdivision ends when three levels have not reduced the boxes of a node, or when boxes are stored too many times.
// Equal boxes give equal trees.

#include "core/math/aabb.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spacetow {

class StaticQuadtree {
  public:
    StaticQuadtree() = default;
    /// Empty boxes keep their index but are never found. O(n log n), unless many boxes lie on each other.
    explicit StaticQuadtree(std::vector<Aabb> boxes);

    /// Appends the indices of the boxes that overlap `area`, borders included, each once and always in the same order.
    void query(const Aabb& area, std::vector<std::uint32_t>& out) const;

    const std::vector<Aabb>& boxes() const { return m_boxes; }
    /// The rectangles of the leaves, clipped to the bounds of all boxes.
    std::vector<Aabb> cells() const;
    /// Levels below the root; 0 for a tree that is one leaf.
    int depth() const { return m_depth; }
    /// The sum over all leaves of the boxes stored in the leaf.
    std::size_t held() const { return m_items.size(); }

  private:
    struct Node {
        Vec2 middle{0, 0};
        std::uint32_t first = 0; // first of four children, or of the leaf's items
        std::uint32_t count = 0; // items of a leaf
        bool leaf = true;
    };
    struct Builder;

    std::vector<Aabb> m_boxes;
    Aabb m_bounds;
    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_items; // leaf by leaf
    std::vector<Aabb> m_itemBoxes;      // by item, so that a query reads memory in order
    int m_depth = 0;
};

} // namespace spacetow
