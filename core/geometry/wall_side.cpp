#include "core/geometry/wall_side.h"

#include "core/geometry/near_points.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr double slack = jointTolerance; // m by which faces overlap at a smooth joint, so that no gap is left there
constexpr double straightTurn = 1e-9;    // sine of the turn below which a joint counts as straight
constexpr double sameNormal = 1e-9;

Vec2 unitOr(const Vec2& v, const Vec2& fallback) {
    const double length = v.norm();
    return length > 0 ? Vec2(v / length) : fallback;
}

/// `turn` and `cosine` of the change of direction on the way along the chain; a turn to the right is convex, and so
/// is a wall that folds back over itself.
WallEnd::Kind jointKind(double turn, double cosine) {
    const bool convex = turn < -straightTurn || (turn <= straightTurn && cosine < 0);
    return convex ? WallEnd::Kind::Convex : WallEnd::Kind::Smooth;
}

bool isOnSide(JoinedSide joined, bool right) {
    return joined != (right ? JoinedSide::Left : JoinedSide::Right);
}

/// Whether the point, which is behind both walls of a hollow joint and over neither, is farther from it than the depth
/// reaches.
bool isPastJoint(const WallSide& side, const WallEnd& end, const Vec2& p) {
    const Vec2 middle = side.middleOf(end);
    return (end.point - p).dot(middle) > side.depthBehind(middle) + onTheFace;
}

void join(WallEnd& end, const Vec2& next, const Vec2& direction) {
    end.next = next;
    end.nextDirection = direction;
    end.nextNormal = leftOf(direction);
}

} // namespace

bool WallSide::spans(const Vec2& p) const {
    const double t = along(p);
    if (t < 0) {
        return start.kind == WallEnd::Kind::Smooth &&
               (t >= -slack ||
                (above(p) < 0 && start.nextDirection.dot(p - start.point) > 0 && !isPastJoint(*this, start, p)));
    }
    if (t > length) {
        return end.kind == WallEnd::Kind::Smooth &&
               (t <= length + slack ||
                (above(p) < 0 && end.nextDirection.dot(p - end.point) < 0 && !isPastJoint(*this, end, p)));
    }
    return true;
}

double WallSide::depthBehind(const Vec2& middle) const {
    return depth / std::max(middle.dot(normal), sharpestHollow);
}

bool WallSide::isDeeperThanDepth(const Vec2& p) const {
    const double t = along(p);
    return above(p) < -depth - onTheFace ||
           (t < 0 && start.kind == WallEnd::Kind::Smooth && isPastJoint(*this, start, p)) ||
           (t > length && end.kind == WallEnd::Kind::Smooth && isPastJoint(*this, end, p));
}

WallSide faceOf(const WallPart& wall, bool right) {
    WallSide side;
    side.start.point = right ? wall.b : wall.a;
    side.end.point = right ? wall.a : wall.b;
    const Vec2 along = side.end.point - side.start.point;
    side.length = along.norm();
    side.direction = side.length > 0 ? Vec2(along / side.length) : Vec2(1, 0);
    side.normal = leftOf(side.direction);
    side.depth = wall.oneWay ? wall.depth : 0;
    side.turned = right;
    return side;
}

WallSide sideOf(const WallPart& wall, bool right) {
    WallSide side = faceOf(wall, right);
    const bool atA = wall.joinedAtA && isOnSide(wall.sideAtA, right);
    const bool atB = wall.joinedAtB && isOnSide(wall.sideAtB, right);
    if (right ? atB : atA) {
        const Vec2& previous = right ? wall.afterB : wall.beforeA;
        join(side.start, previous, unitOr(side.start.point - previous, side.direction));
        const Vec2& incoming = side.start.nextDirection;
        side.start.kind = jointKind(cross(incoming, side.direction), incoming.dot(side.direction));
    }
    if (right ? atA : atB) {
        const Vec2& next = right ? wall.beforeA : wall.afterB;
        join(side.end, next, unitOr(next - side.end.point, side.direction));
        const Vec2& outgoing = side.end.nextDirection;
        side.end.kind = jointKind(cross(side.direction, outgoing), side.direction.dot(outgoing));
    }
    return side;
}

bool isOnRight(const WallPart& line, const Vec2& p) {
    const Vec2 along = line.b - line.a;
    if (line.joinedAtB && along.dot(p - line.b) > 0) {
        const Vec2 next = line.afterB - line.b;
        return next.dot(p - line.b) < 0 ? cross(along, next) > 0 : cross(next, p - line.b) < 0;
    }
    if (line.joinedAtA && along.dot(p - line.a) < 0) {
        const Vec2 previous = line.a - line.beforeA;
        return previous.dot(p - line.a) > 0 ? cross(previous, along) > 0 : cross(previous, p - line.a) < 0;
    }
    return cross(along, p - line.a) < 0;
}

bool cornerAllows(const WallSide& wall, const WallEnd& corner, const Vec2& u) {
    // Between the normals lies what is ahead of the wall that arrives and behind the start of the one that leaves.
    const bool arrives = &corner == &wall.end;
    const Vec2& incoming = arrives ? wall.direction : corner.nextDirection;
    const Vec2& outgoing = arrives ? corner.nextDirection : wall.direction;
    return corner.kind == WallEnd::Kind::Convex && incoming.dot(u) >= -sameNormal && outgoing.dot(u) <= sameNormal;
}

} // namespace spacetow
