#include "core/geometry/collide_pairs.h"
#include "core/geometry/wall_side.h"

namespace spacetow {

namespace {

enum CircleFeature : unsigned { WallFace, WallPoint, ConvexFace, ConvexPoint };

/// Contact of a circle with a point; `fallback` is the normal when the centre is on it.
Manifold pointAgainstCircle(const Vec2& point, const Circle& circle, const Vec2& fallback, double margin) {
    Manifold manifold;
    const Vec2 apart = circle.center - point;
    const double distance = apart.norm();
    if (!(distance - circle.radius <= margin)) {
        return manifold;
    }
    manifold.normal = distance > 1e-9 ? Vec2(apart / distance) : fallback;
    addPoint(manifold, 0.5 * (point + circle.center - circle.radius * manifold.normal), distance - circle.radius, 0);
    return manifold;
}

Manifold named(Manifold manifold, std::uint32_t feature) {
    manifold.points[0].feature = feature;
    return manifold;
}

/// The wall's face stops the circle, wherever its surface is.
Manifold faceAgainstCircle(const WallSide& side, const Circle& circle, double margin) {
    Manifold manifold;
    const double above = side.above(circle.center);
    if (above - circle.radius <= margin) {
        manifold.normal = side.normal;
        const double toMiddle = 0.5 * (above + circle.radius);
        addPoint(manifold, circle.center - toMiddle * side.normal, above - circle.radius,
                 featureId(WallFace, side.turned ? 1 : 0, 0));
    }
    return manifold;
}

/// How far a circle is at least from what is solid behind the face; 0 when that is not known.
double clearance(const WallSide& side, const Circle& circle) {
    const double t = side.along(circle.center);
    const double beyond = std::max({t - side.length, -t, 0.0});
    const double above = std::max(side.above(circle.center), 0.0);
    return std::max(std::sqrt(beyond * beyond + above * above) - circle.radius, 0.0);
}

/// The side of a wall that faces the circle, and is not held by its face, against it.
Manifold endsAgainstCircle(const WallSide& side, const Circle& circle, double margin) {
    const int turned = side.turned ? 1 : 0;
    const double t = side.along(circle.center);
    if (t > side.length && side.end.kind == WallEnd::Kind::Convex) {
        const Vec2 outward = circle.center - side.end.point;
        const bool mine = side.end.nextDirection.dot(outward) <= 1e-9;
        return mine ? named(pointAgainstCircle(side.end.point, circle, side.normal, margin),
                            featureId(WallPoint, turned, 1))
                    : Manifold{};
    }
    // Over the span the face is open from here (from behind, deeper than its depth): only the nearer end is left.
    const bool atEnd = t > 0.5 * side.length;
    for (const bool useEnd : {atEnd, !atEnd}) {
        const WallEnd& end = useEnd ? side.end : side.start;
        const bool beyondTheOther = useEnd ? t < 0 : t > side.length;
        if (end.kind == WallEnd::Kind::Free && !beyondTheOther) {
            return named(pointAgainstCircle(end.point, circle, side.normal, margin),
                         featureId(WallPoint, turned, useEnd ? 1 : 0));
        }
    }
    return {};
}

} // namespace

Manifold sideAgainstCircle(const WallSide& side, const Circle& circle, double margin) {
    if (side.along(circle.center) >= 0 && side.along(circle.center) <= side.length &&
        side.above(circle.center) - circle.radius > margin) {
        return noContact(side.above(circle.center) - circle.radius);
    }
    const Manifold manifold =
        side.holds(circle.center) ? faceAgainstCircle(side, circle, margin) : endsAgainstCircle(side, circle, margin);
    return manifold.count > 0 ? manifold : noContact(clearance(side, circle));
}

Manifold wallAgainstCircle(const WallPart& wall, const Circle& circle, double margin) {
    return sideAgainstCircle(sideFacing(wall, circle.center), circle, margin);
}

namespace {

/// Cuts may divide the plane of a face: the face on it that is nearest to `p` along the plane.
int nearestOfPlane(const ConvexPart& convex, int face, const Vec2& p) {
    const Vec2& normal = normalOf(convex, face);
    const Vec2 direction = leftOf(normal);
    int best = face;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < convex.count; ++i) {
        const double before = direction.dot(cornerOf(convex, i) - p);
        const double beyond = direction.dot(p - cornerOf(convex, cornerAfter(convex, i)));
        const double aside = std::max({before, beyond, 0.0});
        if (aside < nearest && normalOf(convex, i).dot(normal) > 1 - 1e-9) {
            nearest = aside;
            best = i;
        }
    }
    return best;
}

} // namespace

Manifold convexAgainstCircle(const ConvexPart& convex, const Circle& circle, double margin) {
    Manifold manifold;
    int best = 0;
    int bestOuter = -1;
    double separation = -std::numeric_limits<double>::infinity();
    double outerSeparation = separation;
    for (int i = 0; i < convex.count; ++i) {
        const double s = normalOf(convex, i).dot(circle.center - cornerOf(convex, i));
        if (s - circle.radius > margin) {
            return noContact(s - circle.radius);
        }
        if (s > separation) {
            separation = s;
            best = i;
        }
        if (s > outerSeparation && isOuterFace(convex, i)) {
            outerSeparation = s;
            bestOuter = i;
        }
    }
    if (separation > 0) {
        best = isCut(convex) ? nearestOfPlane(convex, best, circle.center) : best;
        const Vec2& from = cornerOf(convex, best);
        const int next = cornerAfter(convex, best);
        const Vec2 direction = leftOf(normalOf(convex, best));
        int corner = -1;
        if (direction.dot(circle.center - from) < 0) {
            corner = best;
        } else if (direction.dot(circle.center - cornerOf(convex, next)) > 0) {
            corner = next;
        }
        if (corner >= 0) {
            const Vec2 fallback = normalOf(convex, best);
            manifold = pointAgainstCircle(cornerOf(convex, corner), circle, fallback, margin);
            const bool allowed = cornerAllows(convex, corner, manifold.normal);
            return allowed ? named(manifold, featureId(ConvexPoint, corner, 0)) : Manifold{};
        }
        if (!isOuterFace(convex, best)) {
            return manifold; // the centre is in the part beyond the cut
        }
        bestOuter = best;
        outerSeparation = separation;
    }
    if (bestOuter >= 0) {
        manifold.normal = normalOf(convex, bestOuter);
        const Vec2 middle = circle.center - 0.5 * (outerSeparation + circle.radius) * manifold.normal;
        addPoint(manifold, middle, outerSeparation - circle.radius, featureId(ConvexFace, bestOuter, 0));
    }
    return manifold;
}

} // namespace spacetow
