#include "core/geometry/convex_parts.h"
#include "core/geometry/near_points.h"

#include <tuple>

namespace spacetow {

namespace {

using ConvexParts = std::span<ConvexPart* const>;

/// A face of one of the parts, from corner to corner.
struct Flank {
    std::size_t part;
    int face;
    Vec2 from, to;

    double length() const { return (to - from).norm(); }
};

/// A corner that is to come into the middle of a face.
struct Split {
    std::size_t part;
    int face;
    double at; // m from its start

    bool operator<(const Split& o) const { return std::tie(part, face, at) < std::tie(o.part, o.face, o.at); }
};

std::vector<Flank> outerFlanks(ConvexParts parts) {
    std::vector<Flank> flanks;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const ConvexPart& part = *parts[p];
        for (int i = 0; i < part.count; ++i) {
            if (isOuterFace(part, i)) {
                const auto next = static_cast<std::size_t>(cornerAfter(part, i));
                flanks.push_back({p, i, part.corners[static_cast<std::size_t>(i)], part.corners[next]});
            }
        }
    }
    return flanks;
}

std::vector<Vec2> pointsOf(const std::vector<Flank>& flanks, bool starts) {
    std::vector<Vec2> points;
    points.reserve(flanks.size());
    for (const Flank& flank : flanks) {
        points.push_back(starts ? flank.from : flank.to);
    }
    return points;
}

bool meet(const Vec2& p, const Vec2& q, double within) {
    return (p - q).squaredNorm() <= within * within;
}

/// Where on the longer of two flanks that leave one corner the other, which lies on it, ends; 0 where it does not.
/// `from` is the corner, `to` the other end of the longer one.
double endOn(const Vec2& from, const Vec2& to, const Vec2& shorterEnd, double within) {
    const Vec2 along = (to - from).normalized();
    const Vec2 way = shorterEnd - from;
    const double at = along.dot(way);
    const bool inside = at > within && at < (to - from).norm() - within;
    return inside && std::abs(cross(along, way)) <= within ? at : 0;
}

/// Two faces that share a corner and lie on each other, one of them longer, as where floors of different heights stand
/// side by side: what of the longer one is covered becomes a face of its own.
std::vector<Split> splitsOf(const std::vector<Flank>& flanks) {
    std::vector<Split> splits;
    const NearPoints ends(pointsOf(flanks, false));
    for (const Flank& s : flanks) {
        ends.visit(s.from, [&](std::uint32_t index) {
            const Flank& t = flanks[index]; // ends where s starts
            const double within = meetingDistance(s.length(), t.length());
            if (s.part == t.part || !meet(s.from, t.to, within)) {
                return;
            }
            if (const double at = endOn(s.from, s.to, t.from, within); at > 0) {
                splits.push_back({s.part, s.face, at});
            } else if (const double back = endOn(t.to, t.from, s.to, within); back > 0) {
                splits.push_back({t.part, t.face, t.length() - back});
            }
        });
    }
    std::sort(splits.begin(), splits.end());
    return splits;
}

/// A new corner after corner `face`; those behind it move up by one.
void insertCorner(ConvexPart& part, int face, double at) {
    const auto i = static_cast<std::size_t>(face);
    const Vec2& from = part.corners[i];
    const Vec2& to = part.corners[static_cast<std::size_t>(cornerAfter(part, face))];
    const Vec2 corner = from + at * (to - from).normalized();
    for (auto k = static_cast<std::size_t>(part.count); k > i + 1; --k) {
        part.corners[k] = part.corners[k - 1];
        part.normals[k] = part.normals[k - 1];
        part.normalsBeyond[k] = part.normalsBeyond[k - 1];
    }
    part.corners[i + 1] = corner;
    part.normals[i + 1] = part.normalsBeyond[i + 1] = part.normals[i];
    const unsigned below = part.outerFaces & ((1u << (i + 1)) - 1);
    const unsigned above = part.outerFaces & ~((1u << (i + 1)) - 1);
    part.outerFaces = static_cast<std::uint8_t>(below | above << 1 | 1u << (i + 1));
    ++part.count;
}

/// As far as there is room for more corners.
void splitFaces(ConvexParts parts) {
    const std::vector<Split> splits = splitsOf(outerFlanks(parts));
    for (std::size_t i = splits.size(); i-- > 0;) { // from behind, so that the others stay where they are
        const Split& split = splits[i];
        const bool again = i + 1 < splits.size() && splits[i + 1].part == split.part &&
                           splits[i + 1].face == split.face && splits[i + 1].at - split.at <= jointTolerance;
        if (!again && parts[split.part]->count < ConvexPart::maxCorners) {
            insertCorner(*parts[split.part], split.face, split.at);
        }
    }
}

void hide(ConvexParts parts, const Flank& flank) {
    const unsigned rest = parts[flank.part]->outerFaces & ~(1u << flank.face);
    parts[flank.part]->outerFaces = static_cast<std::uint8_t>(rest);
}

/// Each face is shared by two parts at most.
void hideSharedFaces(ConvexParts parts) {
    const std::vector<Flank> flanks = outerFlanks(parts);
    const NearPoints starts(pointsOf(flanks, true));
    for (const Flank& s : flanks) {
        if (!isOuterFace(*parts[s.part], s.face)) {
            continue;
        }
        std::uint32_t shared = static_cast<std::uint32_t>(flanks.size());
        const bool few = starts.visit(s.to, [&](std::uint32_t index) {
            const Flank& t = flanks[index];
            const double within = meetingDistance(s.length(), t.length());
            if (t.part != s.part && isOuterFace(*parts[t.part], t.face) && meet(s.to, t.from, within) &&
                meet(s.from, t.to, within)) {
                shared = std::min(shared, index);
            }
        });
        if (few && shared < flanks.size()) {
            hide(parts, s);
            hide(parts, flanks[shared]);
        }
    }
}

/// Where faces of the joined parts' outline arrive at points, or leave them.
struct OutlineEnds {
    std::vector<Vec2> normals;
    NearPoints near;

    OutlineEnds(ConvexParts parts, const std::vector<Flank>& flanks, bool starts) : near(pointsOf(flanks, starts)) {
        for (const Flank& flank : flanks) {
            normals.push_back(parts[flank.part]->normals[static_cast<std::size_t>(flank.face)]);
        }
    }

    /// The normal of the face that continues one with this normal most nearly, its own where nothing does.
    Vec2 straightest(const Vec2& point, const Vec2& own) const {
        auto best = static_cast<std::uint32_t>(normals.size());
        const bool few = near.visit(point, [&](std::uint32_t i) {
            const double gain = best < normals.size() ? normals[i].dot(own) - normals[best].dot(own) : 1;
            best = gain > 0 || (gain == 0 && i < best) ? i : best;
        });
        return few && best < normals.size() ? normals[best] : own;
    }
};

} // namespace

void joinConvexParts(std::span<ConvexPart* const> parts) {
    splitFaces(parts);
    hideSharedFaces(parts);
    const std::vector<Flank> flanks = outerFlanks(parts);
    const OutlineEnds arrivals(parts, flanks, false);
    const OutlineEnds departures(parts, flanks, true);
    for (ConvexPart* const part : parts) {
        for (int i = 0; i < part->count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const int before = i > 0 ? i - 1 : part->count - 1;
            const Vec2& own = part->normals[k];
            const Vec2& ownBefore = part->normals[static_cast<std::size_t>(before)];
            if (isOuterFace(*part, i)) {
                part->normalsBeyond[k] =
                    isOuterFace(*part, before) ? ownBefore : arrivals.straightest(part->corners[k], own);
            } else if (isOuterFace(*part, before)) {
                part->normalsBeyond[k] = departures.straightest(part->corners[k], ownBefore);
            }
        }
    }
}

} // namespace spacetow
