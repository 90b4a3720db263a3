#pragma once
// Shapes prepared for collision: convex parts in local coordinates. A circle stays itself, an edge or a line becomes
// one wall part, a polygon becomes convex parts of at most eight corners (see convex_parts.h).

#include "core/geometry/shape.h"

#include <array>
#include <cstdint>
#include <variant>

namespace spacetow {

/// On which of its sides something continues a wall: a line that meets an edge goes on on one of them.
enum class JoinedSide : std::uint8_t { Both, Left, Right };

/// A segment that is solid from one side (an edge) or from both (a line). Where another wall continues it end to
/// end, the far end of that neighbour is known, so that what slides across the joint is not caught by the corner.
struct WallPart {
    Vec2 a{0, 0};
    Vec2 b{1, 0};
    double depth = noBack; // metres; read for one-way walls only
    bool oneWay = true;
    bool joinedAtA = false; // beforeA → a is a neighbouring wall that is solid on the same side
    bool joinedAtB = false; // b → afterB likewise
    JoinedSide sideAtA = JoinedSide::Both;
    JoinedSide sideAtB = JoinedSide::Both;
    Vec2 beforeA{0, 0};
    Vec2 afterB{0, 0};
};

/// A convex polygon, anticlockwise. Face i runs from corner i to corner i + 1. Faces that are cuts through the inside
/// of a concave polygon are not outer ones: they never give a contact normal.
struct ConvexPart {
    static constexpr int maxCorners = 8;

    int count = 0;
    std::array<Vec2, maxCorners> corners;
    std::array<Vec2, maxCorners> normals; // unit, outward
    std::uint8_t outerFaces = 0;          // bit i: face i lies on the polygon's outline
    /// Unit; of the outline's face on the other side of corner i: of the one that ends there where an outer face of
    /// this part starts, else of the one that starts there.
    std::array<Vec2, maxCorners> normalsBeyond;
    Vec2 center{0, 0}; // centroid of this part
    Vec2 whole{0, 0};  // centroid of the polygon that it was cut from; read for parts with cuts
};

using Part = std::variant<Circle, WallPart, ConvexPart>;

/// A circle around the origin of its body, which looks the same however the body turns.
inline bool isRound(const Part& part) {
    const auto* circle = std::get_if<Circle>(&part);
    return circle != nullptr && circle->center.x() == 0 && circle->center.y() == 0;
}

} // namespace spacetow
