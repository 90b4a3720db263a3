#pragma once
// A bounding volume hierarchy over the segments of a polyline, eight to a node. Successive segments are near each
// other, so nothing is sorted. The points are not stored; the caller has them.

#include "core/math/aabb.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace spacetow {

class SegmentTree {
  public:
    static constexpr int stretch = 8; // segments of a lowest node, and children of any other node

    SegmentTree() = default;
    /// Segment i leads from point i to the next; when closed, the last one leads to the first point.
    SegmentTree(std::span<const Vec2> points, bool closed);

    int segments() const { return m_segments; }
    /// Empty when there is no segment.
    Aabb bounds() const { return m_rows.empty() ? Aabb() : m_rows.back().front(); }

    /// Descends from the root in ascending order of segments: `enter(box, first, end)` says whether to descend into a
    /// node, and `visit(first, end)` is called for the lowest nodes that were entered. `first` and `end` are segments.
    template <class Enter, class Visit>
    void descend(Enter enter, Visit visit) const {
        if (!m_rows.empty()) {
            descendFrom({static_cast<int>(m_rows.size()) - 1, 0, stretchOf(m_rows.size() - 1)}, enter, visit);
        }
    }
    /// Calls `visit(first, end)` for the lowest nodes whose boxes overlap the box.
    template <class Visit>
    void visit(const Aabb& box, Visit visit) const {
        descend([&box](const Aabb& stretchBox, int, int) { return stretchBox.overlaps(box); }, visit);
    }

  private:
    struct Node {
        int row, index;
        int length; // segments under a box of the row
    };
    static int stretchOf(std::size_t row) {
        int length = stretch;
        for (std::size_t i = 0; i < row; ++i) {
            length *= stretch;
        }
        return length;
    }
    template <class Enter, class Visit>
    void descendFrom(const Node& node, Enter& enter, Visit& visit) const {
        const int first = node.index * node.length;
        const int end = std::min(first + node.length, m_segments);
        if (!enter(rowAt(node.row)[static_cast<std::size_t>(node.index)], first, end)) {
            return;
        }
        if (node.row == 0) {
            visit(first, end);
            return;
        }
        const int below = static_cast<int>(rowAt(node.row - 1).size());
        const int start = node.index * stretch;
        for (int i = start; i < std::min(start + stretch, below); ++i) {
            descendFrom({node.row - 1, i, node.length / stretch}, enter, visit);
        }
    }
    const std::vector<Aabb>& rowAt(int row) const { return m_rows[static_cast<std::size_t>(row)]; }

    int m_segments = 0;
    std::vector<std::vector<Aabb>> m_rows; // from the lowest to the one that is a single box
};

} // namespace spacetow
