#pragma once
// Shapes prepared for collision: circles, wall parts (edges and lines), and convex parts of polygons with at most eight
// corners; see convex_parts.h. Metres, local coordinates unless stated otherwise.

#include "core/geometry/shape.h"

#include <array>
#include <cstdint>
#include <variant>

namespace spacetow {

/// The sides of a wall on which its neighbour continues it: an edge continues a line on one side only.
enum class JoinedSide : std::uint8_t { Both, Left, Right };

/// A segment that is solid from one side (an edge) or from both (a line). If another wall continues it, the far end of
/// that neighbour is known (a ghost vertex), so that no body is caught at the joint.
struct WallPart {
    Vec2 a{0, 0};
    Vec2 b{1, 0};
    double depth = noBack; // metres; read for one-way walls only
    bool oneWay = true;
    bool joinedAtA = false; // the neighbour beforeA → a is solid on the same side
    bool joinedAtB = false; // the neighbour b → afterB is
    JoinedSide sideAtA = JoinedSide::Both;
    JoinedSide sideAtB = JoinedSide::Both;
    Vec2 beforeA{0, 0};
    Vec2 afterB{0, 0};
};

/// A convex polygon, anticlockwise. Face i runs from corner i to corner i + 1. A face that is a cut through the inside
/// of a concave polygon is not an outer face: it never gives a contact normal.
struct ConvexPart {
    static constexpr int maxCorners = 8;

    int count = 0;
    std::array<Vec2, maxCorners> corners;
    std::array<Vec2, maxCorners> normals; // unit, outward
    std::uint8_t outerFaces = 0;          // bit i: face i lies on the polygon's outline
    /// Unit normal of the face of the outline beyond corner i: if an outer face of this part starts at the corner, of
    /// the face that ends there, else of the one that starts there. Valid for parts with cuts only.
    std::array<Vec2, maxCorners> normalsBeyond;
    Vec2 center{0, 0}; // centroid of this part
    Vec2 whole{0, 0};  // centroid of the polygon that it was cut from; valid for parts with cuts only
};

inline const Vec2& cornerOf(const ConvexPart& part, int i) {
    return part.corners[static_cast<std::size_t>(i)];
}
inline const Vec2& normalOf(const ConvexPart& part, int i) {
    return part.normals[static_cast<std::size_t>(i)];
}
inline int cornerAfter(const ConvexPart& part, int i) {
    return i + 1 < part.count ? i + 1 : 0;
}
inline int cornerBefore(const ConvexPart& part, int i) {
    return i > 0 ? i - 1 : part.count - 1;
}
inline bool isOuterFace(const ConvexPart& part, int i) {
    return (part.outerFaces >> i & 1) != 0;
}

/// Whether some faces of the part lie inside the polygon that it was cut from.
inline bool isCut(const ConvexPart& part) {
    return part.outerFaces != (1u << part.count) - 1;
}

using Part = std::variant<Circle, WallPart, ConvexPart>;

/// Whether the part is a circle about the origin: turning the body does not move it.
inline bool isRound(const Part& part) {
    const auto* circle = std::get_if<Circle>(&part);
    return circle != nullptr && circle->center.x() == 0 && circle->center.y() == 0;
}

} // namespace spacetow
