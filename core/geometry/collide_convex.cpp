#include "core/geometry/clip.h"
#include "core/geometry/collide_pairs.h"
#include "core/geometry/intersect.h"
#include "core/geometry/near_points.h"
#include "core/geometry/supporting_corners.h"

namespace spacetow {

namespace {

enum Feature : unsigned { CornerOfFirst = 16, CornerOfSecond, CornerToCorner };

constexpr double tie = sameDepth;

// Something that has come a little way through a cut, and so through the thin end of the part beyond it, is that
// part's affair; the outer faces of this one are far away and would throw it out in the wrong direction.
constexpr double littleWay = 0.02; // m
constexpr double farAway = 0.002;  // m beyond twice the way

constexpr double notchTurn = 1e-6; // sine: the outline turns inwards

constexpr double none = -std::numeric_limits<double>::infinity();

struct Axis {
    double separation = none; // largest of all faces
    int face = -1;
    double allowed = none; // largest of those that may be contact normals
    int allowedFace = -1;
};

/// Separations along the face normals of `reference`; the rest of them is skipped once one exceeds the margin.
Axis bestAxis(const ConvexPart& reference, const ConvexPart& other, double margin) {
    Axis axis;
    const bool cut = isCut(reference) || isCut(other);
    for (int i = 0; i < reference.count; ++i) {
        const Vec2& normal = normalOf(reference, i);
        double least = normal.dot(other.corners[0]);
        for (int k = 1; k < other.count; ++k) {
            least = std::min(least, normal.dot(cornerOf(other, k)));
        }
        const double separation = least - normal.dot(cornerOf(reference, i));
        if (separation > axis.separation) {
            axis.separation = separation;
            axis.face = i;
            if (separation > margin) {
                return axis;
            }
        }
        if (cut && separation > axis.allowed && isOuterFace(reference, i) && mayBeReferenceFace(reference, i, other) &&
            levelSupports(other, deepestCorner(other, normal), reference, i)) {
            axis.allowed = separation;
            axis.allowedFace = i;
        }
    }
    if (!cut) {
        axis.allowed = axis.separation;
        axis.allowedFace = axis.face;
    }
    return axis;
}

double faceLength(const ConvexPart& part, int face) {
    return leftOf(normalOf(part, face)).dot(cornerOf(part, cornerAfter(part, face)) - cornerOf(part, face));
}

/// A face of one part, which keeps still while the other part is clipped to it.
struct Reference {
    const ConvexPart& part;
    int face;
    bool swapped; // it is the second of the parts
};

/// How far beyond a corner the plane of a face bears, m: where a face of another part continues it, no gap is left.
double reachBeyond(const ConvexPart& part, int face, int corner) {
    const bool joined = isCut(part) && isOuterFace(part, corner) != isOuterFace(part, cornerBefore(part, corner));
    const Vec2& beyond = part.normalsBeyond[static_cast<std::size_t>(corner)];
    const bool straight = joined && normalOf(part, face).dot(beyond) > 0 &&
                          std::fabs(cross(normalOf(part, face), beyond)) <= parallelTurn;
    return straight ? jointTolerance : 0;
}

/// Contact with the normal of the face. A point is named after the corner that ends the stretch on which
/// the two sides face each other, so that the name does not depend on which of the parts is the reference.
Manifold faceManifold(const Reference& of, const ConvexPart& other, double margin) {
    const ConvexPart& reference = of.part;
    const int face = of.face;
    const Vec2& normal = normalOf(reference, face);
    const Vec2& from = cornerOf(reference, face);
    const int opposite = facing(other, normal);
    const std::array<int, 2> corners{opposite, cornerAfter(other, opposite)};
    const std::array<int, 2> ends{face, cornerAfter(reference, face)};
    const double before = reachBeyond(reference, face, ends[0]);
    const double length = before + faceLength(reference, face) + reachBeyond(reference, face, ends[1]);
    const auto clipped = clipToFace(from - before * leftOf(normal), leftOf(normal), length,
                                    {cornerOf(other, corners[0]), cornerOf(other, corners[1])});
    Manifold manifold;
    manifold.normal = of.swapped ? Vec2(-normal) : normal;
    manifold.normalOf = of.swapped ? NormalOf::SecondFace : NormalOf::FirstFace;
    for (std::size_t i = 0; i < static_cast<std::size_t>(clipped.count); ++i) {
        const ClippedPoint& clip = clipped.points[i];
        const double separation = normal.dot(clip.point - from);
        if (separation > margin) {
            continue;
        }
        const bool ofOther = clip.cutAt < 0;
        const int corner = ofOther ? corners[i] : ends[static_cast<std::size_t>(clip.cutAt)];
        const unsigned kind = ofOther != of.swapped ? CornerOfSecond : CornerOfFirst;
        addPoint(manifold, clip.point - 0.5 * separation * normal, separation, featureId(kind, corner, 0));
    }
    if (manifold.count == 2 && (manifold.points[0].point - manifold.points[1].point).squaredNorm() < 1e-18) {
        manifold.count = 1;
    }
    return manifold;
}

/// The same with any outer face of the plane: cuts may divide it, and not every piece is under the other
/// part.
Manifold planeManifold(const Reference& of, const ConvexPart& other, double margin) {
    const ConvexPart& reference = of.part;
    Manifold manifold = faceManifold(of, other, margin);
    for (int i = 0; manifold.count == 0 && isCut(reference) && i < reference.count; ++i) {
        if (isOuterFace(reference, i) && normalOf(reference, i).dot(normalOf(reference, of.face)) > 1 - 1e-9) {
            manifold = faceManifold({reference, i, of.swapped}, other, margin);
        }
    }
    return manifold;
}

/// Whether the first face is the one to keep still while the other is clipped. Ties go to the longer face, then to
/// the lower part, so that swapping the parts changes nothing.
bool firstIsReference(const ConvexPart& a, const Axis& ofA, const ConvexPart& b, const Axis& ofB) {
    if (ofA.allowedFace < 0 || ofB.allowedFace < 0) {
        return ofB.allowedFace < 0;
    }
    if (std::fabs(ofA.allowed - ofB.allowed) > tie) {
        return ofA.allowed > ofB.allowed;
    }
    const double lengthA = faceLength(a, ofA.allowedFace);
    const double lengthB = faceLength(b, ofB.allowedFace);
    if (std::fabs(lengthA - lengthB) > tie) {
        return lengthA > lengthB;
    }
    const Vec2 apart = b.center - a.center;
    return std::fabs(apart.y()) > tie ? apart.y() > 0 : apart.x() >= 0;
}

/// The nearest features of two parts that do not overlap.
struct NearestFeatures {
    double squared = std::numeric_limits<double>::infinity();
    int cornerA = -1; // both corners, or the face of one and the corner of the other
    int cornerB = -1;
    int faceA = -1;
    int faceB = -1;
};

/// Of what is equally near a face goes before a corner: what lies flat is at both.
bool isNearer(const NearestFeatures& nearest, double squared, bool atCorner) {
    const bool noFace = nearest.faceA < 0 && nearest.faceB < 0;
    const double rounding = !atCorner && noFace ? 1e-9 : -1e-9;
    return squared < nearest.squared * (1 + rounding);
}

/// Looks at the corners of `part` over the faces of `reference`.
void includeCorners(const ConvexPart& reference, const ConvexPart& part, bool referenceIsA, NearestFeatures& nearest) {
    for (int i = 0; i < reference.count; ++i) {
        const Vec2& from = cornerOf(reference, i);
        const Vec2& to = cornerOf(reference, cornerAfter(reference, i));
        for (int k = 0; k < part.count; ++k) {
            const Vec2& p = cornerOf(part, k);
            const Vec2 on = closestOnSegment(from, to, p);
            const double d = (p - on).squaredNorm();
            const bool atCorner = on == from || on == to;
            if (!isNearer(nearest, d, atCorner)) {
                continue;
            }
            nearest.squared = d;
            const int corner = on == from ? i : cornerAfter(reference, i);
            const int ofReference = atCorner ? corner : -1;
            nearest.faceA = referenceIsA && !atCorner ? i : -1;
            nearest.faceB = !referenceIsA && !atCorner ? i : -1;
            nearest.cornerA = referenceIsA ? ofReference : k;
            nearest.cornerB = referenceIsA ? k : ofReference;
        }
    }
}

/// Whether what of `other` is nearest to the face lies over it, and their distance is that of the parts: one of its
/// corners, or two where it lies flat, which are as near but for rounding.
bool isOverFace(const ConvexPart& reference, int face, const ConvexPart& other) {
    const Vec2& normal = normalOf(reference, face);
    const int opposite = facing(other, normal);
    const bool isFlat = liesFlat(other, opposite, normal);
    const int first = isFlat ? opposite : deepestCorner(other, normal);
    const int second = isFlat ? cornerAfter(other, opposite) : first;
    return Span(reference, face).meets(cornerOf(other, first), cornerOf(other, second));
}

Manifold nearestManifold(const ConvexPart& a, const ConvexPart& b, const NearestFeatures& nearest, double margin) {
    Manifold manifold;
    if (nearest.faceA >= 0) {
        const bool allowed = isOuterFace(a, nearest.faceA) && levelSupports(b, nearest.cornerB, a, nearest.faceA);
        return allowed ? faceManifold({a, nearest.faceA, false}, b, margin) : manifold;
    }
    if (nearest.faceB >= 0) {
        const bool allowed = isOuterFace(b, nearest.faceB) && levelSupports(a, nearest.cornerA, b, nearest.faceB);
        return allowed ? faceManifold({b, nearest.faceB, true}, a, margin) : manifold;
    }
    const Vec2& onA = cornerOf(a, nearest.cornerA);
    const Vec2& onB = cornerOf(b, nearest.cornerB);
    const double distance = std::sqrt(nearest.squared);
    manifold.normal = (onB - onA) / distance;
    if (distance > 0 && cornerAllows(a, nearest.cornerA, manifold.normal) &&
        cornerAllows(b, nearest.cornerB, -manifold.normal)) {
        addPoint(manifold, 0.5 * (onA + onB), distance, featureId(CornerToCorner, nearest.cornerA, nearest.cornerB));
    }
    return manifold;
}

/// How far two parts are apart, and may be for a contact; `swapped` when the reference is the second of them.
struct Reach {
    double distance, margin;
    bool swapped;
};

/// Whether the outline turns inwards at a corner where an outer face of the part meets a cut, and so goes on with a
/// face of another part. -1 where it does not, else that outer face.
int faceAtNotch(const ConvexPart& part, int corner) {
    const int before = cornerBefore(part, corner);
    if (isOuterFace(part, corner) == isOuterFace(part, before)) {
        return -1;
    }
    const Vec2& beyond = part.normalsBeyond[static_cast<std::size_t>(corner)];
    const double turn =
        isOuterFace(part, corner) ? cross(beyond, normalOf(part, corner)) : cross(normalOf(part, before), beyond);
    return turn < -notchTurn ? (isOuterFace(part, corner) ? corner : before) : -1;
}

/// What is at the corner of a notch may slide along its other flank and meet this one, whose plane bounds what is free
/// beside it as well.
Manifold notchManifold(const ConvexPart& reference, int corner, const ConvexPart& other, const Reach& reach) {
    Manifold manifold;
    const int face = faceAtNotch(reference, corner);
    if (face < 0) {
        return manifold;
    }
    const Vec2& normal = normalOf(reference, face);
    const int deepest = deepestCorner(other, normal);
    const Vec2 from = cornerOf(other, deepest) - cornerOf(reference, corner);
    const double separation = normal.dot(from);
    if (!(from.squaredNorm() <= reach.margin * reach.margin) || separation < -2 * reach.distance - farAway ||
        !cornerSupports(other, deepest, -normal)) {
        return manifold;
    }
    manifold.normal = reach.swapped ? Vec2(-normal) : normal;
    manifold.normalOf = reach.swapped ? NormalOf::SecondFace : NormalOf::FirstFace;
    addPoint(manifold, cornerOf(other, deepest) - 0.5 * separation * normal, separation,
             featureId(reach.swapped ? CornerOfFirst : CornerOfSecond, deepest, 0));
    return manifold;
}

/// What of a part is nearest to another one: a face, or a corner and no face.
struct NearestOn {
    int face, corner;
};

/// The same where the nearest feature is a corner, or the cut that ends there and behind which something is in the
/// part on its other side.
Manifold notchManifold(const ConvexPart& reference, const NearestOn& nearest, const ConvexPart& other,
                       const Reach& reach) {
    if (!isCut(reference) || (nearest.face >= 0 && isOuterFace(reference, nearest.face))) {
        return {};
    }
    if (nearest.face < 0) {
        return notchManifold(reference, nearest.corner, other, reach);
    }
    const Manifold atStart = notchManifold(reference, nearest.face, other, reach);
    const Manifold atEnd = notchManifold(reference, cornerAfter(reference, nearest.face), other, reach);
    if (atStart.count == 0 || atEnd.count == 0) {
        return atStart.count > 0 ? atStart : atEnd;
    }
    return atStart.points[0].separation <= atEnd.points[0].separation ? atStart : atEnd;
}

Manifold apartManifold(const ConvexPart& a, const ConvexPart& b, double margin) {
    NearestFeatures nearest;
    includeCorners(a, b, true, nearest);
    includeCorners(b, a, false, nearest);
    const double distance = std::sqrt(nearest.squared);
    if (!(distance <= margin) || !std::isfinite(distance)) { // coordinates that are no numbers have no nearest ones
        return {};
    }
    Manifold manifold = nearestManifold(a, b, nearest, margin);
    if (manifold.count == 0) {
        manifold = notchManifold(a, {nearest.faceA, nearest.cornerA}, b, {distance, margin, false});
    }
    if (manifold.count == 0) {
        manifold = notchManifold(b, {nearest.faceB, nearest.cornerB}, a, {distance, margin, true});
    }
    return manifold;
}

} // namespace

Manifold convexAgainstConvex(const ConvexPart& a, const ConvexPart& b, double margin) {
    const Axis ofA = bestAxis(a, b, margin);
    if (ofA.separation > margin) {
        return noContact(ofA.separation);
    }
    const Axis ofB = bestAxis(b, a, margin);
    if (ofB.separation > margin) {
        return noContact(ofB.separation);
    }
    if (std::max(ofA.separation, ofB.separation) > tie) {
        if (!isCut(a) && !isCut(b)) {
            if (ofA.separation >= ofB.separation && isOverFace(a, ofA.face, b)) {
                return faceManifold({a, ofA.face, false}, b, margin);
            }
            if (ofB.separation >= ofA.separation && isOverFace(b, ofB.face, a)) {
                return faceManifold({b, ofB.face, true}, a, margin);
            }
        }
        return apartManifold(a, b, margin);
    }
    const double depth = -std::max(ofA.separation, ofB.separation);
    const double allowedDepth = -std::max(ofA.allowed, ofB.allowed);
    const bool throughCut = depth < littleWay && allowedDepth > 2 * depth + farAway;
    if (throughCut || (ofA.allowedFace < 0 && ofB.allowedFace < 0)) {
        return {};
    }
    return firstIsReference(a, ofA, b, ofB) ? planeManifold({a, ofA.allowedFace, false}, b, margin)
                                            : planeManifold({b, ofB.allowedFace, true}, a, margin);
}

} // namespace spacetow
