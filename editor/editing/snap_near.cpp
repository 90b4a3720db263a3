#include "editor/editing/snap_near.h"

#include "core/level/level_index.h"
#include "core/level/object_geometry.h"

#include <algorithm>

namespace spacetow {

namespace {

/// Asked of a few objects only, so it climbs from each instead of going through all groups of the level.
bool isShown(const Level& level, const Object& object) {
    constexpr int deepest = 1000; // groups in a circle would have no end
    const Object* at = &object;
    for (int depth = 0; at != nullptr && depth < deepest; ++depth) {
        if (!at->visible) {
            return false;
        }
        at = at->parent == 0 ? nullptr : level.objects.find(at->parent);
        at = at != nullptr && std::holds_alternative<GroupObject>(at->data) ? at : nullptr;
    }
    return true;
}

/// Connectors go with the bodies that they join.
bool goesAlong(const SnapSubject& subject, const Object& object) {
    const auto moves = [&](Key key) { return std::ranges::binary_search(subject.keys, key); };
    const auto* connector = std::get_if<ConnectorObject>(&object.data);
    return moves(object.key) || (connector != nullptr && (moves(connector->a) || moves(connector->b)));
}

/// The node at which the segment that begins at `from` ends.
NodeRef endOf(const Object& object, const NodeRef& from) {
    NodeRef end{from.key, from.shape, from.vertex + 1};
    return hasNode(object.data, end.shape, end.vertex) ? end : NodeRef{from.key, from.shape, 0};
}

class Gatherer {
  public:
    Gatherer(const Level& level, const SnapSubject& subject, const Aabb& box)
        : m_level(level), m_subject(subject), m_box(box) {}

    void add(int place) {
        const Object& object = m_level.objects[place];
        const Key key = object.key;
        const LevelIndex& index = levelIndex(m_level);
        index.visitVerticesOf(place, m_box, [&](const VertexRef& ref, const Vec2& at) {
            if (!isMoving({key, ref.shape, ref.vertex})) {
                found.points.push_back({tidied(at), SnapKind::Vertex, key});
            }
        });
        index.visitSegmentsOf(place, m_box, [&](const SegmentRef& ref, const Vec2& a, const Vec2& b) {
            const NodeRef start{key, ref.shape, ref.segment};
            if (m_subject.nodes.empty() || (!isMoving(start) && !isMoving(endOf(object, start)))) {
                found.segments.push_back({tidied(a), tidied(b), key});
            }
        });
        addRound(object);
    }

    Nearby found;

  private:
    bool isMoving(const NodeRef& node) const { return std::ranges::binary_search(m_subject.nodes, node); }

    void addCircle(const Circle& circle, Key key) {
        const Vec2 center = tidied(circle.center);
        addCenter(center, key);
        found.rims.push_back({{center, circle.radius}, key});
    }
    void addCenter(const Vec2& center, Key key) {
        if (m_box.contains(center)) {
            found.points.push_back({center, SnapKind::Center, key});
        }
    }
    void addRound(const Object& object) {
        if (const auto* body = std::get_if<BodyObject>(&object.data)) {
            const Transform pose{body->position, Rot::fromAngle(body->angle)};
            for (const LevelShape& shape : body->shapes) {
                if (const auto* circle = std::get_if<Circle>(&shape)) {
                    addCircle({pose.toWorld(circle->center), circle->radius}, object.key);
                }
            }
        } else if (const auto* payload = std::get_if<PayloadObject>(&object.data)) {
            addCircle({payload->position, payload->radius}, object.key);
        } else if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
            addCenter(ship->position, object.key);
        }
    }

    const Level& m_level;
    const SnapSubject& m_subject;
    Aabb m_box;
};

} // namespace

bool staysInView(const Level& level, const SnapSubject& subject, int object) {
    return !goesAlong(subject, level.objects[object]) && isShown(level, level.objects[object]);
}

Nearby nearby(const Level& level, const SnapSubject& subject, const Aabb& box) {
    Gatherer gatherer(level, subject, box);
    levelIndex(level).visitObjects(box, [&](int object) {
        if (staysInView(level, subject, object)) {
            gatherer.add(object);
        }
    });
    return std::move(gatherer.found);
}

} // namespace spacetow
