#pragma once
// One side of a wall, with the free side on the left, and its neighbours at both ends. Metres.

#include "core/geometry/part.h"

namespace spacetow {

/// The end of a wall. A free end is a point that stops all parts. A smooth joint is straight, or hollow as seen from
/// the free side: beyond it the face of the neighbour collides. A convex joint is a corner with contact normals between
/// those of the two walls; the wall that ends there has the contact.
struct WallEnd {
    enum class Kind { Free, Smooth, Convex };

    Kind kind = Kind::Free;
    Vec2 point{0, 0};
    Vec2 next{0, 0};          // the far end of the neighbour; unset at a free end, as are the members below
    Vec2 nextDirection{0, 0}; // unit, of the neighbour, in the same sense as the wall's own
    Vec2 nextNormal{0, 0};    // unit, of the neighbour
};

constexpr double onTheFace = 1e-9; // m: a point no farther behind a face than this counts as in front of it

// Cosine of half the bend of a hollow joint. Behind sharper joints the depth ends at the same distance as behind this
// one: the bands of the two walls would meet ever farther away.
constexpr double sharpestHollow = 0.5;

struct WallSide {
    Vec2 direction{1, 0}; // unit, from start to end
    Vec2 normal{0, 1};    // unit, to the free side
    double length = 0;    // m
    double depth = 0;     // m, of the band behind the face; 0 for lines
    WallEnd start, end;
    bool turned = false; // the right side of a line

    /// The coordinates of a point along the wall and above its face, m.
    double along(const Vec2& p) const { return direction.dot(p - start.point); }
    double above(const Vec2& p) const { return normal.dot(p - start.point); }
    /// Whether the face collides with a part whose reference point is `p`: the point lies over the wall, or in the gap
    /// behind a hollow joint, which no face is over.
    bool spans(const Vec2& p) const;
    /// Whether the face stops a part with this reference point: it spans the point, and the point is not behind the
    /// depth.
    bool holds(const Vec2& p) const { return above(p) >= -depth - onTheFace && spans(p); }
    /// The bisector of the normals of the wall and of the neighbour at this end, unit.
    Vec2 middleOf(const WallEnd& end) const { return (normal + end.nextNormal).normalized(); }
    /// The depth behind a hollow joint along the bisector `middle`, m.
    double depthBehind(const Vec2& middle) const;
    /// Whether the point is farther behind the face than the depth, or farther behind a hollow joint than
    /// depthBehind().
    bool isDeeperThanDepth(const Vec2& p) const;
};

/// One side of the wall; the right side is the left side of the reversed wall. A wall without length gets an arbitrary
/// direction.
WallSide sideOf(const WallPart& wall, bool right);
/// The same without neighbours; enough for parts that are wholly over the wall.
WallSide faceOf(const WallPart& wall, bool right);

/// Whether the point is on the right of a line. Beyond a joint the neighbour decides; a point beyond the ends of both
/// walls is on the outer side of the corner.
bool isOnRight(const WallPart& line, const Vec2& p);

/// The side of the wall that faces the reference point of a part.
inline WallSide sideFacing(const WallPart& wall, const Vec2& reference) {
    return sideOf(wall, !wall.oneWay && isOnRight(wall, reference));
}

/// Whether a contact at the end `corner` of `wall` may have the unit normal `u`: only at a convex joint, between the
/// two normals.
bool cornerAllows(const WallSide& wall, const WallEnd& corner, const Vec2& u);

} // namespace spacetow
