#include "core/geometry/segment_tree.h"

namespace spacetow {

namespace {

/// A box around each `SegmentTree::stretch` boxes that follow each other.
std::vector<Aabb> boxesAround(const std::vector<Aabb>& below) {
    std::vector<Aabb> boxes((below.size() + SegmentTree::stretch - 1) / SegmentTree::stretch);
    for (std::size_t i = 0; i < below.size(); ++i) {
        boxes[i / SegmentTree::stretch].include(below[i]);
    }
    return boxes;
}

} // namespace

SegmentTree::SegmentTree(std::span<const Vec2> points, bool closed) {
    const std::size_t count = points.size();
    const std::size_t segments = closed || count == 0 ? count : count - 1;
    m_segments = static_cast<int>(segments);
    if (segments == 0) {
        return;
    }
    std::vector<Aabb> lowest((segments + stretch - 1) / stretch);
    for (std::size_t i = 0; i < segments; ++i) {
        Aabb& box = lowest[i / stretch];
        box.include(points[i]);
        box.include(points[i + 1 < count ? i + 1 : 0]);
    }
    m_rows.push_back(std::move(lowest));
    while (m_rows.back().size() > 1) {
        m_rows.push_back(boxesAround(m_rows.back()));
    }
}

} // namespace spacetow
