// Pieces of whole worlds: the sub-steps of connectors, copies and hashes.

#include "tests/support/allocation_count.h"
#include "tests/support/bodies.h"
#include "tests/support/scenes.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

using namespace spacetow;
using test::add;
using test::ball;
using test::edgeBody;

namespace {

test::Scene twoBodies() {
    test::Scene scene{.name = "two bodies"};
    scene.parameters = {.gravity = {0, 0}, .iterations = 20, .substeps = 2};
    BodyDef ball;
    ball.shapes = {Circle{{0, 0}, 0.2}};
    scene.bodies = {ball, ball};
    scene.bodies[1].position = {1, 0};
    scene.bodies[1].velocity = {0, 1};
    scene.joints = {{0, 1, {.stiffness = 2000, .damping = 0}}};
    return scene;
}

/// Updates in which nothing touches anything: what is left is motion and connectors. The time added is that
/// of one connector in one sub-step.
void connectorSteps(benchmark::State& state, test::Scene scene) {
    for (BodyDef& body : scene.bodies) {
        body.filter.touches = {};
    }
    World world = worldOf(scene);
    for (auto _ : state) {
        world.update();
    }
    const auto each =
        static_cast<std::int64_t>(scene.joints.size()) * scene.parameters.iterations * scene.parameters.substeps;
    state.counters["connector_substep"] = benchmark::Counter(
        static_cast<double>(each), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// A world that has run for a while, so that it carries contacts along.
World usedWorld(const char* name, int n) {
    World world = worldOf(*test::makeScene(name, n));
    for (int i = 0; i < 20; ++i) {
        world.update();
    }
    return world;
}

void copies(benchmark::State& state, const char* name, int n) {
    const World world = usedWorld(name, n);
    const std::uint64_t before = test::allocatedBytes();
    for (auto _ : state) {
        const World copy = world;
        benchmark::DoNotOptimize(copy.bodyCount());
    }
    state.counters["bytes"] =
        benchmark::Counter(static_cast<double>(test::allocatedBytes() - before), benchmark::Counter::kAvgIterations);
}

/// Into a world that is there already, as a loop of trials does.
void assignments(benchmark::State& state, const char* name, int n) {
    const World world = usedWorld(name, n);
    World copy = world;
    for (auto _ : state) {
        copy = world;
        benchmark::DoNotOptimize(copy.bodyCount());
    }
}

void hashes(benchmark::State& state, const char* name, int n) {
    const World world = usedWorld(name, n);
    for (auto _ : state) {
        benchmark::DoNotOptimize(world.hash());
    }
}

/// One body an edge, `width` metres wide, and a ball that rolls about between hills.
struct Terrain {
    World world{UpdateParameters{.iterations = 20}};
    std::vector<BodyId> edges;

    Terrain(int count, double width, double depth) {
        for (int i = 0; i < count; ++i) {
            const auto at = [&](int k) {
                const double x = width * k;
                return Vec2(x, 3 * std::sin(0.7 * x) + 0.3 * std::sin(11 * x));
            };
            edges.push_back(add(world, edgeBody(at(i), at(i + 1), depth)));
        }
        add(world, ball({20, 5}, 0.2));
    }
};

/// What moves is the same however much stands still.
void oneBall(benchmark::State& state, double depth) {
    Terrain terrain(static_cast<int>(state.range(0)), 0.2, depth);
    for (int i = 0; i < 100; ++i) {
        terrain.world.update();
    }
    for (auto _ : state) {
        terrain.world.update();
    }
}

/// Of edges as many as there are in 2 km.
void firstUpdate(benchmark::State& state, double depth) {
    const auto count = static_cast<int>(state.range(0));
    const Terrain terrain(count, 2000.0 / count, depth);
    for (auto _ : state) {
        World world = terrain.world;
        world.update();
    }
}

void edit(benchmark::State& state) {
    Terrain terrain(static_cast<int>(state.range(0)), 0.2, noBack);
    terrain.world.update();
    double x = 0;
    for (auto _ : state) {
        x = x == 0 ? 0.1 : 0;
        terrain.world.setPose(terrain.edges[terrain.edges.size() / 2], {0, x}, 0);
        terrain.world.update();
    }
}

void registerLevels() {
    const auto each = [](const char* name, void (*function)(benchmark::State&, double)) {
        for (const double depth : {0.0, noBack}) {
            benchmark::RegisterBenchmark((std::string(name) + (depth == 0 ? "/thin" : "/no-back")).c_str(),
                                         [=](benchmark::State& state) { function(state, depth); })
                ->Arg(2000)
                ->Arg(50000)
                ->Arg(200000)
                ->Arg(400000)
                ->Unit(benchmark::kMicrosecond);
        }
    };
    each("one-ball-over-edges", oneBall);
    each("first-update-of-edges", firstUpdate);
    benchmark::RegisterBenchmark("edit-among-edges", edit)->Arg(2000)->Arg(100000)->Unit(benchmark::kMicrosecond);
}

bool registerAll() {
    registerLevels();
    struct Sized {
        const char* name;
        int n;
    };
    constexpr Sized scenes[] = {{"tow", 1}, {"mesh", 40}, {"balls", 2000}, {"balls", 20000}, {"cave", 100000}};
    benchmark::RegisterBenchmark("connectors/two-bodies",
                                 [](benchmark::State& state) { connectorSteps(state, twoBodies()); });
    benchmark::RegisterBenchmark("connectors/mesh/40", [](benchmark::State& state) {
        connectorSteps(state, *test::makeScene("mesh", 40));
    })->Unit(benchmark::kMicrosecond);
    struct Work {
        const char* name;
        void (*function)(benchmark::State&, const char*, int);
    };
    for (const Work& work : {Work{"copy", copies}, Work{"assign", assignments}, Work{"hash", hashes}}) {
        for (const Sized& scene : scenes) {
            benchmark::RegisterBenchmark(
                (std::string(work.name) + "/" + scene.name + "/" + std::to_string(scene.n)).c_str(),
                [=](benchmark::State& state) { work.function(state, scene.name, scene.n); })
                ->Unit(benchmark::kMicrosecond);
        }
    }
    return true;
}

const bool registered = registerAll();

} // namespace
