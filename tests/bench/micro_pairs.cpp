// The narrow phase and the time of impact, a pair of parts at a time. Each benchmark goes round many poses of its pair,
// so that no branch is learned by heart; the time shown is for one pair.

#include "core/base/random.h"
#include "core/geometry/cast.h"
#include "core/geometry/closest.h"
#include "core/geometry/collide.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/polygon.h"

#include <benchmark/benchmark.h>

#include <array>
#include <numbers>
#include <string>
#include <vector>

using namespace spacetow;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double margin = 0.02; // m, of the narrow phase
constexpr double size = 0.5;    // m, radius of circles and polygons
constexpr std::size_t caseCount = 2048;

struct Pair {
    std::string name;
    Part a, b;
};

Part polygon(int corners) {
    return partsOf(Polygon{regularPolygon(corners, size)}).front();
}

std::vector<Pair> pairs() {
    const Part circle = Circle{{0, 0}, size};
    const Part wall = partsOf(Edge{{-5, 0}, {5, 0}}).front();
    return {{"circle-circle", circle, circle},           {"wall-circle", wall, circle},
            {"convex4-circle", polygon(4), circle},      {"convex8-circle", polygon(8), circle},
            {"wall-convex4", wall, polygon(4)},          {"wall-convex8", wall, polygon(8)},
            {"convex4-convex4", polygon(4), polygon(4)}, {"convex4-convex8", polygon(4), polygon(8)},
            {"convex8-convex8", polygon(8), polygon(8)}};
}

struct Placed {
    Transform a, b;
    Vec2 normal; // unit, from a to b
};

/// Poses at random with the given gap (m, > 0) between the surfaces; b is in front of a when that is a wall.
Placed apart(Random& random, const Pair& pair, double gap) {
    Placed placed;
    const bool isWall = std::holds_alternative<WallPart>(pair.a);
    const double direction = isWall ? random.uniform(pi / 4, 3 * pi / 4) : random.uniform(-pi, pi);
    const Vec2 target{isWall ? random.uniform(-3, 3) : 0, 0};
    const Vec2 way{std::cos(direction), std::sin(direction)};
    placed.a = {{random.uniform(-10, 10), random.uniform(-10, 10)}, Rot::fromAngle(random.uniform(-pi, pi))};
    placed.b.rotation = Rot::fromAngle(random.uniform(-pi, pi));
    double distance = 4, ahead = 1;
    for (int i = 0; i < 200 && ahead > 1e-9; ++i) { // advances by what is surely free
        placed.b.position = placed.a.toWorld(target + distance * way);
        const ClosestPoints closest = closestPoints(pair.a, placed.a, pair.b, placed.b);
        placed.normal = closest.normal;
        ahead = closest.distance - gap;
        distance -= ahead;
    }
    return placed;
}

double gapOf(const std::string& state, Random& random) {
    return state == "near" ? random.uniform(0.1 * margin, 0.9 * margin) : random.uniform(0.1, 0.5);
}

void collidePairs(benchmark::State& state, const Pair& pair, const std::string& where) {
    Random random; // always the same poses
    std::vector<Placed> cases;
    for (std::size_t i = 0; i < caseCount; ++i) {
        const bool touching = where == "touching";
        cases.push_back(apart(random, pair, touching ? 1e-4 : gapOf(where, random)));
        if (touching) {
            cases.back().b.position -= random.uniform(2e-4, 0.01) * cases.back().normal;
        }
    }
    std::size_t i = 0, points = 0;
    for (auto _ : state) {
        const Placed& at = cases[i++ % caseCount];
        const Manifold manifold = collide(pair.a, at.a, pair.b, at.b, margin);
        points += static_cast<std::size_t>(manifold.count);
    }
    state.counters["points"] = benchmark::Counter(static_cast<double>(points), benchmark::Counter::kAvgIterations);
}

struct Flight {
    Sweep a, b;
};

/// b comes from a metre away straight at a, or passes it at a distance; turning or not.
Flight flight(Random& random, const Pair& pair, const std::string& how) {
    const bool passes = how == "passing";
    const Placed placed = apart(random, pair, passes ? 0.1 : 1);
    const Vec2 side{-placed.normal.y(), placed.normal.x()};
    Flight result;
    result.a.start = placed.a;
    result.b.start = placed.b;
    result.b.translation = passes ? Vec2(2 * side) : Vec2(-2 * placed.normal);
    if (passes) {
        result.b.start.position -= side;
    }
    result.b.turn = how == "turning" ? random.uniform(-pi, pi) : 0;
    return result;
}

void castPairs(benchmark::State& state, const Pair& pair, const std::string& how) {
    constexpr double gap = 0.005; // m
    Random random;                // always the same poses
    std::vector<Flight> cases;
    for (std::size_t i = 0; i < caseCount; ++i) {
        cases.push_back(flight(random, pair, how));
    }
    std::size_t i = 0, hits = 0;
    for (auto _ : state) {
        const Flight& at = cases[i++ % caseCount];
        hits += timeOfImpact(pair.a, at.a, pair.b, at.b, gap).has_value() ? 1 : 0;
    }
    state.counters["hits"] = benchmark::Counter(static_cast<double>(hits), benchmark::Counter::kAvgIterations);
}

bool registerAll() {
    for (const Pair& pair : pairs()) {
        for (const char* where : {"touching", "near", "far"}) {
            benchmark::RegisterBenchmark(("collide/" + pair.name + "/" + where).c_str(),
                                         [=](benchmark::State& state) { collidePairs(state, pair, where); });
        }
    }
    for (const Pair& pair : pairs()) {
        for (const char* how : {"straight", "turning", "passing"}) {
            benchmark::RegisterBenchmark(("time-of-impact/" + pair.name + "/" + how).c_str(),
                                         [=](benchmark::State& state) { castPairs(state, pair, how); });
        }
    }
    return true;
}

const bool registered = registerAll();

} // namespace
