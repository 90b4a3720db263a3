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

// m: beyond what contacts leave of overlaps, and what comes from the front may have
constexpr double deepInWall = 2 * linearSlop;

/// The one-way wall of a pair, and the body that meets it.
struct Door {
    const WallPart* wall;
    const Part* part;
    Slot body;
    Transform pose;     // of the body, in the coordinates of the wall
    Transform partPose; // likewise; parts of static bodies are in world coordinates
};

std::optional<Door> doorOf(const Bodies& bodies, const Pair& pair) {
    const auto* wallA = std::get_if<WallPart>(pair.shapeA);
    const auto* wallB = std::get_if<WallPart>(pair.shapeB);
    const WallPart* wall = wallA != nullptr ? wallA : wallB;
    if (wall == nullptr || (wallA != nullptr && wallB != nullptr) || !letsThrough(*wall)) {
        return std::nullopt;
    }
    const Transform a = bodies.plannedMotions[pair.bodyA].pose();
    if (pair.staticB && wallA != nullptr) {
        return Door{wall, pair.shapeB, pair.bodyB, relative(bodies.pose(pair.bodyB), a), relative({}, a)};
    }
    if (pair.staticB) {
        return Door{wall, pair.shapeA, pair.bodyA, a, a};
    }
    const Transform b = bodies.plannedMotions[pair.bodyB].pose();
    const Transform pose = wallA != nullptr ? relative(b, a) : relative(a, b);
    return wallA != nullptr ? Door{wall, pair.shapeB, pair.bodyB, pose, pose}
                            : Door{wall, pair.shapeA, pair.bodyA, pose, pose};
}

Passer passerAt(const Bodies& bodies, const Door& door) {
    return {*bodies.records[door.body].parts, door.pose};
}

Vec2 centerOf(const Part& part) {
    const auto* circle = std::get_if<Circle>(&part);
    return circle != nullptr ? circle->center : std::get<ConvexPart>(part).center;
}

/// Whether the part itself is no farther behind the wall than the depth, so that the face would stop it.
bool isHeldBack(const Door& door) {
    const WallSide face = faceOf(*door.wall, false);
    return face.above(door.partPose.toWorld(centerOf(*door.part))) >= -face.depth - onTheFace;
}

/// The pairs of a body with walls in the same coordinates as that of the pair: of its own body, or static.
struct PairRange {
    std::size_t first, last;
};

PairRange pairsAlong(const PairTable& table, const Pair& pair) {
    const auto isBefore = [](const Pair& p, std::uint64_t key) { return p.bodies() < key; };
    const std::uint64_t from = pair.staticB ? std::uint64_t{pair.bodyA} << 32 : pair.bodies();
    const std::uint64_t to = pair.staticB ? (std::uint64_t{pair.bodyA} + 1) << 32 : pair.bodies() + 1;
    const auto first = std::lower_bound(table.pairs.begin(), table.pairs.end(), from, isBefore);
    const auto last = std::lower_bound(first, table.pairs.end(), to, isBefore);
    return {static_cast<std::size_t>(first - table.pairs.begin()),
            static_cast<std::size_t>(last - table.pairs.begin())};
}

/// Walks from wall to wall along joints, over those that the body has pairs with.
class Chain {
  public:
    /// In one iteration the one wall may be left and the next one entered.
    enum class Count : std::uint8_t { OnTheWay, OrJustLeft };

    Chain(const Bodies& bodies, const PairTable& table, std::uint32_t index, Count count)
        : m_bodies(bodies), m_table(table), m_pair(table.pairs[index]), m_range(pairsAlong(table, m_pair)),
          m_body(bodyAt(m_pair)), m_orJustLeft(count == Count::OrJustLeft) {}

    /// Of another part through the same wall: pairs of parts come and go.
    Passage passageOfBody(const WallPart& wall) const {
        Passage found = Passage::None;
        any([&](const Door& door, Passage before) {
            const bool comes = before == Passage::Behind || before == Passage::Between;
            found = comes && isSame(*door.wall, wall) ? before : found;
            return found != Passage::None;
        });
        return found;
    }
    bool isPassed(const WallPart& wall) const {
        return any([&](const Door& door, Passage before) {
            if (before == Passage::None || !isSame(*door.wall, wall)) {
                return false;
            }
            const Passer passer = passerAt(m_bodies, door);
            return isOnItsWay(before, wall, passer) || (m_orJustLeft && hasJustLeft(before, wall, passer));
        });
    }
    /// Of others than the pair itself; through hollow joints, too, or not: there what passes one wall may meet the
    /// front of the next.
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
            any([&](const Door& door, Passage) {
                const EdgeJoint joint = jointOf(*door.wall, *reached[i]);
                if ((joint == EdgeJoint::Other || (joint == EdgeJoint::Hollow && throughHollow)) &&
                    !hasReached(*door.wall)) {
                    reached.push_back(door.wall);
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
        for (std::size_t i = m_range.first; i < m_range.last; ++i) {
            const Pair& pair = m_table.pairs[i];
            if (&pair == &m_pair || pair.kind == PairKind::Sensor || pair.staticB != m_pair.staticB) {
                continue;
            }
            const std::optional<Door> door = doorOf(m_bodies, pair);
            if (door && door->body == m_body && test(*door, m_table.flags[i].passage)) {
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

/// Whether the parts move apart at all points of a contact.
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

/// Whoever is out of this wall may still be in one that is joined to it.
void stayOpen(const Bodies& bodies, PairTable& table, std::uint32_t index, const WallPart& wall) {
    Passage& passage = table.flags[index].passage;
    if (passage == Passage::Left && Chain(bodies, table, index, Chain::Count::OnTheWay).isPassedAnywhere(wall, true)) {
        passage = Passage::Between;
    }
}

} // namespace

bool isOpenFor(const Bodies& bodies, PairTable& table, std::uint32_t index) {
    const std::optional<Door> door = doorOf(bodies, table.pairs[index]);
    Passage& passage = table.flags[index].passage;
    if (!door || isNoPassage(passage, *door->wall, door->pose.position)) {
        passage = Passage::None;
        return false;
    }
    const Passer passer = passerAt(bodies, *door);
    if (passage == Passage::None && passer.parts.size() > 1) {
        passage = Chain(bodies, table, index, Chain::Count::OnTheWay).passageOfBody(*door->wall);
    }
    passage = nextPassage(passage, *door->wall, passer);
    stayOpen(bodies, table, index, *door->wall);
    // What is behind altogether meets free ends alone as it is, but for the corners of joints.
    const bool isJoined = door->wall->joinedAtA || door->wall->joinedAtB;
    return passage == Passage::Between || (passage == Passage::Behind && (isJoined || isHeldBack(*door)));
}

bool isOpenForCircle(const Bodies& bodies, PairTable& table, std::uint32_t index, const WallSide& side) {
    const Pair& pair = table.pairs[index];
    Passage& passage = table.flags[index].passage;
    if (isNoPassage(passage, side, bodies.plannedMotions[pair.bodyA].center)) {
        passage = Passage::None;
        return false;
    }
    const Passer passer{*bodies.records[pair.bodyA].parts, bodies.plannedMotions[pair.bodyA].pose()};
    passage = nextPassage(passage, side, passer);
    stayOpen(bodies, table, index, std::get<WallPart>(*pair.shapeB));
    return passage == Passage::Between || (passage == Passage::Behind && passer.parts.size() > 1);
}

bool opensAtContact(const Bodies& bodies, PairTable& table, std::uint32_t index, const Manifold& manifold) {
    const std::optional<Door> door = doorOf(bodies, table.pairs[index]);
    if (!door) {
        return false;
    }
    double lowest = manifold.points[0].separation;
    if (manifold.count > 1) {
        lowest = std::min(lowest, manifold.points[1].separation);
    }
    const bool comesOut = lowest < -deepInWall || isParting(bodies, table.pairs[index], manifold);
    const bool opens = Chain(bodies, table, index, Chain::Count::OrJustLeft).isPassedAnywhere(*door->wall, comesOut);
    if (opens) {
        table.flags[index].passage = Passage::Between;
    }
    return opens;
}

bool isPassedByBody(const Bodies& bodies, const PairTable& table, std::uint32_t index) {
    const std::optional<Door> door = doorOf(bodies, table.pairs[index]);
    return door && Chain(bodies, table, index, Chain::Count::OnTheWay).isPassed(*door->wall);
}

} // namespace spacetow
