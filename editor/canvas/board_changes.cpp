#include "editor/canvas/board_changes.h"

#include "core/base/overloaded.h"
#include "core/geometry/polygon.h"
#include "core/level/level_index.h"
#include "core/level/object_geometry.h"
#include "editor/canvas/wall_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

constexpr int mostChanges = 1000; // more than these are not worth telling apart
constexpr double sameMove = 1e-9; // m

const BodyObject* bodyOf(const Object& object) {
    return std::get_if<BodyObject>(&object.data);
}

bool makesRock(const BodyObject& body) {
    return body.kind == BodyKind::Static && body.tangible &&
           std::ranges::any_of(body.shapes, [](const LevelShape& shape) {
               const auto* chain = std::get_if<EdgeChain>(&shape);
               return chain != nullptr && chain->closed && chain->vertices.size() > 2 && std::isinf(chain->depth);
           });
}

bool makesRock(const Object& object) {
    const BodyObject* body = bodyOf(object);
    return body != nullptr && makesRock(*body);
}

/// Whether it shows a wall behind which everything outside lies.
bool isHollow(const Object& object) {
    const BodyObject* body = object.visible ? bodyOf(object) : nullptr;
    return body != nullptr && makesRock(*body) && std::ranges::any_of(body->shapes, [](const LevelShape& shape) {
               const auto* chain = std::get_if<EdgeChain>(&shape);
               return chain != nullptr && chain->closed && std::isinf(chain->depth) && signedArea(chain->vertices) > 0;
           });
}

struct Chain {
    const std::vector<Vec2>& vertices;
    bool closed;

    /// The vertices from `first` up to `end`, with two neighbours on both sides: bands at corners depend on these.
    void include(Aabb& box, std::size_t first, std::size_t end) const {
        constexpr std::size_t neighbours = 2;
        const std::size_t n = vertices.size();
        if (!closed) {
            first -= std::min(first, neighbours);
            for (std::size_t i = first; i < std::min(end + neighbours, n); ++i) {
                box.include(vertices[i]);
            }
            return;
        }
        const std::size_t count = std::min(end - first + 2 * neighbours, n);
        for (std::size_t i = 0; i < count; ++i) {
            box.include(vertices[(first + n - neighbours % n + i) % n]);
        }
    }
};

/// What lies between the first and the last vertex in which two chains differ, in local coordinates.
Aabb differingStretch(const Chain& before, const Chain& after) {
    const std::vector<Vec2>& u = before.vertices;
    const std::vector<Vec2>& v = after.vertices;
    const auto first = static_cast<std::size_t>(std::ranges::mismatch(u, v).in1 - u.begin());
    if (first == u.size() && first == v.size()) {
        return {};
    }
    std::size_t last = 0; // counted from the end
    while (last + first < std::min(u.size(), v.size()) && u[u.size() - 1 - last] == v[v.size() - 1 - last]) {
        ++last;
    }
    Aabb box;
    before.include(box, first, u.size() - last);
    after.include(box, first, v.size() - last);
    return box;
}

/// Nothing when the shapes differ in more than some of their vertices.
std::optional<Aabb> differingStretch(const LevelShape& before, const LevelShape& after) {
    if (const auto* a = std::get_if<EdgeChain>(&before), *b = std::get_if<EdgeChain>(&after); a && b) {
        const bool alike = a->closed == b->closed && a->depth == b->depth;
        return alike ? std::optional(differingStretch(Chain{a->vertices, a->closed}, Chain{b->vertices, b->closed}))
                     : std::nullopt;
    }
    if (const auto* a = std::get_if<LineChain>(&before), *b = std::get_if<LineChain>(&after); a && b) {
        const bool alike = a->closed == b->closed;
        return alike ? std::optional(differingStretch(Chain{a->vertices, a->closed}, Chain{b->vertices, b->closed}))
                     : std::nullopt;
    }
    return before == after ? std::optional(Aabb()) : std::nullopt;
}

/// Where a body with many vertices differs, when it is the same but for some of these.
std::optional<Aabb> differingPart(const Object& before, const Object& after) {
    const BodyObject* a = bodyOf(before);
    const BodyObject* b = bodyOf(after);
    if (a == nullptr || b == nullptr || a->position != b->position || a->angle != b->angle || a->kind != b->kind ||
        a->tangible != b->tangible || a->filter != b->filter || before.visible != after.visible ||
        before.locked != after.locked || a->shapes.size() != b->shapes.size()) {
        return {};
    }
    Aabb local;
    for (std::size_t i = 0; i < a->shapes.size(); ++i) {
        if (const std::optional<Aabb> part = differingStretch(a->shapes[i], b->shapes[i])) {
            local.include(*part);
        } else {
            return {};
        }
    }
    Aabb world;
    if (!local.isEmpty()) {
        const Transform pose = *poseOf(after);
        for (const Vec2& corner :
             {local.min, local.max, Vec2(local.min.x(), local.max.y()), Vec2(local.max.x(), local.min.y())}) {
            world.include(pose.toWorld(corner));
        }
    }
    return world;
}

class Comparison {
  public:
    Comparison(const Level& before, const Level& after)
        : m_before(before), m_after(after), m_old(levelIndex(before)), m_new(levelIndex(after)) {}

    LevelChanges changes() {
        int count = 0;
        m_after.objects.visitDifferences(m_before.objects, [&](int place) {
            if (++count <= mostChanges) {
                compare(place);
            }
        });
        if (count > mostChanges) {
            m_changes.objects.everything = true;
            m_changes.rock.everything = true;
        } else if (count > 0) {
            compareConnectors();
        }
        return std::move(m_changes);
    }

  private:
    void compare(int place) {
        const Object* a = place < m_before.objects.size() ? &m_before.objects[place] : nullptr;
        const Object* b = place < m_after.objects.size() ? &m_after.objects[place] : nullptr;
        for (const Object* object : {a, b}) {
            // What a group hides or shows is not known here.
            const bool group = object != nullptr && std::holds_alternative<GroupObject>(object->data);
            m_changes.objects.everything = m_changes.objects.everything || group;
            m_changes.rock.everything = m_changes.rock.everything || group;
        }
        const bool rock = (a != nullptr && makesRock(*a)) || (b != nullptr && makesRock(*b));
        const bool hollow = a != nullptr && isHollow(*a);
        if (rock && hollow != (b != nullptr && isHollow(*b))) {
            m_changes.rock.everything = true; // far away as well
            m_changes.objects.everything = true;
        }
        if (a != nullptr && b != nullptr && a->key == b->key) {
            if (const std::optional<Aabb> part = differingPart(*a, *b)) {
                add(part->grown(bandBehind(m_new.reachOf(place))), rock);
                return;
            }
        }
        if (a != nullptr) {
            add(m_old.boundsOf(place).grown(bandBehind(m_old.reachOf(place))), rock);
        }
        if (b != nullptr) {
            add(m_new.boundsOf(place).grown(bandBehind(m_new.reachOf(place))), rock);
        }
    }
    void add(const Aabb& box, bool rock) {
        m_changes.objects.add(box);
        if (rock) {
            m_changes.rock.add(box);
        }
    }
    void compareConnectors() {
        const std::vector<int>& now = m_new.connectors();
        for (const int place : now) {
            const Aabb& box = m_new.boundsOf(place);
            const bool same = m_after.objects.sharesPiece(place, m_before.objects);
            if (same && (box.min != m_old.boundsOf(place).min || box.max != m_old.boundsOf(place).max)) {
                add(m_old.boundsOf(place), false);
                add(box, false);
            }
        }
    }

    const Level& m_before;
    const Level& m_after;
    const LevelIndex& m_old;
    const LevelIndex& m_new;
    LevelChanges m_changes;
};

/// Whether they look the same but for where they are. The list of fields is complete, or it would not compile.
bool looksAlike(const BodyObject& a, const BodyObject& b) {
    const auto& [kind, shapes, position, angle, velocity, angularVelocity, mass, density, restitution, friction,
                 linearDamping, angularDamping, filter, tangible, frozen] = a;
    return kind == b.kind && angle == b.angle && filter == b.filter && tangible == b.tangible && frozen == b.frozen &&
           shapes == b.shapes;
}

std::optional<Vec2> moveOf(const ObjectData& before, const ObjectData& after) {
    if (before.index() != after.index()) {
        return {};
    }
    using Move = std::optional<Vec2>;
    return std::visit(Overloaded{[&](const BodyObject& a) {
                                     const auto& b = std::get<BodyObject>(after);
                                     return looksAlike(a, b) ? Move(b.position - a.position) : Move();
                                 },
                                 [&](const ShipObject& a) {
                                     const auto& b = std::get<ShipObject>(after);
                                     return a.angle == b.angle ? Move(b.position - a.position) : Move();
                                 },
                                 [&](const PayloadObject& a) {
                                     const auto& b = std::get<PayloadObject>(after);
                                     return a.radius == b.radius ? Move(b.position - a.position) : Move();
                                 },
                                 [&](const FinishObject& a) {
                                     const auto& b = std::get<FinishObject>(after);
                                     const Vec2 move = b.a - a.a;
                                     return (b.b - a.b - move).norm() < sameMove ? Move(move) : Move();
                                 },
                                 [](const ConnectorObject&) { return Move(); },
                                 [](const GroupObject&) { return Move(); }},
                      before);
}

std::optional<Vec2> connectorMove(const ConnectorObject& connector, const Level& before, const Level& after) {
    const auto a = endsOf(connector, before.objects);
    const auto b = endsOf(connector, after.objects);
    if (!a || !b) {
        return {};
    }
    const Vec2 move = b->front() - a->front();
    return (b->back() - a->back() - move).norm() < sameMove ? std::optional(move) : std::nullopt;
}

} // namespace

LevelChanges boardChangesBetween(const Level& before, const Level& after) {
    return Comparison(before, after).changes();
}

std::vector<int> placesChanged(const Level& before, const Level& after) {
    std::vector<int> places;
    after.objects.visitDifferences(before.objects, [&](int place) {
        if (place < after.objects.size()) {
            places.push_back(place);
        }
    });
    const LevelIndex& old = levelIndex(before);
    const LevelIndex& index = levelIndex(after);
    std::vector<int> hanging;
    for (const int place : index.connectors()) {
        const bool same = after.objects.sharesPiece(place, before.objects);
        if (same && (index.boundsOf(place).min != old.boundsOf(place).min ||
                     index.boundsOf(place).max != old.boundsOf(place).max)) {
            hanging.push_back(place);
        }
    }
    const auto middle = places.insert(places.end(), hanging.begin(), hanging.end());
    std::inplace_merge(places.begin(), middle, places.end());
    return places;
}

std::optional<Vec2> commonMove(const Level& before, const Level& after, const std::vector<int>& places) {
    std::optional<Vec2> common;
    for (const int place : places) {
        if (place >= before.objects.size() || place >= after.objects.size()) {
            return {};
        }
        const Object& a = before.objects[place];
        const Object& b = after.objects[place];
        if (a.key != b.key || a.visible != b.visible) {
            return {};
        }
        const auto* connector = std::get_if<ConnectorObject>(&a.data);
        const std::optional<Vec2> move = connector != nullptr && a == b ? connectorMove(*connector, before, after)
                                         : &a == &b                     ? std::optional(Vec2(0, 0))
                                                                        : moveOf(a.data, b.data);
        if (!move || (common && (*move - *common).norm() > sameMove)) {
            return {};
        }
        common = move;
    }
    return common;
}

std::vector<int> rockMakers(const Level& level) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<int> places;
    levelIndex(level).visitReaching({{infinity, infinity}, {infinity, infinity}},
                                    [&places](int place) { places.push_back(place); });
    return places;
}

bool hasFadingBand(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body != nullptr && std::ranges::any_of(body->shapes, [](const LevelShape& shape) {
               const auto* chain = std::get_if<EdgeChain>(&shape);
               return chain != nullptr && std::isinf(chain->depth);
           });
}

double bandBehind(double reach) {
    return fadeDepth + (std::isfinite(reach) ? reach : 0);
}

} // namespace spacetow
