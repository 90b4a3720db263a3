#include "core/geometry/convex_parts.h"
#include "core/geometry/near_points.h"

namespace spacetow {

namespace {

constexpr double foldedBack = -1 + 1e-12; // cosine: two lines on top of each other do not continue one another

/// One end of a wall, seen from its point.
struct LooseEnd {
    Vec2 point;
    bool oneWay;
    bool leaves; // the wall starts here
    std::size_t wall;
    Vec2 away; // unit, along the wall
    double length;
};

/// How well an end would continue another.
struct Match {
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t end = none;
    double cosine = -2;
    double squared = 0; // m², of how far apart they are

    bool operator<(const Match& o) const {
        if (cosine != o.cosine) {
            return cosine < o.cosine;
        }
        return squared != o.squared ? squared > o.squared : end > o.end;
    }
};

std::vector<LooseEnd> looseEnds(std::span<WallPart* const> walls) {
    std::vector<LooseEnd> ends;
    ends.reserve(2 * walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        WallPart& wall = *walls[i];
        wall.joinedAtA = wall.joinedAtB = false;
        wall.sideAtA = wall.sideAtB = JoinedSide::Both;
        wall.beforeA = wall.afterB = Vec2(0, 0);
        const Vec2 way = wall.b - wall.a;
        const Vec2 along = way.normalized();
        if (isFinite(along) && wall.a != wall.b) {
            ends.push_back({wall.a, wall.oneWay, true, i, along, way.norm()});
            ends.push_back({wall.b, wall.oneWay, false, i, -along, way.norm()});
        }
    }
    return ends;
}

/// Whether one of the two walls is an edge and the other a line.
bool differ(const LooseEnd& s, const LooseEnd& t) {
    return s.oneWay != t.oneWay;
}

/// How straight one end continues the other; `none` when it cannot.
Match matchOf(const std::vector<LooseEnd>& ends, std::size_t i, std::size_t j, bool mixed) {
    const LooseEnd& s = ends[i];
    const LooseEnd& t = ends[j];
    const double cosine = -s.away.dot(t.away);
    const double squared = (s.point - t.point).squaredNorm();
    const double distance = meetingDistance(s.length, t.length);
    const bool fits = s.wall != t.wall && differ(s, t) == mixed && squared <= distance * distance &&
                      (s.oneWay && t.oneWay ? s.leaves != t.leaves : cosine > foldedBack);
    return fits ? Match{j, cosine, squared} : Match{};
}

/// For each end the one that continues it most nearly.
std::vector<std::size_t> partnersOf(const std::vector<LooseEnd>& ends, bool mixed) {
    std::vector<Vec2> points;
    points.reserve(ends.size());
    for (const LooseEnd& end : ends) {
        points.push_back(end.point);
    }
    const NearPoints near(points);
    std::vector<std::size_t> partners(ends.size(), Match::none);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        Match best;
        const bool few =
            near.visit(ends[i].point, [&](std::uint32_t j) { best = std::max(best, matchOf(ends, i, j, mixed)); });
        partners[i] = few ? best.end : Match::none;
    }
    return partners;
}

/// The neighbour is remembered as if both ends were at the same point, so that its direction is right.
void join(const LooseEnd& end, const LooseEnd& partner, std::span<WallPart* const> walls) {
    const WallPart& other = *walls[partner.wall];
    Vec2 farEnd = partner.leaves ? other.b : other.a;
    if (partner.point != end.point) {
        farEnd += end.point - partner.point;
    }
    JoinedSide side = JoinedSide::Both;
    if (differ(end, partner)) {
        side = end.oneWay || end.leaves != partner.leaves ? JoinedSide::Left : JoinedSide::Right;
    }
    WallPart& wall = *walls[end.wall];
    if (end.leaves) {
        wall.joinedAtA = true;
        wall.sideAtA = side;
        wall.beforeA = farEnd;
    } else {
        wall.joinedAtB = true;
        wall.sideAtB = side;
        wall.afterB = farEnd;
    }
}

void joinEnds(const std::vector<LooseEnd>& ends, bool mixed, std::span<WallPart* const> walls) {
    const std::vector<std::size_t> partners = partnersOf(ends, mixed);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (partners[i] != Match::none && partners[partners[i]] == i) {
            join(ends[i], ends[partners[i]], walls);
        }
    }
}

} // namespace

void joinWalls(std::span<WallPart* const> walls) {
    std::vector<LooseEnd> ends = looseEnds(walls);
    joinEnds(ends, false, walls);
    std::erase_if(ends, [walls](const LooseEnd& end) {
        return end.leaves ? walls[end.wall]->joinedAtA : walls[end.wall]->joinedAtB;
    });
    const auto isLine = [](const LooseEnd& end) { return !end.oneWay; };
    if (std::any_of(ends.begin(), ends.end(), isLine) && !std::all_of(ends.begin(), ends.end(), isLine)) {
        joinEnds(ends, true, walls);
    }
}

} // namespace spacetow
