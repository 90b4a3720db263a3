#include "core/physics/query/why_apart.h"

#include "core/base/contract.h"
#include "core/geometry/bounds.h"
#include "core/geometry/closest.h"
#include "core/geometry/collide.h"
#include "core/physics/broad_phase/collision_rules.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace spacetow {

namespace {

struct Touching {
    bool any = false;
    bool solid = false;
    const Pair* passing = nullptr; // a pair with a one-way wall that the other body passes, or is behind
    bool isFaceOpen = false;       // the face of that wall is open
};

/// Reads the flags of the pairs of two bodies in a pair table.
void lookUp(const PairTable& table, Slot a, Slot b, Touching& touching) {
    const std::uint64_t bodies = PairKey{a, b}.bodies();
    for (std::size_t i = table.firstFrom(bodies); i < table.size() && table.pairs[i].key().bodies() == bodies; ++i) {
        touching.any |= table.flags[i].touching || table.flags[i].passed;
        const Passage passage = table.flags[i].passage;
        const bool comes = passage == Passage::Behind || passage == Passage::Passing;
        if (comes && !touching.isFaceOpen) {
            touching.passing = &table.pairs[i];
            touching.isFaceOpen = passage == Passage::Passing;
        }
    }
}

Touching touchingOf(const WorldData& data, Slot a, Slot b) {
    Touching touching;
    for (const PairTable* table : {&data.contacts.table, &data.sleep.table}) {
        lookUp(*table, a, b, touching);
        lookUp(*table, b, a, touching);
    }
    touching.solid = touching.any && areTangible(data.bodies, a, b);
    return touching;
}

bool hasOnlyWalls(const BodyRecord& record) {
    return std::all_of(record.parts->begin(), record.parts->end(),
                       [](const Part& part) { return std::holds_alternative<WallPart>(part); });
}

std::vector<ConnectorId> connectorsBetween(const Forces& forces, Slot a, Slot b) {
    std::vector<ConnectorId> found;
    for (std::uint32_t i = 0; i < forces.connectors.size(); ++i) {
        const ConnectorRecord& c = forces.connectors[i];
        if (c.used && !c.bodiesCollide && std::minmax(c.a, c.b) == std::minmax(a, b)) {
            found.push_back({i, c.generation});
        }
    }
    return found;
}

/// The reasons that do not depend on poses.
std::optional<CollisionAnswer> answerByRules(const Bodies& bodies, const Forces& forces, BodyId a, BodyId b) {
    const BodyRecord& ra = bodies.records[a.index];
    const BodyRecord& rb = bodies.records[b.index];
    CollisionAnswer answer;
    if (!ra.active || !rb.active) {
        answer.why = WhyApart::Inactive;
        answer.body = ra.active ? b : a;
    } else if (!haveCollidingKinds(bodies, a.index, b.index)) {
        answer.why = WhyApart::Unmovable;
    } else if (!mayTouch(ra.filter, rb.filter)) {
        const bool first = !ra.filter.touches.intersects(rb.filter.tags);
        answer.why = WhyApart::Mask;
        answer.body = first ? a : b;
        answer.missing = first ? rb.filter.tags : ra.filter.tags;
        answer.bothMasks = first && !rb.filter.touches.intersects(ra.filter.tags);
    } else if (auto between = connectorsBetween(forces, a.index, b.index); !between.empty()) {
        answer.why = WhyApart::Connected;
        answer.connectors = std::move(between);
    } else {
        return std::nullopt;
    }
    return answer;
}

CollisionAnswer answerOfPassing(const Bodies& bodies, const Pair& pair, BodyId a, BodyId b) {
    const auto* wallA = std::get_if<WallPart>(pair.shapeA);
    const WallPart& wall = wallA != nullptr ? *wallA : std::get<WallPart>(*pair.shapeB);
    const Slot slot = wallA != nullptr ? pair.bodyA : pair.bodyB;
    const bool isInWorld = wallA == nullptr && pair.staticB;
    const Transform pose = isInWorld ? Transform{} : bodies.pose(slot);
    CollisionAnswer answer;
    answer.why = WhyApart::Passing;
    answer.body = slot == a.index ? a : b;
    answer.from = pose.toWorld(wall.a);
    answer.to = pose.toWorld(wall.b);
    return answer;
}

/// Compares all pairs of parts of two bodies.
class Distance {
  public:
    Distance(const WorldData& data, BodyId a, BodyId b)
        : m_a(a), m_b(b), m_partsA(*data.bodies.records[a.index].parts), m_partsB(*data.bodies.records[b.index].parts),
          m_poseA(data.bodies.pose(a.index)), m_poseB(data.bodies.pose(b.index)) {}

    CollisionAnswer answer() {
        std::vector<Aabb> boxes;
        boxes.reserve(m_partsB.size());
        for (const Part& part : m_partsB) {
            boxes.push_back(coreBox(part, m_poseB));
        }
        for (const Part& partA : m_partsA) {
            const Aabb box = coreBox(partA, m_poseA);
            for (std::size_t i = 0; i < m_partsB.size() && !m_meets; ++i) {
                if (gap(box, boxes[i]) <= m_nearest.distance) {
                    visit(partA, m_partsB[i]);
                }
            }
        }
        return verdict();
    }

  private:
    /// The AABB of a part as closestPoints() sees it: without the depth of an edge.
    static Aabb coreBox(const Part& part, const Transform& pose) {
        const Core core = coreOf(part, pose);
        Aabb box;
        for (std::size_t i = 0; i < static_cast<std::size_t>(core.count); ++i) {
            box.include(core.points[i]);
        }
        return box.grown(core.radius);
    }

    static double gap(const Aabb& a, const Aabb& b) {
        const Vec2 apart = (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(Vec2(0, 0));
        return apart.norm();
    }

    void visit(const Part& a, const Part& b) {
        const ClosestPoints closest = closestPoints(a, m_poseA, b, m_poseB);
        const auto* wallA = std::get_if<WallPart>(&a);
        const auto* wallB = std::get_if<WallPart>(&b);
        if (closest.distance <= m_nearest.distance) {
            m_nearest = closest;
        }
        if (closest.distance > linearSlop || (wallA != nullptr && wallB != nullptr)) {
            return;
        }
        m_meets = collide(a, m_poseA, b, m_poseB, linearSlop).count > 0;
        if (!m_meets && wallA != nullptr && wallA->oneWay) {
            note(m_a, *wallA, m_poseA);
        } else if (!m_meets && wallB != nullptr && wallB->oneWay) {
            note(m_b, *wallB, m_poseB);
        }
    }

    void note(BodyId body, const WallPart& wall, const Transform& pose) {
        m_behind = body;
        m_from = pose.toWorld(wall.a);
        m_to = pose.toWorld(wall.b);
    }

    CollisionAnswer verdict() const {
        CollisionAnswer answer;
        if (!m_meets && m_behind) {
            answer.why = WhyApart::Behind;
            answer.body = m_behind;
            answer.from = m_from;
            answer.to = m_to;
            return answer;
        }
        answer.why = m_meets || m_nearest.distance == 0 ? WhyApart::NextUpdate : WhyApart::Distance;
        answer.from = m_nearest.onA;
        answer.to = m_nearest.onB;
        answer.distance = m_nearest.distance;
        return answer;
    }

    BodyId m_a, m_b;
    const std::vector<Part>& m_partsA;
    const std::vector<Part>& m_partsB;
    Transform m_poseA, m_poseB;
    ClosestPoints m_nearest{.distance = std::numeric_limits<double>::infinity()};
    bool m_meets = false;
    BodyId m_behind;
    Vec2 m_from{0, 0}, m_to{0, 0};
};

} // namespace

CollisionAnswer whyNotColliding(const World& world, BodyId a, BodyId b) {
    EXPECTS(world.contains(a) && world.contains(b));
    const WorldData& data = world.data();
    CollisionAnswer answer;
    if (a == b) {
        answer.why = WhyApart::SameBody;
        return answer;
    }
    const Touching touching = touchingOf(data, a.index, b.index);
    if (touching.solid) {
        return answer;
    }
    if (auto ruled = answerByRules(data.bodies, data.forces, a, b)) {
        return *std::move(ruled);
    }
    const BodyRecord& ra = data.bodies.records[a.index];
    const BodyRecord& rb = data.bodies.records[b.index];
    if (!ra.tangible || !rb.tangible) {
        answer.why = WhyApart::Intangible;
        answer.body = ra.tangible ? b : a;
        answer.sensed = touching.any;
        return answer;
    }
    if (hasOnlyWalls(ra) && hasOnlyWalls(rb)) {
        answer.why = WhyApart::Walls;
        return answer;
    }
    if (touching.isFaceOpen) {
        return answerOfPassing(data.bodies, *touching.passing, a, b);
    }
    answer = Distance(data, a, b).answer();
    // A body that overlaps the wall and has come from behind will have no contact in the next update either.
    const bool passes = answer.why == WhyApart::NextUpdate && touching.passing != nullptr;
    return passes ? answerOfPassing(data.bodies, *touching.passing, a, b) : answer;
}

} // namespace spacetow
