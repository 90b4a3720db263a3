#pragma once
// A wall as seen by what meets it: turned so that its free side is on the left, with what continues it at both ends.

#include "core/geometry/part.h"

namespace spacetow {

/// How a wall ends. A free end is a point that stops everything. At a smooth joint (straight, or hollow as seen from
/// the free side) the neighbour's face does what is needed. A convex joint is a corner, reported by the wall that
/// arrives at it, for normals between those of the two walls.
struct WallEnd {
    enum class Kind { Free, Smooth, Convex };

    Kind kind = Kind::Free;
    Vec2 point{0, 0};
    Vec2 next{0, 0};          // the far end of the neighbour; not read for free ends
    Vec2 nextDirection{0, 0}; // unit, of the neighbour, in the same sense as the wall's own
    Vec2 nextNormal{0, 0};    // unit, of the neighbour
};

constexpr double onTheFace = 1e-9; // m: what is no farther behind a face counts as in front of it

// Cosine of half the bend of a hollow joint: behind sharper ones the depth of the walls ends as far from the joint as
// behind this one, where it would go on for ever.
constexpr double sharpestHollow = 0.5;

struct WallSide {
    Vec2 direction{1, 0}; // unit, from start to end
    Vec2 normal{0, 1};    // unit, to the free side
    double length = 0;    // m
    double depth = 0;     // m behind the face that belong to it
    WallEnd start, end;
    bool turned = false; // a line seen from its right

    double along(const Vec2& p) const { return direction.dot(p - start.point); }
    double above(const Vec2& p) const { return normal.dot(p - start.point); }
    /// Whether the face answers for something whose reference point is `p`: it lies over the wall, or behind a hollow
    /// joint, where no other face would.
    bool spans(const Vec2& p) const;
    /// Whether something with this reference point is stopped by the face, wherever its surface is.
    bool holds(const Vec2& p) const { return above(p) >= -depth - onTheFace && spans(p); }
    /// Unit, to the free sides: half way between the wall's own normal and that of the neighbour.
    Vec2 middleOf(const WallEnd& end) const { return (normal + end.nextNormal).normalized(); }
    /// How far from a hollow joint, against the middle of both normals, the depth ends, m.
    double depthBehind(const Vec2& middle) const;
    /// Whether the point is farther behind the face than the depth, or behind a hollow joint where that has ended.
    bool isDeeperThanDepth(const Vec2& p) const;
};

/// One side of the wall; the right one is that of the wall turned round. A wall without length has an arbitrary
/// direction.
WallSide sideOf(const WallPart& wall, bool right);
/// The same without what continues the wall: all that something needs that lies over the wall altogether.
WallSide faceOf(const WallPart& wall, bool right);

/// On which side of a line a point is. Beyond a joint the neighbour knows better; and where both walls end, the side is
/// that of the corner's outside.
bool isOnRight(const WallPart& line, const Vec2& p);

/// The side of the wall that meets what has its reference point at `reference`.
inline WallSide sideFacing(const WallPart& wall, const Vec2& reference) {
    return sideOf(wall, !wall.oneWay && isOnRight(wall, reference));
}

/// Whether a corner contact at a convex joint may have the unit normal `u`. `corner` is the end of `wall`.
bool cornerAllows(const WallSide& wall, const WallEnd& corner, const Vec2& u);

} // namespace spacetow
