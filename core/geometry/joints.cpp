#include "core/geometry/convex_parts.h"

#include <algorithm>
#include <optional>

namespace spacetow {

namespace {

constexpr std::size_t crowd = 200;        // ends at one point beyond which nothing is joined there
constexpr double foldedBack = -1 + 1e-12; // cosine: two lines on top of each other do not continue one another

/// One end of a wall, seen from its point.
struct LooseEnd {
    Vec2 point;
    bool oneWay;
    bool leaves; // the wall starts here
    std::size_t wall;
    Vec2 away; // unit, along the wall
    std::optional<std::size_t> partner;
};

bool pointLess(const Vec2& p, const Vec2& q) {
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
}

/// Cosine of how straight two ends continue each other, nothing when they cannot.
std::optional<double> straightness(const LooseEnd& s, const LooseEnd& t) {
    const double cosine = -s.away.dot(t.away);
    const bool fits = s.wall != t.wall && (s.oneWay ? s.leaves != t.leaves : cosine > foldedBack);
    return fits ? std::optional(cosine) : std::nullopt;
}

void choosePartners(std::span<LooseEnd> ends) {
    for (std::size_t i = 0; i < ends.size(); ++i) {
        double best = -2;
        for (std::size_t j = 0; j < ends.size(); ++j) {
            const auto cosine = straightness(ends[i], ends[j]);
            if (cosine && *cosine > best) {
                best = *cosine;
                ends[i].partner = j;
            }
        }
    }
}

void join(const LooseEnd& end, const LooseEnd& partner, std::span<WallPart* const> walls) {
    const WallPart& other = *walls[partner.wall];
    const Vec2 farEnd = partner.leaves ? other.b : other.a;
    WallPart& wall = *walls[end.wall];
    if (end.leaves) {
        wall.joinedAtA = true;
        wall.beforeA = farEnd;
    } else {
        wall.joinedAtB = true;
        wall.afterB = farEnd;
    }
}

std::vector<LooseEnd> sortedEnds(std::span<WallPart* const> walls) {
    std::vector<LooseEnd> ends;
    ends.reserve(2 * walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        WallPart& wall = *walls[i];
        wall.joinedAtA = wall.joinedAtB = false;
        wall.beforeA = wall.afterB = Vec2(0, 0);
        const Vec2 along = (wall.b - wall.a).normalized();
        if (isFinite(along) && wall.a != wall.b) {
            ends.push_back({wall.a, wall.oneWay, true, i, along, {}});
            ends.push_back({wall.b, wall.oneWay, false, i, -along, {}});
        }
    }
    std::sort(ends.begin(), ends.end(), [](const LooseEnd& s, const LooseEnd& t) {
        if (s.point != t.point) {
            return pointLess(s.point, t.point);
        }
        return s.oneWay != t.oneWay ? s.oneWay : s.wall < t.wall;
    });
    return ends;
}

/// A face of a part, from its lower to its higher corner whichever way it runs.
struct Face {
    Vec2 low, high;
    std::size_t part;
    int index;
};

/// Where a face of the joined parts' outline arrives at a point or leaves it.
struct OutlineEnd {
    Vec2 point;
    Vec2 normal;
    std::size_t part;
};

int nextCorner(const ConvexPart& part, int i) {
    return i + 1 < part.count ? i + 1 : 0;
}
const Vec2& corner(const ConvexPart& part, int i) {
    return part.corners[static_cast<std::size_t>(i)];
}
bool isOuter(const ConvexPart& part, int face) {
    return (part.outerFaces >> face & 1) != 0;
}

void hideSharedFaces(std::span<ConvexPart* const> parts) {
    std::vector<Face> faces;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        for (int i = 0; i < parts[p]->count; ++i) {
            const Vec2& a = corner(*parts[p], i);
            const Vec2& b = corner(*parts[p], nextCorner(*parts[p], i));
            if (isOuter(*parts[p], i)) {
                faces.push_back(pointLess(a, b) ? Face{a, b, p, i} : Face{b, a, p, i});
            }
        }
    }
    std::sort(faces.begin(), faces.end(), [](const Face& s, const Face& t) {
        if (s.low != t.low) {
            return pointLess(s.low, t.low);
        }
        return s.high != t.high ? pointLess(s.high, t.high) : s.part < t.part;
    });
    for (std::size_t k = 1; k < faces.size(); ++k) {
        const Face& s = faces[k - 1];
        const Face& t = faces[k];
        if (s.low != t.low || s.high != t.high) {
            continue;
        }
        const bool opposite = corner(*parts[s.part], s.index) != corner(*parts[t.part], t.index);
        if (opposite) {
            for (const Face& face : {s, t}) {
                const unsigned rest = parts[face.part]->outerFaces & ~(1u << face.index);
                parts[face.part]->outerFaces = static_cast<std::uint8_t>(rest);
            }
            ++k; // each face is shared by two parts at most
        }
    }
}

std::vector<OutlineEnd> outlineEnds(std::span<ConvexPart* const> parts, bool arriving) {
    std::vector<OutlineEnd> ends;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        for (int i = 0; i < parts[p]->count; ++i) {
            if (isOuter(*parts[p], i)) {
                const Vec2& point = corner(*parts[p], arriving ? nextCorner(*parts[p], i) : i);
                ends.push_back({point, parts[p]->normals[static_cast<std::size_t>(i)], p});
            }
        }
    }
    std::sort(ends.begin(), ends.end(), [](const OutlineEnd& s, const OutlineEnd& t) {
        return s.point != t.point ? pointLess(s.point, t.point) : s.part < t.part;
    });
    return ends;
}

/// The normal of the face that continues one with this normal most nearly, its own where nothing does.
Vec2 straightest(const std::vector<OutlineEnd>& ends, const Vec2& point, const Vec2& own) {
    const auto first = std::lower_bound(ends.begin(), ends.end(), point,
                                        [](const OutlineEnd& s, const Vec2& p) { return pointLess(s.point, p); });
    Vec2 normal = own;
    double best = -2;
    for (auto it = first; it != ends.end() && it->point == point && it - first < std::ptrdiff_t{crowd}; ++it) {
        if (it->normal.dot(own) > best) {
            best = it->normal.dot(own);
            normal = it->normal;
        }
    }
    return normal;
}

} // namespace

void joinWalls(std::span<WallPart* const> walls) {
    std::vector<LooseEnd> ends = sortedEnds(walls);
    for (std::size_t begin = 0; begin < ends.size();) {
        std::size_t end = begin;
        while (end < ends.size() && ends[end].point == ends[begin].point && ends[end].oneWay == ends[begin].oneWay) {
            ++end;
        }
        const std::span group = std::span(ends).subspan(begin, end - begin);
        if (group.size() >= 2 && group.size() <= crowd) {
            choosePartners(group);
            for (std::size_t i = 0; i < group.size(); ++i) {
                if (group[i].partner && group[*group[i].partner].partner == i) {
                    join(group[i], group[*group[i].partner], walls);
                }
            }
        }
        begin = end;
    }
}

void joinConvexParts(std::span<ConvexPart* const> parts) {
    hideSharedFaces(parts);
    const std::vector<OutlineEnd> arrivals = outlineEnds(parts, true);
    const std::vector<OutlineEnd> departures = outlineEnds(parts, false);
    for (ConvexPart* const part : parts) {
        for (int i = 0; i < part->count; ++i) {
            const int before = i > 0 ? i - 1 : part->count - 1;
            const Vec2& own = part->normals[static_cast<std::size_t>(i)];
            const Vec2& ownBefore = part->normals[static_cast<std::size_t>(before)];
            Vec2& beyond = part->normalsBeyond[static_cast<std::size_t>(i)];
            if (isOuter(*part, i)) {
                beyond = isOuter(*part, before) ? ownBefore : straightest(arrivals, corner(*part, i), own);
            } else if (isOuter(*part, before)) {
                beyond = straightest(departures, corner(*part, i), ownBefore);
            }
        }
    }
}

} // namespace spacetow
