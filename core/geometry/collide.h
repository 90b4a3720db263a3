#pragma once
// Collision functions: the contact manifold of two parts. Metres.

#include "core/geometry/part.h"
#include "core/geometry/wall_side.h"
#include "core/math/transform.h"

#include <array>
#include <cstdint>

namespace spacetow {

struct ManifoldPoint {
    Vec2 point{0, 0};          // world; half way between the two surfaces
    double separation = 0;     // metres along the normal; negative when the parts overlap
    std::uint32_t feature = 0; // identifies the corners and faces that touch, for the warm start
};

/// The part whose face gives the normal. The normal turns with that part; a normal between two corners turns with
/// neither.
enum class NormalOf : std::uint8_t { Corners, FirstFace, SecondFace };

/// At most two points that share one normal; no point when the parts are further apart than the margin.
struct Manifold {
    Vec2 normal{0, 1}; // unit, from the first part to the second
    std::array<ManifoldPoint, 2> points;
    int count = 0;
    NormalOf normalOf = NormalOf::Corners;
    double apart = 0; // m, ≥ 0: if there is no point, a lower bound of the distance of the parts; 0: unknown
};

/// Contact of a part with a circle, both in the same coordinates; the normal points from the part to the circle.
Manifold collideCircle(const Part& part, const Circle& circle, double margin);

/// The same for one side of a wall.
Manifold sideAgainstCircle(const WallSide& side, const Circle& circle, double margin);

/// Contact of two parts no further apart than `margin` metres (≥ 0). Swapping the arguments swaps the normal and
/// changes nothing else. Two walls never touch each other.
Manifold collide(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB, double margin);

} // namespace spacetow
