#pragma once
// Outlines: closed chains of vertices in metres, the last joined to the first. Anticlockwise ones have positive area.

#include "core/math/vec.h"

#include <optional>
#include <span>
#include <vector>

namespace spacetow {

/// Shoelace formula, m²; positive when the outline runs anticlockwise.
double signedArea(std::span<const Vec2> outline);
/// Centroid of the enclosed area; the mean of the vertices if there is no area. Needs at least one vertex.
Vec2 centroid(std::span<const Vec2> outline);
/// Whether the outline has at least three vertices, none repeated, and no two sides meet except at a shared vertex.
/// O(n log n) for ordinary outlines.
bool isSimple(std::span<const Vec2> outline);
/// Even–odd rule; the outline itself may count as either side.
bool contains(std::span<const Vec2> outline, const Vec2& p);
/// Distance from `center` to the nearest point of the outline: for a centre inside, the radius of the largest circle
/// about it inside the outline.
double incircleRadius(std::span<const Vec2> outline, const Vec2& center);
/// Distance from `center` to the farthest vertex.
double outerRadius(std::span<const Vec2> outline, const Vec2& center);
/// Where the ray from `from` along `direction` first meets the outline.
std::optional<Vec2> outlinePoint(std::span<const Vec2> outline, const Vec2& from, const Vec2& direction);
/// Anticlockwise, the first vertex straight up. `count` ≥ 3, `radius` > 0.
std::vector<Vec2> regularPolygon(int count, double radius);

} // namespace spacetow
