#include "core/geometry/clip.h"
#include "core/geometry/collide_pairs.h"
#include "core/geometry/intersect.h"
#include "core/geometry/near_points.h"
#include "core/geometry/polygon_at_wall.h"
#include "core/geometry/wall_side.h"

#include <algorithm>

namespace spacetow {

namespace {

enum WallFeature : unsigned { OnFace = 4, OnFaceCut, UnderFace, UnderFaceCut, OnPoint };

// How much shallower a way out has to be before it is preferred to the wall's own normal.
constexpr double preference = 1e-4; // m
constexpr double share = 0.98;      // of the depth

// Something that has come a little way through a cut of the polygon is the affair of the part beyond the cut.
constexpr double littleWayIntoCut = 0.02; // m
constexpr double farFromWall = 0.01;      // m beyond twice the way

// Below this distance the nearest features are a matter of rounding, and the overlapping case decides.
constexpr double wallTie = 1e-6; // m

// What is no more than this higher is as high: both ends of a side that lies on a wall.
constexpr double levelEnough = 1e-12; // m

constexpr double noSeparation = -std::numeric_limits<double>::infinity();

/// A wall and a polygon, and what is asked of every pair.
struct Pair {
    WallSide side;
    const ConvexPart& convex;
    double margin;

    std::uint32_t id(unsigned kind, int first, int second) const {
        return featureId(kind, first, second | (side.turned ? 0x80 : 0));
    }
};

/// How far beyond its end a wall bears what is on it, m: where it is joined, no gap is left.
double reachBeyond(const WallEnd& end) {
    return end.kind == WallEnd::Kind::Smooth ? jointTolerance : 0;
}

/// Whether a cut of a polygon's side at a joint stands for nothing: the side goes on to a corner over the neighbour. If
/// that corner is the deeper one it rests there before the cut comes down on this wall, and else the other end does
/// here.
bool isIdleCut(const WallSide& side, const ClippedPoint& cut, const Vec2& corner) {
    const WallEnd& end = cut.cutAt == 0 ? side.start : side.end;
    const double overNext = (cut.cutAt == 0 ? -1 : 1) * end.nextDirection.dot(corner - end.point);
    return end.kind == WallEnd::Kind::Smooth && overNext >= 0 &&
           std::fabs(side.above(corner) - side.above(cut.point)) > levelEnough;
}

/// The face of the wall stops the polygon: the points of one side of it that are over the wall.
Manifold faceManifold(const Pair& pair, int face) {
    const WallSide& side = pair.side;
    const ConvexPart& convex = pair.convex;
    const std::array<int, 2> corners{face, cornerAfter(convex, face)};
    const double before = reachBeyond(side.start);
    const auto clipped = clipToFace(side.start.point - before * side.direction, side.direction,
                                    before + side.length + reachBeyond(side.end),
                                    {cornerOf(convex, corners[0]), cornerOf(convex, corners[1])});
    Manifold manifold;
    manifold.normal = side.normal;
    manifold.normalOf = NormalOf::FirstFace;
    const double lowest = std::min(side.above(clipped.points[0].point), side.above(clipped.points[1].point));
    const double margin = marginOfEnds(convex, lowest, pair.margin);
    for (std::size_t i = 0; i < static_cast<std::size_t>(clipped.count); ++i) {
        const ClippedPoint& clip = clipped.points[i];
        const double separation = side.above(clip.point);
        if (separation > margin || (clip.cutAt >= 0 && isIdleCut(side, clip, cornerOf(convex, corners[i])))) {
            continue;
        }
        const std::uint32_t id = clip.cutAt < 0 ? pair.id(OnFace, corners[i], 0) : pair.id(OnFaceCut, face, clip.cutAt);
        addPoint(manifold, clip.point - 0.5 * separation * side.normal, separation, id);
    }
    if (manifold.count == 2 && (manifold.points[0].point - manifold.points[1].point).squaredNorm() < 1e-18) {
        manifold.count = 1;
    }
    return manifold;
}

/// The same with the side that faces the wall most, or, when that is not over the wall, the one beside it.
Manifold faceManifold(const Pair& pair) {
    const int lowest = facing(pair.convex, pair.side.normal);
    Manifold manifold = faceManifold(pair, lowest);
    if (manifold.count > 0) {
        return manifold;
    }
    const int before = lowest > 0 ? lowest - 1 : pair.convex.count - 1;
    const Manifold beside = faceManifold(pair, before);
    return beside.count > 0 ? beside : faceManifold(pair, cornerAfter(pair.convex, lowest));
}

/// A polygon that the wall holds although its lower side is not over the wall: its deepest corner stands for it.
Manifold heldManifold(const Pair& pair) {
    Manifold manifold = faceManifold(pair);
    if (manifold.count == 0) {
        const int corner = deepestCorner(pair.convex, pair.side.normal);
        const Vec2& point = cornerOf(pair.convex, corner);
        const double separation = pair.side.above(point);
        if (separation <= pair.margin) {
            addPoint(manifold, point - 0.5 * separation * pair.side.normal, separation, pair.id(OnFace, corner, 0));
        }
    }
    return manifold;
}

/// An end of the wall against a face of the polygon.
Manifold pointUnderFace(const Pair& pair, const WallEnd& end, int face) {
    Manifold manifold;
    manifold.normal = -normalOf(pair.convex, face);
    manifold.normalOf = NormalOf::SecondFace;
    const double separation = normalOf(pair.convex, face).dot(end.point - cornerOf(pair.convex, face));
    addPoint(manifold, end.point + 0.5 * separation * manifold.normal, separation,
             pair.id(UnderFace, face, &end == &pair.side.end ? 1 : 0));
    return manifold;
}

/// A face of the polygon lies on a free end of the wall, perhaps on more of the wall.
Manifold wallUnderFace(const Pair& pair, const WallEnd& end, int face) {
    const Vec2& normal = normalOf(pair.convex, face);
    const Vec2& from = cornerOf(pair.convex, face);
    const double length = (cornerOf(pair.convex, cornerAfter(pair.convex, face)) - from).norm();
    const auto clipped = clipToFace(from, leftOf(normal), length, {pair.side.start.point, pair.side.end.point});
    Manifold manifold;
    manifold.normal = -normal;
    manifold.normalOf = NormalOf::SecondFace;
    for (std::size_t i = 0; i < static_cast<std::size_t>(clipped.count); ++i) {
        const ClippedPoint& clip = clipped.points[i];
        const WallEnd& own = i == 0 ? pair.side.start : pair.side.end;
        const bool left = clip.cutAt < 0 && &own != &end && own.kind != WallEnd::Kind::Free; // to its neighbour
        const double separation = normal.dot(clip.point - from);
        if (separation > pair.margin || left) {
            continue;
        }
        const std::uint32_t id =
            clip.cutAt < 0 ? pair.id(UnderFace, face, static_cast<int>(i)) : pair.id(UnderFaceCut, face, clip.cutAt);
        addPoint(manifold, clip.point - 0.5 * separation * normal, separation, id);
    }
    if (manifold.count == 2 && (manifold.points[0].point - manifold.points[1].point).squaredNorm() < 1e-18) {
        manifold.count = 1;
    }
    return manifold.count > 0 ? manifold : pointUnderFace(pair, end, face);
}

/// Whether the wall reports contacts at this end along `u`. Both walls at a corner come to the same answer, only the
/// one that arrives there says so.
bool reports(const Pair& pair, const WallEnd& end) {
    return end.kind == WallEnd::Kind::Free || &end == &pair.side.end;
}
bool mayPoint(const Pair& pair, const WallEnd& end, const Vec2& u) {
    return end.kind == WallEnd::Kind::Free || cornerAllows(pair.side, end, u);
}

Manifold underFaceManifold(const Pair& pair, const WallEnd& end, int face) {
    if (!reports(pair, end)) {
        return {};
    }
    return end.kind == WallEnd::Kind::Free ? wallUnderFace(pair, end, face) : pointUnderFace(pair, end, face);
}

Manifold cornerManifold(const Pair& pair, const WallEnd& end, int corner, const Vec2& apart) {
    Manifold manifold;
    const double distance = apart.norm();
    if (distance > pair.margin || distance <= 0) {
        return manifold;
    }
    manifold.normal = apart / distance;
    if (!reports(pair, end) || !mayPoint(pair, end, manifold.normal) ||
        !cornerAllows(pair.convex, corner, -manifold.normal)) {
        return manifold;
    }
    addPoint(manifold, end.point + 0.5 * apart, distance, pair.id(OnPoint, corner, &end == &pair.side.end ? 1 : 0));
    return manifold;
}

/// A polygon in front of the wall that it does not overlap: the pair of features nearest to each other decides.
Manifold apartManifold(const Pair& pair) {
    const WallSide& side = pair.side;
    const ConvexPart& convex = pair.convex;
    double nearest = pair.margin * pair.margin;
    int corner = -1;
    int face = -1;
    const WallEnd* end = nullptr;
    for (int i = 0; i < convex.count; ++i) {
        const Vec2& p = cornerOf(convex, i);
        const Vec2 on = closestOnSegment(side.start.point, side.end.point, p);
        const double d = (p - on).squaredNorm();
        if (d <= nearest && (corner < 0 || d < nearest)) {
            nearest = d;
            corner = i;
            const double t = side.along(p);
            end = t < 0 ? &side.start : (t > side.length ? &side.end : nullptr);
        }
    }
    for (int i = 0; i < convex.count; ++i) {
        for (const WallEnd* candidate : {&side.start, &side.end}) {
            const Vec2& from = cornerOf(convex, i);
            const Vec2& to = cornerOf(convex, cornerAfter(convex, i));
            const Vec2 on = closestOnSegment(from, to, candidate->point);
            const double d = (candidate->point - on).squaredNorm();
            if (d < nearest * (1 - 1e-9) && on != from && on != to) {
                nearest = d;
                face = i;
                end = candidate;
            }
        }
    }
    const double above = side.above(cornerOf(convex, deepestCorner(convex, side.normal)));
    if (above >= std::sqrt(nearest) - onTheFace || (end != nullptr && end->kind == WallEnd::Kind::Smooth)) {
        Manifold manifold = faceManifold(pair);
        if (manifold.count > 0) {
            return manifold;
        }
    }
    if (face >= 0) {
        const bool allowed = isOuterFace(convex, face) && mayPoint(pair, *end, -normalOf(convex, face));
        return allowed ? underFaceManifold(pair, *end, face) : Manifold{};
    }
    if (corner < 0) {
        return {};
    }
    if (end == nullptr) {
        return faceManifold(pair);
    }
    return cornerManifold(pair, *end, corner, cornerOf(convex, corner) - end->point);
}

/// The least penetration along the polygon's own face normals, of those that may be contact normals.
struct FaceChoice {
    double deepest = noSeparation; // largest separation of all faces: above 0 they are apart
    double cut = noSeparation;     // largest separation of the inner faces
    double separation = noSeparation;
    int face = -1;
    const WallEnd* end = nullptr;
};

/// `only`: this end of the wall alone counts; without it the whole wall does.
FaceChoice chooseFace(const Pair& pair, const WallEnd* only) {
    FaceChoice choice;
    for (int i = 0; i < pair.convex.count; ++i) {
        const Vec2& normal = normalOf(pair.convex, i);
        const Vec2& from = cornerOf(pair.convex, i);
        const double atStart = normal.dot(pair.side.start.point - from);
        const double atEnd = normal.dot(pair.side.end.point - from);
        const WallEnd* end = only != nullptr ? only : (atStart < atEnd ? &pair.side.start : &pair.side.end);
        const double separation = end == &pair.side.start ? atStart : atEnd;
        choice.deepest = std::max(choice.deepest, separation);
        if (!isOuterFace(pair.convex, i)) {
            choice.cut = std::max(choice.cut, separation);
        }
        if (separation > choice.separation && isOuterFace(pair.convex, i) && mayPoint(pair, *end, -normal)) {
            choice.separation = separation;
            choice.face = i;
            choice.end = end;
        }
    }
    return choice;
}

/// Separation along the normal of the wall that continues this one at a corner, if that wall is touched and may use it.
double neighbourSeparation(const Pair& pair, const WallEnd& end) {
    const ConvexPart& convex = pair.convex;
    if (end.kind != WallEnd::Kind::Convex || end.nextNormal.dot(convex.center - end.point) < -onTheFace) {
        return noSeparation;
    }
    for (int i = 0; i < convex.count; ++i) {
        const Vec2& normal = normalOf(convex, i);
        const Vec2& from = cornerOf(convex, i);
        if (std::min(normal.dot(end.point - from), normal.dot(end.next - from)) > 0) {
            return noSeparation;
        }
    }
    return end.nextNormal.dot(cornerOf(convex, deepestCorner(convex, end.nextNormal)) - end.point);
}

bool cameThroughCut(const FaceChoice& choice, double separation) {
    return choice.cut > -littleWayIntoCut && separation < 2 * choice.cut - farFromWall;
}

bool clearlyAbove(double separation, double other) {
    return separation > share * std::min(other, 0.0) + preference;
}

/// A polygon whose centre is in front of the wall.
Manifold frontManifold(const Pair& pair) {
    const WallSide& side = pair.side;
    const double above = side.above(cornerOf(pair.convex, deepestCorner(pair.convex, side.normal)));
    const FaceChoice choice = chooseFace(pair, nullptr);
    if (std::max(above, choice.deepest) > pair.margin) {
        return noContact(std::max(above, choice.deepest));
    }
    if (std::max(above, choice.deepest) > wallTie) {
        return apartManifold(pair);
    }
    const double neighbours = std::max(neighbourSeparation(pair, side.start), neighbourSeparation(pair, side.end));
    const double best = std::max(above, choice.separation);
    if (clearlyAbove(neighbours, best) || cameThroughCut(choice, best)) {
        return {};
    }
    if (choice.face >= 0 && clearlyAbove(choice.separation, above)) {
        return underFaceManifold(pair, *choice.end, choice.face);
    }
    Manifold manifold = faceManifold(pair);
    if (manifold.count > 0) {
        return manifold;
    }
    // No side is over the wall: at most the tie beyond one end of it.
    const Extent extent = extentAlong(side, pair.convex);
    const WallEnd& end = extent.from + extent.to > side.length ? side.end : side.start;
    if (end.kind == WallEnd::Kind::Smooth) {
        return {}; // the affair of the neighbour
    }
    const FaceChoice atEnd = chooseFace(pair, &end);
    return atEnd.face >= 0 ? underFaceManifold(pair, end, atEnd.face) : Manifold{};
}

/// An end of the wall against a polygon that the face lets through.
Manifold endManifold(const Pair& pair, const WallEnd& end) {
    if (end.kind == WallEnd::Kind::Free) {
        Manifold manifold = convexAgainstCircle(pair.convex, {end.point, 0}, pair.margin);
        manifold.normal = -manifold.normal;
        const int which = &end == &pair.side.end ? 1 : 0;
        manifold.points[0].feature = pair.id(OnPoint, static_cast<int>(manifold.points[0].feature >> 8 & 0xffu), which);
        return manifold;
    }
    if (!reports(pair, end) || end.kind != WallEnd::Kind::Convex) {
        return {};
    }
    const FaceChoice choice = chooseFace(pair, &end);
    if (choice.deepest > wallTie) {
        Manifold manifold = convexAgainstCircle(pair.convex, {end.point, 0}, pair.margin);
        manifold.normal = -manifold.normal;
        return cornerAllows(pair.side, end, manifold.normal) ? manifold : Manifold{};
    }
    const bool othersTurn =
        clearlyAbove(neighbourSeparation(pair, end), choice.separation) || cameThroughCut(choice, choice.separation);
    return choice.face >= 0 && !othersTurn ? pointUnderFace(pair, end, choice.face) : Manifold{};
}

/// How far what the wall does not hold has to come at least until it may, m.
double behindDepth(const WallSide& side, const ConvexPart& convex) {
    const double nearest =
        isCut(convex) ? std::max(side.above(convex.center), side.above(convex.whole)) : side.above(convex.center);
    return std::max(-side.depth - nearest, 0.0);
}

} // namespace

Manifold wallAgainstConvex(const WallPart& wall, const ConvexPart& convex, double margin) {
    const bool right = !wall.oneWay && isMostlyOnRight(wall, convex);
    Pair pair{faceOf(wall, right), convex, margin};
    const bool inFront =
        pair.side.above(convex.center) >= -onTheFace || (!wall.oneWay && isOnRight(wall, convex.center) == right);
    if (inFront) {
        const double above = pair.side.above(cornerOf(convex, deepestCorner(convex, pair.side.normal)));
        if (above > margin) {
            return noContact(above);
        }
        const Extent extent = extentAlong(pair.side, convex);
        const double beyond = std::max(extent.from - pair.side.length, -extent.to);
        if (beyond > margin) {
            return noContact(beyond);
        }
        if (extent.from >= 0 && extent.to <= pair.side.length) {
            return faceManifold(pair);
        }
    }
    pair.side = sideOf(wall, right);
    if (inFront) {
        return frontManifold(pair);
    }
    if (isHeld(pair.side, convex)) {
        return heldManifold(pair);
    }
    const Manifold atStart = endManifold(pair, pair.side.start);
    const Manifold atEnd = endManifold(pair, pair.side.end);
    if (atStart.count == 0 && atEnd.count == 0) {
        return noContact(std::min({atStart.apart, atEnd.apart, behindDepth(pair.side, convex)}));
    }
    const bool startIsDeeper =
        atStart.count > 0 && (atEnd.count == 0 || atStart.points[0].separation <= atEnd.points[0].separation);
    return startIsDeeper ? atStart : atEnd;
}

} // namespace spacetow
