#include "core/physics/broad_phase/separating_face.h"

#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace spacetow {

bool isSlender(const Part& part) {
    const auto* convex = std::get_if<ConvexPart>(&part);
    if (convex == nullptr) {
        return false;
    }
    const std::span corners(convex->corners.data(), static_cast<std::size_t>(convex->count));
    constexpr double slenderness =
        8;              // of the squared length to the area; a box of 4 : 1 has 4.25, one of 8 : 1 has 8.1
    double longest = 0; // squared, m²
    for (const Vec2& corner : corners) {
        longest = std::max(longest, (corner - corners.front()).squaredNorm());
    }
    return longest > slenderness * signedArea(corners);
}

bool isInFrontOfFace(const Aabb& box, const ConvexPart& part, const Rot& rotation, const FatAabb& fat) {
    const Aabb from{box.min - fat.centers.max, box.max - fat.centers.min}; // `box` relative to the centre of mass
    const Vec2 center = from.center();
    const Vec2 half = 0.5 * from.size();
    for (std::size_t i = 0; i < static_cast<std::size_t>(part.count); ++i) {
        const Vec2 normal = rotation * part.normals[i];
        const double width = std::abs(normal.x()) * half.x() + std::abs(normal.y()) * half.y();
        const double length = std::abs(normal.y()) * half.x() + std::abs(normal.x()) * half.y();
        const double height = normal.dot(center);
        const double aside = std::abs(cross(normal, center)) + length;
        // When the part turns, the box comes nearer to the face by turn · aside in first order, height matters in
        // second.
        const double turn = fat.angleLeft;
        const double nearer = turn * aside + 0.5 * turn * turn * (std::abs(height) + width);
        if (height - width - part.normals[i].dot(part.corners[i]) - nearer > linearSlop) {
            return true;
        }
    }
    return false;
}

} // namespace spacetow
