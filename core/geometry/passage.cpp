#include "core/geometry/passage.h"

#include "core/geometry/collide_pairs.h"
#include "core/geometry/near_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

// m in front of a wall beyond which nothing counts as touching it
constexpr double clearOfWall = 0.0005;

/// The stretch over which something counts as being at the wall, m from its start: with what continues it in the same
/// plane or ahead of it, which opens and closes with it.
struct Stretch {
    double from, to;

    explicit Stretch(const WallSide& side)
        : from(side.start.kind == WallEnd::Kind::Smooth ? -(side.start.point - side.start.next).norm() : 0),
          to(side.length + (side.end.kind == WallEnd::Kind::Smooth ? (side.end.next - side.end.point).norm() : 0)) {}

    bool has(double t) const { return t >= from && t <= to; }
};

constexpr double nothing = std::numeric_limits<double>::infinity();

double lowestOver(const Stretch& over, const Vec2& center, double radius) {
    if (center.x() + radius <= over.from || center.x() - radius >= over.to) {
        return nothing;
    }
    const double beside = std::clamp(center.x(), over.from, over.to) - center.x();
    return center.y() - std::sqrt(std::max(radius * radius - beside * beside, 0.0));
}

/// Of the segment from one point to another.
double lowestOver(const Stretch& over, const Vec2& from, const Vec2& to) {
    const Vec2& left = from.x() <= to.x() ? from : to;
    const Vec2& right = from.x() <= to.x() ? to : from;
    if (right.x() <= over.from || left.x() >= over.to) {
        return nothing;
    }
    const auto heightAt = [&](double t) {
        const double share = (t - left.x()) / (right.x() - left.x());
        return left.y() + share * (right.y() - left.y());
    };
    const double atLeft = left.x() < over.from ? heightAt(over.from) : left.y();
    const double atRight = right.x() > over.to ? heightAt(over.to) : right.y();
    return std::min(atLeft, atRight);
}

/// Takes in one part of a body after the other.
struct Survey {
    const WallSide& side;
    const PassingBody& passing;
    Stretch over{side};
    double lowest = nothing;         // m above the face, of what is over the wall
    double highest = -nothing;       // of all
    double highestCenter = -nothing; // of the parts over the wall

    Survey(const WallSide& s, const PassingBody& p) : side(s), passing(p) {
        for (const Part& part : passing.parts) {
            std::visit(*this, part);
        }
    }
    Vec2 seen(const Vec2& local) const {
        const Vec2 p = passing.pose.toWorld(local);
        return {side.along(p), side.above(p)};
    }
    /// Beyond a hollow joint nothing is in front of the wall that is behind its neighbour.
    void noteCenter(const Vec2& local) {
        const Vec2 p = passing.pose.toWorld(local);
        const double t = side.along(p);
        if (over.has(t)) {
            const WallEnd* joint = t < 0 ? &side.start : t > side.length ? &side.end : nullptr;
            const double beside = joint != nullptr ? joint->nextNormal.dot(p - joint->point) : nothing;
            highestCenter = std::max(highestCenter, std::min(side.above(p), beside));
        }
    }
    void operator()(const Circle& circle) {
        const Vec2 center = seen(circle.center);
        lowest = std::min(lowest, lowestOver(over, center, circle.radius));
        highest = std::max(highest, center.y() + circle.radius);
        noteCenter(circle.center);
    }
    void operator()(const WallPart& wall) {
        const Vec2 from = seen(wall.a);
        const Vec2 to = seen(wall.b);
        lowest = std::min(lowest, lowestOver(over, from, to));
        highest = std::max({highest, from.y(), to.y()});
        noteCenter(0.5 * (wall.a + wall.b));
    }
    void operator()(const ConvexPart& convex) {
        Vec2 from = seen(cornerOf(convex, convex.count - 1));
        for (int i = 0; i < convex.count; ++i) {
            const Vec2 to = seen(cornerOf(convex, i));
            lowest = std::min(lowest, lowestOver(over, from, to));
            highest = std::max(highest, to.y());
            from = to;
        }
        noteCenter(convex.center);
    }

    Passage passage(Passage before) const {
        if (lowest > clearOfWall) {
            return before == Passage::Passing ? Passage::Passed : Passage::None;
        }
        const Vec2 center = seen({0, 0});
        const bool deep = side.isDeeperThanDepth(passing.pose.position);
        // What hooks around an end has a part in front of the wall, and its centre behind.
        const bool comes = isComing(before) || passing.parts.size() == 1 || highestCenter < -onTheFace;
        if (deep && comes && over.has(center.x())) {
            return Passage::Behind;
        }
        return isComing(before) ? Passage::Passing : Passage::None;
    }
    static bool isComing(Passage before) { return before == Passage::Behind || before == Passage::Passing; }
};

bool meet(const Vec2& a, const Vec2& b) {
    return (a - b).squaredNorm() <= jointTolerance * jointTolerance;
}

/// The deeper of both contacts, or how far both are at least apart.
Manifold deeper(const Manifold& a, const Manifold& b) {
    if (a.count == 0 && b.count == 0) {
        return noContact(std::min(a.apart, b.apart));
    }
    const bool first = b.count == 0 || (a.count > 0 && a.points[0].separation <= b.points[0].separation);
    return first ? a : b;
}

} // namespace

Passage nextPassage(Passage before, const WallPart& wall, const PassingBody& passing) {
    return isNoPassage(before, wall, passing.pose.position) ? Passage::None
                                                            : Survey(sideOf(wall, false), passing).passage(before);
}

Passage nextPassage(Passage before, const WallSide& side, const PassingBody& passing) {
    return isNoPassage(before, side, passing.pose.position) ? Passage::None : Survey(side, passing).passage(before);
}

bool isOnItsWay(Passage before, const WallPart& wall, const PassingBody& passing) {
    if (before == Passage::None || before == Passage::Passed) {
        return false;
    }
    const WallSide side = sideOf(wall, false);
    const Survey survey(side, passing);
    const Passage now = survey.passage(before);
    return now == Passage::Passing || (now == Passage::Behind && survey.highest > -side.depth);
}

bool hasJustLeft(Passage before, const WallPart& wall, const PassingBody& passing) {
    return before == Passage::Passed || nextPassage(before, wall, passing) == Passage::Passed;
}

EdgeJoint jointOf(const WallPart& a, const WallPart& b) {
    const auto leads = [](const WallPart& first, const WallPart& second) {
        return first.joinedAtB && second.joinedAtA && meet(first.b, second.a) && meet(first.afterB, second.b);
    };
    const auto kind = [](const WallPart& first, const WallPart& second) {
        const Vec2 before = first.b - first.a;
        const Vec2 after = second.b - second.a;
        constexpr double straight = 1e-6; // sine
        return cross(before, after) > straight * before.norm() * after.norm() ? EdgeJoint::Hollow : EdgeJoint::Other;
    };
    return leads(a, b) ? kind(a, b) : (leads(b, a) ? kind(b, a) : EdgeJoint::None);
}

// NOLINTNEXTLINE(readability-function-size): two parts where they are, and how near
Manifold collideOpenWall(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB, double margin) {
    const auto* wallA = std::get_if<WallPart>(&a);
    const WallPart& wall = wallA != nullptr ? *wallA : std::get<WallPart>(b);
    const auto atEnd = [&](const Vec2& end, bool joined) {
        const Part point = Circle{end, 0};
        return joined ? noContact(std::numeric_limits<double>::infinity())
                      : collide(wallA != nullptr ? point : a, poseA, wallA != nullptr ? b : point, poseB, margin);
    };
    return deeper(atEnd(wall.a, wall.joinedAtA), atEnd(wall.b, wall.joinedAtB));
}

} // namespace spacetow
