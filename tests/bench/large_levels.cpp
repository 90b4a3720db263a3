#include "tests/bench/large_levels.h"

#include <cmath>
#include <numbers>

namespace spacetow::bench {

namespace {

constexpr int perChain = 100;  // edges
constexpr double cell = 6;     // m, of the square in which a chain lies
constexpr double margin = 0.5; // m
constexpr Key firstKey = 1000;

/// Points of the chain with this number, local to its cell: a wave, longer and lower from chain to chain.
std::vector<Vec2> wave(int number) {
    std::vector<Vec2> points;
    const double waves = 2 + number % 5;
    const double height = 0.6 + 0.25 * (number % 7);
    for (int i = 0; i <= perChain; ++i) {
        const double share = static_cast<double>(i) / perChain;
        points.emplace_back(margin + share * (cell - 2 * margin),
                            0.5 * cell + height * std::sin(2 * std::numbers::pi * waves * share));
    }
    return points;
}

/// Cells are taken line by line, in a square.
Vec2 placeOf(int number, int count) {
    const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
    return {cell * (number % columns), cell * (number / columns)}; // NOLINT(bugprone-integer-division)
}

Object bodyOf(Key key, std::vector<Vec2> vertices, const Vec2& position, bool closed) {
    BodyObject body;
    body.position = position;
    body.filter.tags = TagMask::bit(wallTag);
    body.shapes.emplace_back(EdgeChain{std::move(vertices), closed, noBack});
    return {key, {}, std::move(body), {}};
}

void addWaves(Level& level, int edges, bool single) {
    Key key = firstKey;
    const int count = edges / perChain;
    for (int number = 0; number < count; ++number) {
        const std::vector<Vec2> points = wave(number);
        const Vec2 place = placeOf(number, count);
        if (!single) {
            level.objects.append(bodyOf(key++, points, place, false));
            continue;
        }
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            level.objects.append(bodyOf(key++, {Vec2(0, 0), points[i + 1] - points[i]}, place + points[i], false));
        }
    }
}

/// Anticlockwise about the origin, rough on every scale.
std::vector<Vec2> caveWall(int edges) {
    std::vector<Vec2> points;
    const double radius = 3e-3 * edges; // m
    for (int i = 0; i < edges; ++i) {
        const double angle = 2 * std::numbers::pi * i / edges;
        const double r =
            radius * (1 + 0.2 * std::sin(5 * angle) + 0.04 * std::sin(61 * angle) + 0.004 * std::sin(1009 * angle));
        points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return points;
}

} // namespace

Level largeLevel(LargeLevel kind, int edges) {
    Level level;
    level.name = "Large";
    level.objects.append({1, {}, ShipObject{{-4, -4}, 0}, {}});
    level.objects.append({2, {}, PayloadObject{{-4, -6}, 0.2, 0.25}, {}});
    level.objects.append({3, {}, FinishObject{{-8, -4}, {-8, -6}}, {}});
    if (kind == LargeLevel::Wall) {
        level.objects.append(bodyOf(firstKey, caveWall(edges), {0, 0}, true));
    } else {
        addWaves(level, edges, kind == LargeLevel::Bodies);
    }
    return level;
}

} // namespace spacetow::bench
