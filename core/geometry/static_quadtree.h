#pragma once
// A quadtree over boxes that do not move. Its split points come from the boxes themselves, a box is held by every
// quadrant it straddles, and a branch ends where three levels brought no fewer boxes, or where each is held many times
// by now. The same boxes give the same tree.

#include "core/math/aabb.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spacetow {

class StaticQuadtree {
  public:
    StaticQuadtree() = default;
    /// Empty boxes are held but never found. O(n log n) for boxes that can be told apart.
    explicit StaticQuadtree(std::vector<Aabb> boxes);

    /// Appends the indices of the boxes that overlap `area`, borders included, each once and always in the same order.
    void query(const Aabb& area, std::vector<std::uint32_t>& out) const;

    const std::vector<Aabb>& boxes() const { return m_boxes; }
    /// The rectangles of the leaves, clipped to the bounds of all boxes.
    std::vector<Aabb> cells() const;
    /// Levels below the root; 0 for a tree that is one leaf.
    int depth() const { return m_depth; }
    /// What all leaves hold together; a box counts for each leaf that it is in.
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
    std::vector<Aabb> m_itemBoxes;      // theirs, to be read in a row
    int m_depth = 0;
};

} // namespace spacetow
