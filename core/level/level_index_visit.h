#pragma once
// The visits of LevelIndex; included by level_index.h alone.

#include "core/base/overloaded.h"
#include "core/geometry/intersect.h"
#include "core/level/level_index.h"
#include "core/level/object_geometry.h"

namespace spacetow {

namespace level_index {

/// An outline of straight segments, local to `pose`.
struct Path {
    std::span<const Vec2> points;
    bool closed = false;
    Transform pose;

    /// A lone point is a segment of no length.
    int segments() const {
        const int count = static_cast<int>(points.size());
        return closed || count < 2 ? count : count - 1;
    }
    Vec2 at(int vertex) const { return pose.toWorld(points[static_cast<std::size_t>(vertex) % points.size()]); }
};

/// The path of a shape; without points for a circle.
Path pathOf(const LevelShape& shape, const Transform& pose);
/// A box around the world's box in the coordinates of the path.
Aabb toLocal(const Aabb& box, const Path& path, const SegmentTree& tree);

/// `visit(first, end)` for the stretches of segments that may overlap the box.
template <class Visit>
void visitStretches(const Path& path, const SegmentTree* tree, const Aabb& box, Visit visit) {
    if (tree != nullptr && tree->segments() > 0) {
        tree->visit(toLocal(box, path, *tree), visit);
    } else if (path.segments() > 0) {
        visit(0, path.segments());
    }
}

} // namespace level_index

/// `visit(shape, path)` for each outline that the object has.
template <class Visit>
void LevelIndex::visitPaths(int object, Visit visit) const {
    using level_index::Path;
    const auto visitEnds = [&visit](std::span<const Vec2> ends) { visit(0, Path{ends, false, {}}); };
    std::visit(Overloaded{[&](const BodyObject& body) {
                              const Transform pose{body.position, Rot::fromAngle(body.angle)};
                              for (std::size_t i = 0; i < body.shapes.size(); ++i) {
                                  visit(static_cast<int>(i), level_index::pathOf(body.shapes[i], pose));
                              }
                          },
                          [&](const ShipObject& ship) {
                              const auto outline = shipOutline();
                              visit(0, Path{outline, true, {ship.position, Rot::fromAngle(ship.angle)}});
                          },
                          [](const PayloadObject&) {},
                          [&](const FinishObject& finish) {
                              visitEnds(std::array{finish.a, finish.b});
                          },
                          [&](const ConnectorObject& connector) {
                              if (const auto ends = endsOf(connector, m_objects)) {
                                  visitEnds(*ends);
                              }
                          },
                          [](const GroupObject&) {}},
               m_objects[object].data);
}

template <class Visit>
void LevelIndex::visitObjects(const Aabb& box, Visit visit) const {
    for (std::size_t b = 0; b < m_blocks.size(); ++b) {
        if (!m_blocks[b]->bounds.overlaps(box)) {
            continue;
        }
        int object = static_cast<int>(b) * ObjectList::blockSize;
        for (const Entry& entry : m_blocks[b]->entries) {
            if (entry.box.overlaps(box)) {
                visit(object);
            }
            ++object;
        }
    }
}

template <class Visit>
void LevelIndex::visitReaching(const Aabb& box, Visit visit) const {
    for (std::size_t b = 0; b < m_blocks.size(); ++b) {
        if (!m_blocks[b]->reaching.overlaps(box)) {
            continue;
        }
        int object = static_cast<int>(b) * ObjectList::blockSize;
        for (const Entry& entry : m_blocks[b]->entries) {
            if (entry.box.grown(entry.reach).overlaps(box)) {
                visit(object);
            }
            ++object;
        }
    }
}

template <class Visit>
void LevelIndex::visitSegmentsOf(int object, const Aabb& box, Visit visit) const {
    visitPaths(object, [&](int shape, const level_index::Path& path) {
        level_index::visitStretches(path, treeOf(object, shape), box, [&](int first, int end) {
            for (int i = first; i < end; ++i) {
                const Vec2 a = path.at(i);
                const Vec2 b = path.at(i + 1);
                if (segmentMeets(a, b, box)) {
                    visit(SegmentRef{object, shape, i}, a, b);
                }
            }
        });
    });
}

template <class Visit>
void LevelIndex::visitSegments(const Aabb& box, Visit visit) const {
    visitObjects(box, [&](int object) { visitSegmentsOf(object, box, visit); });
}

template <class Visit>
void LevelIndex::visitVerticesOf(int object, const Aabb& box, Visit visit) const {
    const ObjectData& data = m_objects[object].data;
    if (!std::holds_alternative<BodyObject>(data) && !std::holds_alternative<FinishObject>(data)) {
        return;
    }
    visitPaths(object, [&](int shape, const level_index::Path& path) {
        level_index::visitStretches(path, treeOf(object, shape), box, [&](int first, int end) {
            // No segment begins at the end of an open chain.
            const bool atEnd = !path.closed && path.points.size() > 1 && end == path.segments();
            for (int i = first; i < end + (atEnd ? 1 : 0); ++i) {
                const Vec2 at = path.at(i);
                if (box.contains(at)) {
                    visit(VertexRef{object, shape, i}, at);
                }
            }
        });
    });
}

template <class Visit>
void LevelIndex::visitVertices(const Aabb& box, Visit visit) const {
    visitObjects(box, [&](int object) { visitVerticesOf(object, box, visit); });
}

} // namespace spacetow
