#include "core/geometry/insert_corner.h"

namespace spacetow {

namespace {

/// The bits of the faces, where the one of `face` is now that of both of its pieces.
std::uint8_t withPiece(std::uint8_t faces, std::size_t face) {
    const unsigned upTo = faces & ((1u << (face + 1)) - 1);
    const unsigned from = faces & ~((1u << face) - 1);
    return static_cast<std::uint8_t>(upTo | from << 1);
}

} // namespace

void insertCorner(ConvexPart& part, int face, double at) {
    const auto i = static_cast<std::size_t>(face);
    const Vec2& from = part.corners[i];
    const Vec2& to = part.corners[face + 1 < part.count ? i + 1 : 0];
    const Vec2 corner = from + at * (to - from).normalized();
    for (auto k = static_cast<std::size_t>(part.count); k > i + 1; --k) {
        part.corners[k] = part.corners[k - 1];
        part.normals[k] = part.normals[k - 1];
        part.normalsBeyond[k] = part.normalsBeyond[k - 1];
    }
    part.corners[i + 1] = corner;
    part.normals[i + 1] = part.normalsBeyond[i + 1] = part.normals[i];
    part.outerFaces = withPiece(part.outerFaces, i);
    part.floorEdges = withPiece(part.floorEdges, i);
    ++part.count;
}

} // namespace spacetow
