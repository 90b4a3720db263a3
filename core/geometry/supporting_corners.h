#pragma once
// Which corners and faces of the parts of a polygon may touch another part: those on the outline of the polygon.
// Lengths in m.

#include "core/geometry/collide_pairs.h"

namespace spacetow {

constexpr double sameDepth = 1e-6;    // m: separations that differ by less than this count as equal
constexpr double parallelTurn = 2e-6; // sine of the angle between faces that lie flat on each other

/// The extent of a face along its own direction.
struct Span {
    Vec2 from;     // start of the face
    Vec2 along;    // unit, to its end
    double length; // m

    Span(const ConvexPart& part, int face)
        : from(cornerOf(part, face)), along(leftOf(normalOf(part, face))),
          length(along.dot(cornerOf(part, cornerAfter(part, face)) - from)) {}

    /// Whether the segment p…q has a point over the face; ends count.
    bool meets(const Vec2& p, const Vec2& q) const {
        const double atP = along.dot(p - from);
        const double atQ = along.dot(q - from);
        return std::max(atP, atQ) >= 0 && std::min(atP, atQ) <= length;
    }
    /// Whether the segment p…q lies over more of the face than one end, by more than `sameDepth`.
    bool overlaps(const Vec2& p, const Vec2& q) const {
        const double atP = along.dot(p - from);
        const double atQ = along.dot(q - from);
        return std::max(atP, atQ) > sameDepth && std::min(atP, atQ) < length - sameDepth;
    }
};

/// Whether the face is parallel and opposite to a face with this normal.
inline bool liesFlat(const ConvexPart& part, int face, const Vec2& normal) {
    return normalOf(part, face).dot(normal) < 0 && std::fabs(cross(normalOf(part, face), normal)) <= parallelTurn;
}

/// Whether the corner of `part`, or another corner at the same depth, may touch the face of `reference`. A flat face
/// has two corners at the same depth, of which one may lie in the middle of a side of the outline.
bool levelSupports(const ConvexPart& part, int corner, const ConvexPart& reference, int face);

/// Whether the face may give the contact normal for `other`. A side of the outline may continue as an inner face of
/// this part; a part that is over the inner face only belongs to the neighbour beyond it.
bool mayBeReferenceFace(const ConvexPart& reference, int face, const ConvexPart& other);

} // namespace spacetow
