#include "core/geometry/convex_parts.h"
#include "core/geometry/insert_corner.h"
#include "core/geometry/near_points.h"

#include <tuple>

namespace spacetow {

namespace {

// What rests on a floor is sunk by the slop of contacts at most: so much of the polygon's side below a joint is the
// edge of the floor and not the affair of what is on it, m. What is smaller than this could get in there from below.
constexpr double edgeOfFloor = 0.005;
constexpr double mostOfFace = 0.25;
constexpr double thick = 0.1;          // m: of edges; nothing gets through them from behind
constexpr double besideTurn = 1e-6;    // sine of the least angle between a wall and the side below it
constexpr double straightJoint = 1e-9; // sine of the turn below which a joint counts as straight

/// An end of a wall that no other wall continues.
struct WallTip {
    WallPart* wall;
    bool leaves; // the wall starts here
    Vec2 point;
    Vec2 away; // unit, along the wall
    double length;
};

/// A face of the outline, seen from one of its corners.
struct CornerSide {
    std::size_t part;
    int face;
    bool starts; // at this corner
    Vec2 corner;
    Vec2 along; // unit, from there
    double length;
};

/// A piece of a face that becomes the edge of a floor.
struct FloorEdge {
    std::size_t part;
    int face;
    bool starts; // the piece is at the start of the face
    double at;   // m from there, where the piece ends or begins

    bool operator<(const FloorEdge& o) const { return std::tie(part, face, at) < std::tie(o.part, o.face, o.at); }
};

/// Where the outline of a part goes on along a wall.
struct Continuation {
    std::size_t part;
    Vec2 corner;
    Vec2 normal; // of the wall
};

std::vector<WallTip> wallTips(std::span<WallPart* const> walls) {
    std::vector<WallTip> tips;
    for (WallPart* const wall : walls) {
        const Vec2 way = wall->b - wall->a;
        const Vec2 along = way.normalized();
        if (!isFinite(along) || wall->a == wall->b) {
            continue;
        }
        if (!wall->joinedAtA) {
            tips.push_back({wall, true, wall->a, along, way.norm()});
        }
        if (!wall->joinedAtB) {
            tips.push_back({wall, false, wall->b, -along, way.norm()});
        }
    }
    return tips;
}

std::vector<CornerSide> cornerSides(std::span<ConvexPart* const> parts) {
    std::vector<CornerSide> sides;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const ConvexPart& part = *parts[p];
        for (int i = 0; i < part.count; ++i) {
            if ((part.outerFaces >> i & 1) != 0) {
                const Vec2& from = part.corners[static_cast<std::size_t>(i)];
                const Vec2& to = part.corners[static_cast<std::size_t>(i + 1 < part.count ? i + 1 : 0)];
                const Vec2 along = (to - from).normalized();
                sides.push_back({p, i, true, from, along, (to - from).norm()});
                sides.push_back({p, i, false, to, -along, (to - from).norm()});
            }
        }
    }
    return sides;
}

bool meets(const WallTip& tip, const CornerSide& side) {
    const double within = meetingDistance(tip.length, side.length);
    return (tip.point - side.corner).squaredNorm() <= within * within;
}

/// Whether a direction from the corner is on the far side of the wall, as seen from what is on the floor.
bool isBelow(const WallTip& tip, bool starts, const Vec2& direction) {
    const double turn = cross(direction, tip.away);
    return starts ? turn > besideTurn : turn < -besideTurn;
}

/// The other side of the part at the corner, which may be a cut.
Vec2 besideOf(const ConvexPart& part, const CornerSide& side) {
    const int next = side.face + 1 < part.count ? side.face + 1 : 0;
    const int before = side.face > 0 ? side.face - 1 : part.count - 1;
    const int beyond = side.starts ? before : (next + 1 < part.count ? next + 1 : 0);
    return part.corners[static_cast<std::size_t>(beyond)] -
           part.corners[static_cast<std::size_t>(side.starts ? side.face : next)];
}

/// Whether the wall goes on as this side: straight, into a hollow or around a blunt corner, with the polygon below.
/// What comes from behind through an edge that is thin would meet the corner of the polygon, so that has to stay one.
bool continuesAs(const WallTip& tip, const CornerSide& side, const ConvexPart& part) {
    const bool solid = !tip.wall->oneWay || (side.starts == tip.leaves && tip.wall->depth >= thick);
    const double turn = side.starts ? cross(tip.away, side.along) : cross(side.along, tip.away);
    const bool bends = turn >= straightJoint || tip.away.dot(side.along) < 0;
    return solid && bends && meets(tip, side) && isBelow(tip, side.starts, besideOf(part, side).normalized());
}

void join(const WallTip& tip, const CornerSide& side) {
    const Vec2 farEnd = tip.point + side.length * side.along;
    const JoinedSide which = side.starts == tip.leaves ? JoinedSide::Left : JoinedSide::Right;
    if (tip.leaves) {
        tip.wall->joinedAtA = true;
        tip.wall->sideAtA = which;
        tip.wall->beforeA = farEnd;
    } else {
        tip.wall->joinedAtB = true;
        tip.wall->sideAtB = which;
        tip.wall->afterB = farEnd;
    }
}

FloorEdge floorEdgeOf(const WallTip& tip, const CornerSide& side) {
    const double sine = std::fabs(cross(side.along, tip.away));
    const double depth = std::min(edgeOfFloor / sine, mostOfFace * side.length);
    return {side.part, side.face, side.starts, side.starts ? depth : side.length - depth};
}

void setFloorEdges(std::span<ConvexPart* const> parts, std::vector<FloorEdge> edges) {
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = edges.size(); i-- > 0;) { // from behind, so that the others stay where they are
        const FloorEdge& edge = edges[i];
        const bool again = i + 1 < edges.size() && edges[i + 1].part == edge.part && edges[i + 1].face == edge.face &&
                           edges[i + 1].starts == edge.starts;
        ConvexPart& part = *parts[edge.part];
        if (!again && part.count < ConvexPart::maxCorners) {
            insertCorner(part, edge.face, edge.at);
            const unsigned piece = 1u << (edge.starts ? edge.face : edge.face + 1);
            part.outerFaces = static_cast<std::uint8_t>(part.outerFaces & ~piece);
            part.floorEdges = static_cast<std::uint8_t>(part.floorEdges | piece);
        }
    }
}

/// What is beyond a corner of which one side alone is on the outline is the wall.
void setBeyond(std::span<ConvexPart* const> parts, const Continuation& on) {
    ConvexPart& part = *parts[on.part];
    for (int i = 0; i < part.count; ++i) {
        const int before = i > 0 ? i - 1 : part.count - 1;
        const auto k = static_cast<std::size_t>(i);
        if (part.corners[k] == on.corner && (part.outerFaces >> i & 1) != (part.outerFaces >> before & 1)) {
            part.normalsBeyond[k] = on.normal;
        }
    }
}

} // namespace

void joinWallsWithParts(std::span<WallPart* const> walls, std::span<ConvexPart* const> parts) {
    if (walls.empty() || parts.empty()) {
        return;
    }
    const std::vector<WallTip> tips = wallTips(walls);
    if (tips.empty()) {
        return;
    }
    const std::vector<CornerSide> sides = cornerSides(parts);
    std::vector<Vec2> corners;
    corners.reserve(sides.size());
    for (const CornerSide& side : sides) {
        corners.push_back(side.corner);
    }
    const NearPoints near(corners);
    std::vector<FloorEdge> edges;
    std::vector<Continuation> continuations;
    for (const WallTip& tip : tips) {
        const CornerSide* best = nullptr;
        const bool few = near.visit(tip.point, [&](std::uint32_t i) {
            const CornerSide& side = sides[i];
            const bool straighter = best == nullptr || tip.away.dot(side.along) < tip.away.dot(best->along);
            best = straighter && continuesAs(tip, side, *parts[side.part]) ? &side : best;
        });
        if (!few || best == nullptr) {
            continue;
        }
        join(tip, *best);
        continuations.push_back({best->part, best->corner, leftOf(best->starts ? tip.away : Vec2(-tip.away))});
        near.visit(tip.point, [&](std::uint32_t i) {
            const CornerSide& side = sides[i];
            if (side.starts != best->starts && meets(tip, side) && isBelow(tip, best->starts, side.along)) {
                edges.push_back(floorEdgeOf(tip, side));
            }
        });
    }
    setFloorEdges(parts, std::move(edges));
    for (const Continuation& on : continuations) {
        setBeyond(parts, on);
    }
}

} // namespace spacetow
