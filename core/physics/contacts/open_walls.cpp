#include "core/physics/contacts/open_walls.h"

#include "core/geometry/moved.h"
#include "core/physics/def/tolerances.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory_resource>
#include <optional>
#include <vector>

namespace spacetow {

namespace {

// m: deeper than the overlap that contacts leave, so that the body has not come from the front
constexpr double deepInWall = 2 * linearSlop;

/// A pair of a one-way wall and a part of another body.
struct OneWayPair {
    const WallPart* wall;
    const Part* part;
    Slot body;
    Transform pose;     // of the body, in the coordinates of the wall
    Transform partPose; // of the part; differs from `pose` for static bodies, whose parts are in world coordinates
};

std::optional<OneWayPair> oneWayPairOf(const Bodies& bodies, const Pair& pair) {
    const auto* wallA = std::get_if<WallPart>(pair.shapeA);
    const auto* wallB = std::get_if<WallPart>(pair.shapeB);
    const WallPart* wall = wallA != nullptr ? wallA : wallB;
    if (wall == nullptr || (wallA != nullptr && wallB != nullptr) || !letsThrough(*wall)) {
        return std::nullopt;
    }
    const Transform a = bodies.plannedMotions[pair.bodyA].pose();
    if (pair.staticB && wallA != nullptr) {
        return OneWayPair{wall, pair.shapeB, pair.bodyB, relative(bodies.pose(pair.bodyB), a), relative({}, a)};
    }
    if (pair.staticB) {
        return OneWayPair{wall, pair.shapeA, pair.bodyA, a, a};
    }
    const Transform b = bodies.plannedMotions[pair.bodyB].pose();
    const Transform pose = wallA != nullptr ? relative(b, a) : relative(a, b);
    return wallA != nullptr ? OneWayPair{wall, pair.shapeB, pair.bodyB, pose, pose}
                            : OneWayPair{wall, pair.shapeA, pair.bodyA, pose, pose};
}

PassingBody passingBodyOf(const Bodies& bodies, const OneWayPair& oneWay) {
    return {*bodies.records[oneWay.body].parts, oneWay.pose};
}

Vec2 centerOf(const Part& part) {
    const auto* circle = std::get_if<Circle>(&part);
    return circle != nullptr ? circle->center : std::get<ConvexPart>(part).center;
}

/// Whether the centre of the part is within the depth of the wall, so that the face would stop the part.
bool isHeldBack(const OneWayPair& oneWay) {
    const WallSide face = faceOf(*oneWay.wall, false);
    return face.above(oneWay.partPose.toWorld(centerOf(*oneWay.part))) >= -face.depth - onTheFace;
}

/// A range of the pair table: the pairs of one body with the walls of one other body, or of all static bodies.
struct PairRange {
    std::size_t first, end;
};

PairRange pairsAlong(const PairTable& table, const Pair& pair) {
    const std::uint64_t from = pair.staticB ? std::uint64_t{pair.bodyA} << 32 : pair.key().bodies();
    const std::uint64_t to = pair.staticB ? (std::uint64_t{pair.bodyA} + 1) << 32 : pair.key().bodies() + 1;
    return {table.firstFrom(from), table.firstFrom(to)};
}

/// Searches the one-way walls that a body has pairs with, along their joints. The pair at `index` itself is left out.
class Chain {
  public:
    /// `OrJustLeft` also counts walls that the body has left since the last update: it may leave one wall and enter the
    /// next in the same iteration.
    enum class Count : std::uint8_t { OnTheWay, OrJustLeft };

    Chain(const Bodies& bodies, const PairTable& table, std::uint32_t index, Count count)
        : m_bodies(bodies), m_table(table), m_pair(table.pairs[index]), m_range(pairsAlong(table, m_pair)),
          m_body(bodyAt(m_pair)), m_orJustLeft(count == Count::OrJustLeft) {}

    /// The passage of another part of the body through the same wall; None if there is none. A part that has a new pair
    /// takes it over.
    Passage passageOfBody(const WallPart& wall) const {
        Passage found = Passage::None;
        any([&](const OneWayPair& oneWay, Passage before) {
            const bool comes = before == Passage::Behind || before == Passage::Passing;
            found = comes && isSame(*oneWay.wall, wall) ? before : found;
            return found != Passage::None;
        });
        return found;
    }
    /// Whether another part of the body is on its way through the wall.
    bool isPassed(const WallPart& wall) const {
        return any([&](const OneWayPair& oneWay, Passage before) {
            if (before == Passage::None || !isSame(*oneWay.wall, wall)) {
                return false;
            }
            const PassingBody passing = passingBodyOf(m_bodies, oneWay);
            return isOnItsWay(before, wall, passing) || (m_orJustLeft && hasJustLeft(before, wall, passing));
        });
    }
    /// Whether the body is on its way through the wall, or through one that a chain of joints connects with it. At a
    /// hollow joint a body may pass one wall and touch the front of the next: `throughHollow` says whether the chain
    /// goes on there.
    bool isPassedAnywhere(const WallPart& from, bool throughHollow) const {
        // Room for as many joined walls as a body usually meets: a steady update allocates nothing.
        constexpr std::size_t usualCount = 64;
        std::array<const WallPart*, usualCount> buffer;
        std::pmr::monotonic_buffer_resource memory{buffer.data(), sizeof(buffer)};
        std::pmr::vector<const WallPart*> reached{&memory};
        reached.reserve(usualCount);
        reached.push_back(&from);
        const auto hasReached = [&reached](const WallPart& wall) {
            return std::ranges::any_of(reached, [&](const WallPart* known) { return isSame(*known, wall); });
        };
        for (std::size_t i = 0; i < reached.size(); ++i) {
            if (isPassed(*reached[i])) {
                return true;
            }
            any([&](const OneWayPair& oneWay, Passage) {
                const EdgeJoint joint = jointOf(*oneWay.wall, *reached[i]);
                if ((joint == EdgeJoint::Other || (joint == EdgeJoint::Hollow && throughHollow)) &&
                    !hasReached(*oneWay.wall)) {
                    reached.push_back(oneWay.wall);
                }
                return false;
            });
        }
        return false;
    }

  private:
    static Slot bodyAt(const Pair& pair) {
        return std::holds_alternative<WallPart>(*pair.shapeA) ? pair.bodyB : pair.bodyA;
    }
    static bool isSame(const WallPart& a, const WallPart& b) { return a.a == b.a && a.b == b.b; }
    template <class Test>
    bool any(const Test& test) const {
        for (std::size_t i = m_range.first; i < m_range.end; ++i) {
            const Pair& pair = m_table.pairs[i];
            if (&pair == &m_pair || pair.kind == PairKind::Sensor || pair.staticB != m_pair.staticB) {
                continue;
            }
            const std::optional<OneWayPair> oneWay = oneWayPairOf(m_bodies, pair);
            if (oneWay && oneWay->body == m_body && test(*oneWay, m_table.flags[i].passage)) {
                return true;
            }
        }
        return false;
    }

    const Bodies& m_bodies;
    const PairTable& m_table;
    const Pair& m_pair;
    PairRange m_range;
    Slot m_body; // that meets the wall
    bool m_orJustLeft;
};

/// Whether the surfaces separate at all points of the manifold.
bool isParting(const Bodies& bodies, const Pair& pair, const Manifold& manifold) {
    const auto velocityAt = [&](Slot slot, const Vec2& point) {
        const BodyMotion& m = bodies.motions[slot];
        return Vec2(m.velocity + cross(m.angularVelocity, point - m.center));
    };
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
        const Vec2& point = manifold.points[i].point;
        const Vec2 ofB = pair.staticB ? Vec2(0, 0) : velocityAt(pair.bodyB, point);
        if (!((ofB - velocityAt(pair.bodyA, point)).dot(manifold.normal) > 0)) {
            return false;
        }
    }
    return true;
}

/// A body that has passed this wall is still passing while it passes a joined one.
void stayOpen(const Bodies& bodies, PairTable& table, std::uint32_t index, const WallPart& wall) {
    Passage& passage = table.flags[index].passage;
    if (passage == Passage::Passed &&
        Chain(bodies, table, index, Chain::Count::OnTheWay).isPassedAnywhere(wall, true)) {
        passage = Passage::Passing;
    }
}

} // namespace

bool isOpenFor(const Bodies& bodies, PairTable& table, std::uint32_t index) {
    const std::optional<OneWayPair> oneWay = oneWayPairOf(bodies, table.pairs[index]);
    Passage& passage = table.flags[index].passage;
    if (!oneWay || isNoPassage(passage, *oneWay->wall, oneWay->pose.position)) {
        passage = Passage::None;
        return false;
    }
    const PassingBody passing = passingBodyOf(bodies, *oneWay);
    if (passage == Passage::None && passing.parts.size() > 1) {
        passage = Chain(bodies, table, index, Chain::Count::OnTheWay).passageOfBody(*oneWay->wall);
    }
    passage = nextPassage(passage, *oneWay->wall, passing);
    stayOpen(bodies, table, index, *oneWay->wall);
    // A body wholly behind the wall touches nothing but free ends anyway, and convex joints.
    const bool isJoined = oneWay->wall->joinedAtA || oneWay->wall->joinedAtB;
    return passage == Passage::Passing || (passage == Passage::Behind && (isJoined || isHeldBack(*oneWay)));
}

bool isOpenForCircle(const Bodies& bodies, PairTable& table, std::uint32_t index, const WallSide& side) {
    const Pair& pair = table.pairs[index];
    Passage& passage = table.flags[index].passage;
    if (isNoPassage(passage, side, bodies.plannedMotions[pair.bodyA].center)) {
        passage = Passage::None;
        return false;
    }
    const PassingBody passing{*bodies.records[pair.bodyA].parts, bodies.plannedMotions[pair.bodyA].pose()};
    passage = nextPassage(passage, side, passing);
    stayOpen(bodies, table, index, std::get<WallPart>(*pair.shapeB));
    return passage == Passage::Passing || (passage == Passage::Behind && passing.parts.size() > 1);
}

bool opensAtContact(const Bodies& bodies, PairTable& table, std::uint32_t index, const Manifold& manifold) {
    const std::optional<OneWayPair> oneWay = oneWayPairOf(bodies, table.pairs[index]);
    if (!oneWay) {
        return false;
    }
    double lowest = manifold.points[0].separation;
    if (manifold.count > 1) {
        lowest = std::min(lowest, manifold.points[1].separation);
    }
    const bool comesOut = lowest < -deepInWall || isParting(bodies, table.pairs[index], manifold);
    const bool opens = Chain(bodies, table, index, Chain::Count::OrJustLeft).isPassedAnywhere(*oneWay->wall, comesOut);
    if (opens) {
        table.flags[index].passage = Passage::Passing;
    }
    return opens;
}

bool isPassedByBody(const Bodies& bodies, const PairTable& table, std::uint32_t index) {
    const std::optional<OneWayPair> oneWay = oneWayPairOf(bodies, table.pairs[index]);
    return oneWay && Chain(bodies, table, index, Chain::Count::OnTheWay).isPassed(*oneWay->wall);
}

} // namespace spacetow
