#pragma once
// Where the objects of a level are: boxes of all of them, and of stretches of long outlines, so that what lies in a
// small area is found without looking at the rest. An index is made out of that of the level before, in time that
// grows with what an edit has changed. Ask levelIndex(level). World coordinates, metres.

#include "core/geometry/segment_tree.h"
#include "core/level/level.h"
#include "core/math/aabb.h"
#include "core/math/transform.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace spacetow {

/// A segment of an outline, by places: of the object in the level, of the shape in the object (0 where there is but
/// one), of the vertex at which the segment begins.
struct SegmentRef {
    int object = 0;
    int shape = 0;
    int segment = 0;

    auto operator<=>(const SegmentRef&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
};

/// Likewise for a vertex.
struct VertexRef {
    int object = 0;
    int shape = 0;
    int vertex = 0;

    auto operator<=>(const VertexRef&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
};

class LevelIndex {
  public:
    /// Takes over from `before` what the lists share; without it everything is made anew.
    explicit LevelIndex(ObjectList objects, const LevelIndex* before = nullptr);

    const ObjectList& objects() const { return m_objects; }
    /// Of everything, groups left out.
    const Aabb& bounds() const { return m_bounds; }
    /// Walls without their depth; empty for groups, and for connectors that have lost an end.
    const Aabb& boundsOf(int object) const { return entry(object).box; }
    /// How far beyond its bounds there is something of the object: the matter behind walls, which is as deep as they
    /// are with room for corners, and without end behind closed ones that have no back; the origin of a kinematic body.
    double reachOf(int object) const { return entry(object).reach; }
    /// Over the segments of a shape, in its coordinates; null where that is not worth its while.
    const SegmentTree* treeOf(int object, int shape) const {
        const auto& trees = entry(object).trees;
        return trees ? &(*trees)[static_cast<std::size_t>(shape)] : nullptr;
    }
    /// How many segments of the outline are in the box, about; 1 for what has none.
    int segmentsNear(int object, const Aabb& box) const;
    /// Places of all groups and of all connectors, ascending.
    const std::vector<int>& groups() const { return m_groups; }
    const std::vector<int>& connectors() const { return m_connectors; }

    /// Calls `visit(object)`, in ascending order, for each object whose bounds overlap the box.
    template <class Visit>
    void visitObjects(const Aabb& box, Visit visit) const;
    /// Likewise for each whose bounds do when they are grown by its reach.
    template <class Visit>
    void visitReaching(const Aabb& box, Visit visit) const;
    /// Calls `visit(ref, a, b)` with the ends of each segment of an outline that meets the box: of chains, polygons,
    /// the ship, the finish and connectors. To be near a point means to meet a box around it.
    template <class Visit>
    void visitSegments(const Aabb& box, Visit visit) const;
    template <class Visit>
    void visitSegmentsOf(int object, const Aabb& box, Visit visit) const;
    /// Calls `visit(ref, at)` for each vertex in the box: of chains, polygons and the finish.
    template <class Visit>
    void visitVertices(const Aabb& box, Visit visit) const;
    template <class Visit>
    void visitVerticesOf(int object, const Aabb& box, Visit visit) const;

  private:
    struct Entry {
        Aabb box;
        double reach = 0;
        int segments = 0;
        std::shared_ptr<const std::vector<SegmentTree>> trees; // one a shape, of objects with many vertices
    };
    struct Block {
        Aabb bounds;
        Aabb reaching;
        std::vector<Entry> entries;
        std::vector<int> groups, connectors; // places in the level

        void bound();
    };
    class Maker;

    void placeConnectors(const LevelIndex* before);
    std::optional<std::vector<Key>> keysChanged(const LevelIndex* before) const;

    template <class Visit>
    void visitPaths(int object, Visit visit) const;

    const Entry& entry(int object) const {
        return m_blocks[static_cast<std::size_t>(object) / ObjectList::blockSize]
            ->entries[static_cast<std::size_t>(object) % ObjectList::blockSize];
    }

    ObjectList m_objects;
    std::vector<std::shared_ptr<const Block>> m_blocks; // as those of the list
    Aabb m_bounds;
    std::vector<int> m_groups, m_connectors;
};

/// The index of the level, which is kept with it. The reference lives as long as the level, unchanged.
inline const LevelIndex& levelIndex(const Level& level) {
    return level.objects.places();
}

} // namespace spacetow

#include "core/level/level_index_visit.h"
