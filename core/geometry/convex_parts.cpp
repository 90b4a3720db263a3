#include "core/geometry/convex_parts.h"

#include "core/geometry/polygon.h"
#include "core/geometry/triangulate.h"

namespace spacetow {

namespace {

Vec2 outwardNormal(const Vec2& from, const Vec2& to) {
    return -leftOf(to - from).normalized();
}

ConvexPart convexPart(std::span<const Vec2> outline, const std::vector<int>& piece) {
    const int total = static_cast<int>(outline.size());
    ConvexPart part;
    part.count = static_cast<int>(piece.size());
    const auto vertex = [&outline](int i) -> const Vec2& { return outline[static_cast<std::size_t>(i)]; };
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const int i = piece[k];
        const int next = piece[(k + 1) % piece.size()];
        part.corners[k] = vertex(i);
        part.normals[k] = outwardNormal(vertex(i), vertex(next));
        const int after = (i + 1) % total;
        const bool outer = next == after;
        part.normalsBeyond[k] =
            outer ? outwardNormal(vertex((i + total - 1) % total), vertex(i)) : outwardNormal(vertex(i), vertex(after));
        if (outer) {
            part.outerFaces = static_cast<std::uint8_t>(part.outerFaces | 1u << k);
        }
    }
    part.center = centroid(std::span(part.corners).first(piece.size()));
    return part;
}

struct PartMaker {
    std::vector<Part> operator()(const Circle& circle) const { return {circle}; }
    std::vector<Part> operator()(const Edge& edge) const {
        WallPart wall;
        wall.a = edge.a;
        wall.b = edge.b;
        wall.depth = edge.depth;
        return {wall};
    }
    std::vector<Part> operator()(const Line& line) const {
        WallPart wall;
        wall.a = line.a;
        wall.b = line.b;
        wall.depth = 0;
        wall.oneWay = false;
        return {wall};
    }
    std::vector<Part> operator()(const Polygon& polygon) const {
        const std::vector<Vec2> outline = cleanOutline(polygon.vertices);
        const Vec2 whole = outline.empty() ? Vec2(0, 0) : centroid(outline);
        std::vector<Part> parts;
        for (const std::vector<int>& piece : convexPieces(outline, ConvexPart::maxCorners)) {
            ConvexPart part = convexPart(outline, piece);
            part.whole = whole;
            parts.emplace_back(part);
        }
        return parts;
    }
};

} // namespace

std::vector<Part> partsOf(const Shape& shape) {
    return std::visit(PartMaker{}, shape);
}

void joinParts(std::span<Part* const> parts) {
    std::vector<WallPart*> walls;
    std::vector<ConvexPart*> convexParts;
    for (Part* part : parts) {
        if (auto* wall = std::get_if<WallPart>(part)) {
            walls.push_back(wall);
        } else if (auto* convex = std::get_if<ConvexPart>(part)) {
            convexParts.push_back(convex);
        }
    }
    joinWalls(walls);
    joinConvexParts(convexParts);
}

} // namespace spacetow
