#include "core/geometry/collide.h"

#include "core/geometry/collide_pairs.h"
#include "core/geometry/moved.h"

namespace spacetow {

namespace {

Manifold flipped(Manifold manifold) {
    manifold.normal = -manifold.normal;
    if (manifold.normalOf != NormalOf::Corners) {
        const bool first = manifold.normalOf == NormalOf::FirstFace;
        manifold.normalOf = first ? NormalOf::SecondFace : NormalOf::FirstFace;
    }
    return manifold;
}

/// From the coordinates of `frame` to the world.
Manifold toWorld(Manifold manifold, const Transform& frame) {
    manifold.normal = frame.rotation * manifold.normal;
    for (int i = 0; i < manifold.count; ++i) {
        Vec2& point = manifold.points[static_cast<std::size_t>(i)].point;
        point = frame.toWorld(point);
    }
    return manifold;
}

Manifold circleAgainstCircle(const Circle& a, const Circle& b, double margin) {
    Manifold manifold;
    const Vec2 apart = b.center - a.center;
    const double distance = apart.norm();
    const double separation = distance - (a.radius + b.radius);
    if (!(separation <= margin)) {
        manifold.apart = separation;
        return manifold;
    }
    manifold.normal = distance > 0 ? Vec2(apart / distance) : Vec2(0, 1);
    const Vec2 onA = a.center + a.radius * manifold.normal;
    const Vec2 onB = b.center - b.radius * manifold.normal;
    addPoint(manifold, 0.5 * (onA + onB), separation, 0);
    return manifold;
}

/// Chooses the routine and the coordinates for each pair. A pair in the other order is turned round.
struct PairCollider {
    const Transform& poseA;
    const Transform& poseB;
    double margin;

    PairCollider reversed() const { return {poseB, poseA, margin}; }

    Manifold operator()(const Circle& a, const Circle& b) const {
        return circleAgainstCircle(moved(a, poseA), moved(b, poseB), margin);
    }
    Manifold operator()(const WallPart& a, const Circle& b) const {
        const Circle circle{poseA.toLocal(poseB.toWorld(b.center)), b.radius};
        return toWorld(wallAgainstCircle(a, circle, margin), poseA);
    }
    Manifold operator()(const ConvexPart& a, const Circle& b) const {
        const Circle circle{poseA.toLocal(poseB.toWorld(b.center)), b.radius};
        return toWorld(convexAgainstCircle(a, circle, margin), poseA);
    }
    Manifold operator()(const WallPart& a, const ConvexPart& b) const {
        return toWorld(wallAgainstConvex(moved(a, relative(poseA, poseB)), b, margin), poseB);
    }
    Manifold operator()(const ConvexPart& a, const ConvexPart& b) const {
        return toWorld(convexAgainstConvex(a, moved(b, relative(poseB, poseA)), margin), poseA);
    }
    Manifold operator()(const WallPart&, const WallPart&) const { return {}; }

    Manifold operator()(const Circle& a, const WallPart& b) const { return flipped(reversed()(b, a)); }
    Manifold operator()(const Circle& a, const ConvexPart& b) const { return flipped(reversed()(b, a)); }
    Manifold operator()(const ConvexPart& a, const WallPart& b) const { return flipped(reversed()(b, a)); }
};

struct CircleCollider {
    const Circle& circle;
    double margin;

    Manifold operator()(const Circle& part) const { return circleAgainstCircle(part, circle, margin); }
    Manifold operator()(const ConvexPart& part) const { return convexAgainstCircle(part, circle, margin); }
    Manifold operator()(const WallPart& part) const { return wallAgainstCircle(part, circle, margin); }
};

} // namespace

Manifold collideCircle(const Part& part, const Circle& circle, double margin) {
    return std::visit(CircleCollider{circle, margin}, part);
}

// NOLINTNEXTLINE(readability-function-size): two parts where they are, and how near
Manifold collide(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB, double margin) {
    return std::visit(PairCollider{poseA, poseB, margin}, a, b);
}

} // namespace spacetow
