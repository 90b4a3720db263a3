#include "core/geometry/passage.h"

#include "core/geometry/collide_pairs.h"
#include "core/geometry/moved.h"
#include "core/geometry/polygon_at_wall.h"

#include <algorithm>
#include <limits>

namespace spacetow {

namespace {

// m in front of a wall beyond which nothing counts as touching it
constexpr double clearOfWall = 0.0005;

/// What lies over a wall, in coordinates along it and above it, m.
struct Profile {
    Extent along;
    double lowest = std::numeric_limits<double>::infinity();
    Vec2 center{0, 0};
    double deepest = 0; // of the centre and, for a piece of a concave polygon, of the centre of the whole
};

Profile profileOf(const WallSide& side, const Circle& circle) {
    const double t = side.along(circle.center);
    const double above = side.above(circle.center);
    return {{t - circle.radius, t + circle.radius}, above - circle.radius, {t, above}, above};
}

Profile profileOf(const WallSide& side, const ConvexPart& convex) {
    const Vec2 center(side.along(convex.center), side.above(convex.center));
    const double whole = isCut(convex) ? std::min(side.above(convex.whole), onTheFace) : center.y();
    return {extentAlong(side, convex), side.above(cornerOf(convex, deepestCorner(convex, side.normal))), center,
            std::max(center.y(), whole)};
}

/// Beyond a smooth joint what continues the wall lies in the same plane or ahead of it: there is one door for both.
bool isOver(const WallSide& side, const Profile& profile) {
    const double t = profile.center.x();
    const bool beforeStart = t < 0 && side.start.kind != WallEnd::Kind::Smooth;
    const bool beyondEnd = t > side.length && side.end.kind != WallEnd::Kind::Smooth;
    return !beforeStart && !beyondEnd;
}

template <class Other>
Passage passageAt(Passage before, const WallSide& side, const Other& other) {
    const Profile profile = profileOf(side, other);
    if (profile.lowest > clearOfWall || profile.along.to <= 0 || profile.along.from >= side.length) {
        return Passage::None;
    }
    if (isOver(side, profile) && profile.deepest < -side.depth - onTheFace) {
        return Passage::Behind;
    }
    return before == Passage::None ? Passage::None : Passage::Between;
}

struct PassageFinder {
    Passage before;
    const Transform& poseA;
    const Transform& poseB;

    template <class Other>
    Passage at(const WallPart& wall, const Other& other) const {
        const bool lets = wall.oneWay && wall.depth < noBack;
        // What is in front was never behind, as nearly always.
        if (!lets || (before == Passage::None && cross(wall.b - wall.a, other.center - wall.a) >= 0)) {
            return Passage::None;
        }
        return passageAt(before, sideOf(wall, false), other);
    }
    Passage operator()(const WallPart& a, const Circle& b) const {
        return at(a, Circle{poseA.toLocal(poseB.toWorld(b.center)), b.radius});
    }
    Passage operator()(const WallPart& a, const ConvexPart& b) const { return at(moved(a, relative(poseA, poseB)), b); }
    Passage operator()(const Circle& a, const WallPart& b) const { return PassageFinder{before, poseB, poseA}(b, a); }
    Passage operator()(const ConvexPart& a, const WallPart& b) const {
        return PassageFinder{before, poseB, poseA}(b, a);
    }
    template <class A, class B>
    Passage operator()(const A&, const B&) const {
        return Passage::None;
    }
};

/// The deeper of both contacts, or how far both are at least apart.
Manifold deeper(const Manifold& a, const Manifold& b) {
    if (a.count == 0 && b.count == 0) {
        return noContact(std::min(a.apart, b.apart));
    }
    const bool first = b.count == 0 || (a.count > 0 && a.points[0].separation <= b.points[0].separation);
    return first ? a : b;
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): two parts where they are and were
Passage nextPassage(Passage before, const Part& a, const Transform& poseA, const Part& b, const Transform& poseB) {
    return std::visit(PassageFinder{before, poseA, poseB}, a, b);
}

Passage nextPassage(Passage before, const WallSide& side, const Circle& circle) {
    const bool lets = side.depth < noBack;
    if (!lets || (before == Passage::None && side.above(circle.center) >= 0)) {
        return Passage::None;
    }
    return passageAt(before, side, circle);
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
