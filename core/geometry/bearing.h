#pragma once
// Which corners and faces of polygons may meet: those of the outline, where what belongs to it is over the other part.

#include "core/geometry/collide_pairs.h"

namespace spacetow {

constexpr double sameDepth = 1e-6;    // m: separations nearer than this count as equal
constexpr double parallelTurn = 2e-6; // sine of the angle between faces that lie flat on each other

/// A face as what may lie over it sees it.
struct Span {
    Vec2 from, along; // unit
    double length;

    Span(const ConvexPart& part, int face)
        : from(cornerOf(part, face)), along(leftOf(normalOf(part, face))),
          length(along.dot(cornerOf(part, cornerAfter(part, face)) - from)) {}

    /// Whether some of p…q lies over it.
    bool meets(const Vec2& p, const Vec2& q) const {
        const double atP = along.dot(p - from);
        const double atQ = along.dot(q - from);
        return std::max(atP, atQ) >= 0 && std::min(atP, atQ) <= length;
    }
    /// Whether p…q lies over more of it than an end.
    bool overlaps(const Vec2& p, const Vec2& q) const {
        const double atP = along.dot(p - from);
        const double atQ = along.dot(q - from);
        return std::max(atP, atQ) > sameDepth && std::min(atP, atQ) < length - sameDepth;
    }
};

/// Whether the face lies flat on one with this normal.
inline bool liesFlat(const ConvexPart& part, int face, const Vec2& normal) {
    return normalOf(part, face).dot(normal) < 0 && std::fabs(cross(normalOf(part, face), normal)) <= parallelTurn;
}

/// Whether the corner may meet a face of the other part, or another one that is as deep along the normal: what comes
/// down flat does so with two, one of which may be in the middle of a side of the outline.
bool levelBears(const ConvexPart& part, int corner, const ConvexPart& reference, int face);

/// Whether a face has to do with the other part: where it goes on as an inner one, what is over that alone is the
/// affair of the part beyond.
bool isBeside(const ConvexPart& reference, int face, const ConvexPart& other);

} // namespace spacetow
