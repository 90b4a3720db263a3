#pragma once
// The pairs of the narrow phase, each in the coordinates of one of its parts. Used by collide.cpp; everything else
// calls collide().

#include "core/geometry/collide.h"

namespace spacetow {

/// Both in the same coordinates; the normal points from the wall to the circle.
Manifold wallAgainstCircle(const WallPart& wall, const Circle& circle, double margin);
/// Both in the same coordinates; the normal points from the polygon to the circle. The radius may be 0.
Manifold convexAgainstCircle(const ConvexPart& convex, const Circle& circle, double margin);
/// Both in the same coordinates; the normal points from the wall to the polygon.
Manifold wallAgainstConvex(const WallPart& wall, const ConvexPart& convex, double margin);
/// Both in the same coordinates; the normal points from a to b.
Manifold convexAgainstConvex(const ConvexPart& a, const ConvexPart& b, double margin);

/// The margin for the two ends of a side; `nearest` is the separation of the nearer end, m. Doubled for parts of a
/// concave polygon once one end is within the margin: the speculative margin of thin parts is small, so a part that
/// lands on one end would turn about it and hit with the other end before the time of impact sweeps it.
inline double marginOfEnds(const ConvexPart& part, double nearest, double margin) {
    return isCut(part) && nearest <= margin ? 2 * margin : margin;
}

/// Whether the direction `u` lies between the normals of two faces that meet at a convex corner.
inline bool liesBetween(const Vec2& before, const Vec2& after, const Vec2& u) {
    constexpr double slack = 1e-9;
    return cross(before, after) > slack && cross(before, u) >= -slack && cross(u, after) >= -slack;
}

/// Whether the corner may have a contact with the outward unit normal `u`: it has to lie between the normals of the two
/// faces of the outline that meet at the corner (its Gauss arc), which need not be faces of this part. If several parts
/// share the corner, only the one whose outer face starts there has the contact.
inline bool cornerAllows(const ConvexPart& part, int i, const Vec2& u) {
    if (!isCut(part)) {
        return true; // both faces are its own: the direction to the nearest point lies between their normals
    }
    return isOuterFace(part, i) && liesBetween(part.normalsBeyond[static_cast<std::size_t>(i)], normalOf(part, i), u);
}

/// The same for a contact with a face: the part whose outer face ends at the corner has it too, so that the order of
/// parts does not matter. Both contacts lie in one plane.
inline bool cornerSupports(const ConvexPart& part, int i, const Vec2& u) {
    const int before = cornerBefore(part, i);
    return cornerAllows(part, i, u) ||
           (!isOuterFace(part, i) && isOuterFace(part, before) &&
            liesBetween(normalOf(part, before), part.normalsBeyond[static_cast<std::size_t>(i)], u));
}

/// The corner farthest along −u.
inline int deepestCorner(const ConvexPart& part, const Vec2& u) {
    int deepest = 0;
    double least = u.dot(part.corners[0]);
    for (int i = 1; i < part.count; ++i) {
        const double d = u.dot(cornerOf(part, i));
        if (d < least) {
            least = d;
            deepest = i;
        }
    }
    return deepest;
}

/// The face whose normal is nearest to −u: the incident face.
inline int facing(const ConvexPart& part, const Vec2& u) {
    int best = 0;
    double least = u.dot(part.normals[0]);
    for (int i = 1; i < part.count; ++i) {
        const double d = u.dot(normalOf(part, i));
        if (d < least) {
            least = d;
            best = i;
        }
    }
    return best;
}

/// The feature of a contact point: kind of contact, then the two features that touch.
inline std::uint32_t featureId(unsigned kind, int first, int second) {
    return kind << 16 | static_cast<unsigned>(first) << 8 | static_cast<unsigned>(second);
}

inline Manifold noContact(double apart) {
    Manifold manifold;
    manifold.apart = apart;
    return manifold;
}

inline void addPoint(Manifold& manifold, const Vec2& point, double separation, std::uint32_t feature) {
    manifold.points[static_cast<std::size_t>(manifold.count++)] = {point, separation, feature};
}

} // namespace spacetow
