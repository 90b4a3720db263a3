#include "tests/support/random_cave.h"

#include "core/base/random.h"
#include "core/geometry/intersect.h"
#include "core/level/leak.h"
#include "core/level/leak_paths.h"
#include "core/math/rot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow::test {

namespace {

constexpr double widestGap = 0.33; // m, less than the ship is wide

Vec2 polar(double radius, double angle) {
    return radius * Rot::fromAngle(angle).right();
}

/// The corners of the cave, anticlockwise about the origin; some are star-shaped, some wind.
std::vector<Vec2> caveCorners(Random& random) {
    const int count = 9 + static_cast<int>(random.below(50));
    const double radius = count * random.uniform(0.25, 0.9) + 2;
    const double roughness = random.uniform(0.02, 0.3);
    const double swirl = random.below(2) == 0 ? 0 : random.uniform(0.2, 0.8);
    std::vector<Vec2> corners;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.uniform(-0.2, 0.2)) / count;
        const double away = radius * (1 + random.uniform(-roughness, roughness));
        corners.push_back(polar(away, angle + swirl * std::sin(3 * angle) * roughness));
    }
    return corners;
}

CavePiece::Kind kindOf(Random& random, unsigned theme) {
    constexpr CavePiece::Kind kinds[] = {CavePiece::Kind::Edge, CavePiece::Kind::Line, CavePiece::Kind::Polygon,
                                         CavePiece::Kind::Circle};
    return kinds[theme < 4 ? theme : random.below(4)];
}

BodyObject pieceBody(LevelShape shape) {
    BodyObject body;
    body.shapes = {std::move(shape)};
    return body;
}

void append(Level& level, const BodyObject& body) {
    const auto key = static_cast<Key>(100 + level.objects.size());
    level.objects.append({key, "wall " + std::to_string(key), body, {}});
}

/// Blocks, loose walls and one-way shelves, in the cave but away from its middle, and some outside.
void decorate(Random& random, double radius, Level& level) {
    for (unsigned i = random.below(5); i > 0; --i) {
        const Vec2 at = polar(radius * random.uniform(0.35, 0.5), random.uniform(0, 2 * std::numbers::pi));
        const Vec2 along = polar(0.12 * radius, random.uniform(0, 2 * std::numbers::pi));
        switch (random.below(4)) {
        case 0:
            append(level, pieceBody(LineChain{{at - along, at + along}, false}));
            break;
        case 1:
            append(level, pieceBody(EdgeChain{{at - along, at + along}, false, 0.1}));
            break;
        case 2:
            append(level, pieceBody(Circle{at, along.norm()}));
            break;
        default:
            append(level, pieceBody(Polygon{{at, at + along, at + leftOf(along)}}));
        }
    }
    if (random.below(3) == 0) {
        append(level, pieceBody(Circle{polar(2.5 * radius, 1), 0.5 * radius}));
    }
}

LevelShape pieceShape(const CavePiece& piece) {
    const Vec2 along = piece.b - piece.a;
    if (piece.kind == CavePiece::Kind::Polygon) {
        const Vec2 out = -leftOf(along).normalized() * std::max(0.5, 0.3 * along.norm());
        return Polygon{{piece.b, piece.a, piece.a + out, piece.b + out}};
    }
    return Circle{0.5 * (piece.a + piece.b), 0.5 * along.norm()};
}

void addToChain(std::vector<Vec2>& vertices, const CavePiece& piece) {
    if (vertices.empty()) {
        vertices.push_back(piece.a);
    }
    vertices.push_back(piece.b);
}

} // namespace

RandomCave caveAtRandom(std::uint64_t seed) {
    Random random(seed);
    RandomCave cave;
    const std::vector<Vec2> corners = caveCorners(random);
    const Vec2 middle(random.uniform(-100, 100), random.uniform(-100, 100));
    const unsigned theme = random.below(8);
    double least = corners.front().norm();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        least = std::min(least, corners[i].norm());
        CavePiece piece;
        piece.kind = kindOf(random, theme);
        piece.a = middle + corners[i];
        piece.b = middle + corners[(i + 1) % corners.size()];
        const bool isWall = piece.kind == CavePiece::Kind::Edge || piece.kind == CavePiece::Kind::Line;
        piece.isChained = isWall && i > 0 && cave.pieces.back().kind == piece.kind && random.below(6) != 0;
        const double length = (piece.b - piece.a).norm();
        if (!piece.isChained && length > 1 && random.below(2) == 0) {
            piece.a += random.uniform(0, widestGap) / length * (piece.b - piece.a);
        }
        cave.pieces.push_back(piece);
    }
    Level around;
    decorate(random, least, around);
    for (const Object& object : around.objects) {
        Object moved = object;
        std::get<BodyObject>(moved.data).position = middle;
        cave.decoration.objects.append(moved);
    }
    cave.ship = middle;
    return cave;
}

int RandomCave::weakPiece(std::uint64_t seed) const {
    Random random(seed);
    const LeakMesh mesh(leakWalls(level(), [](int) { return false; }), ship, leastShipWidth(), {});
    const Reach reach = reachOf(mesh, {});
    for (int i = 0; i < 60; ++i) {
        const auto at = random.below(static_cast<std::uint32_t>(pieces.size()));
        const Vec2 along = pieces[at].b - pieces[at].a;
        const Vec2 out = -leftOf(along).normalized();
        const Vec2 half = 0.25 * along.normalized(); // more than half the ship's width
        if (along.norm() < 0.6) {
            continue;
        }
        RandomCave without = *this;
        without.pieces[at].isMissing = true;
        const Vec2 middle = 0.5 * (pieces[at].a + pieces[at].b);
        const double bulge = pieces[at].kind == CavePiece::Kind::Circle ? 0.5 * along.norm() : 0;
        const Vec2 from = middle - (0.4 + bulge) * out;
        const Vec2 to = middle + std::max(1.5, along.norm()) * out;
        if (reach.triangles[static_cast<std::size_t>(mesh.triangleAt(from))] == 0) {
            continue;
        }
        const auto walls = leakWalls(without.level(), [](int) { return false; });
        if (std::ranges::none_of(walls, [&](const LeakWall& wall) {
                return segmentsMeet(from - half, to - half, wall.a, wall.b) ||
                       segmentsMeet(from + half, to + half, wall.a, wall.b) ||
                       segmentsMeet(from - half, from + half, wall.a, wall.b) ||
                       segmentsMeet(to - half, to + half, wall.a, wall.b);
            })) {
            return static_cast<int>(at);
        }
    }
    return -1;
}

Level RandomCave::level(std::vector<int>* objectOf) const {
    Level level = decoration;
    level.objects.append({1, "ship", ShipObject{ship, 0}, {}});
    std::vector<int> objects(pieces.size(), -1);
    std::vector<LevelShape> chains; // of the body that is being made
    std::vector<Vec2> vertices;
    CavePiece::Kind kind = CavePiece::Kind::Edge;
    const auto endChain = [&] {
        if (!vertices.empty()) {
            chains.push_back(kind == CavePiece::Kind::Edge ? LevelShape(EdgeChain{vertices, false, 0.3})
                                                           : LevelShape(LineChain{vertices, false}));
            vertices.clear();
        }
    };
    const auto endBody = [&] {
        endChain();
        if (!chains.empty()) {
            BodyObject body;
            body.shapes = ShapeList(chains);
            append(level, body);
            chains.clear();
        }
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const CavePiece& piece = pieces[i];
        if (!piece.isChained) {
            endBody();
        }
        kind = piece.kind;
        objects[i] = piece.isMissing ? -1 : level.objects.size();
        if (piece.isMissing) {
            endChain();
        } else if (piece.kind == CavePiece::Kind::Polygon || piece.kind == CavePiece::Kind::Circle) {
            append(level, pieceBody(pieceShape(piece)));
        } else if (piece.isReversed) {
            endChain();
            chains.push_back(EdgeChain{{piece.b, piece.a}, false, 0.3});
        } else {
            addToChain(vertices, piece);
        }
    }
    endBody();
    if (objectOf != nullptr) {
        *objectOf = objects;
    }
    return level;
}

} // namespace spacetow::test
