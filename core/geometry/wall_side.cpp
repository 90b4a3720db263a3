#include "core/geometry/wall_side.h"

namespace spacetow {

namespace {

constexpr double slack = 1e-9;        // m by which faces overlap at a smooth joint, so that rounding leaves no gap
constexpr double straightTurn = 1e-9; // sine of the turn below which a joint counts as straight
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

WallEnd wallEnd(const Vec2& point, bool joined, const Vec2& next, const Vec2& nextDirection) {
    WallEnd end;
    end.point = point;
    if (joined) {
        end.next = next;
        end.nextDirection = nextDirection;
        end.nextNormal = leftOf(nextDirection);
        end.kind = WallEnd::Kind::Smooth;
    }
    return end;
}

/// On which side of a line a point is. Beyond a joint the neighbour knows better; and where both walls end, the side is
/// that of the corner's outside.
bool isOnLeft(const WallPart& line, const Vec2& p) {
    const Vec2 along = line.b - line.a;
    if (line.joinedAtB && along.dot(p - line.b) > 0) {
        const Vec2 next = line.afterB - line.b;
        return next.dot(p - line.b) < 0 ? cross(along, next) <= 0 : cross(next, p - line.b) >= 0;
    }
    if (line.joinedAtA && along.dot(p - line.a) < 0) {
        const Vec2 previous = line.a - line.beforeA;
        return previous.dot(p - line.a) > 0 ? cross(previous, along) <= 0 : cross(previous, p - line.a) >= 0;
    }
    return cross(along, p - line.a) >= 0;
}

WallPart reversed(const WallPart& wall) {
    WallPart result = wall;
    result.a = wall.b;
    result.b = wall.a;
    result.joinedAtA = wall.joinedAtB;
    result.joinedAtB = wall.joinedAtA;
    result.beforeA = wall.afterB;
    result.afterB = wall.beforeA;
    return result;
}

} // namespace

bool WallSide::spans(const Vec2& p) const {
    const double t = along(p);
    if (t < 0) {
        return start.kind == WallEnd::Kind::Smooth &&
               (t >= -slack || (above(p) < 0 && start.nextDirection.dot(p - start.point) > 0));
    }
    if (t > length) {
        return end.kind == WallEnd::Kind::Smooth &&
               (t <= length + slack || (above(p) < 0 && end.nextDirection.dot(p - end.point) < 0));
    }
    return true;
}

WallSide sideFacing(const WallPart& wall, const Vec2& reference) {
    const bool turned = !wall.oneWay && !isOnLeft(wall, reference);
    const WallPart& seen = turned ? reversed(wall) : wall;
    WallSide side;
    const Vec2 along = seen.b - seen.a;
    side.length = along.norm();
    side.direction = unitOr(along, Vec2(1, 0));
    side.normal = leftOf(side.direction);
    side.depth = seen.oneWay ? seen.depth : 0;
    side.turned = turned;
    side.start = wallEnd(seen.a, seen.joinedAtA, seen.beforeA, unitOr(seen.a - seen.beforeA, side.direction));
    side.end = wallEnd(seen.b, seen.joinedAtB, seen.afterB, unitOr(seen.afterB - seen.b, side.direction));
    if (seen.joinedAtA) {
        side.start.kind =
            jointKind(cross(side.start.nextDirection, side.direction), side.start.nextDirection.dot(side.direction));
    }
    if (seen.joinedAtB) {
        side.end.kind =
            jointKind(cross(side.direction, side.end.nextDirection), side.direction.dot(side.end.nextDirection));
    }
    return side;
}

bool cornerAllows(const WallSide& wall, const WallEnd& corner, const Vec2& u) {
    // Between the normals lies what is ahead of the wall that arrives and behind the start of the one that leaves.
    const bool arrives = &corner == &wall.end;
    const Vec2& incoming = arrives ? wall.direction : corner.nextDirection;
    const Vec2& outgoing = arrives ? corner.nextDirection : wall.direction;
    return corner.kind == WallEnd::Kind::Convex && incoming.dot(u) >= -sameNormal && outgoing.dot(u) <= sameNormal;
}

} // namespace spacetow
