// Both quadtrees against the loop over everything, for boxes as dense as in a heap of balls. Before anything is timed
// the two have to find as many pairs. Each benchmark goes round several sets of boxes, so that no branch is learned by
// heart.

#include "core/base/random.h"
#include "core/geometry/moving_quadtree.h"
#include "core/geometry/static_quadtree.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

using namespace spacetow;

namespace {

constexpr double boxSize = 0.2;          // m
constexpr double spacing = 0.24;         // m: there is one box for each square of this side
constexpr std::size_t queryCount = 8192; // boxes asked about, in turn

double sideFor(std::int64_t count) {
    return spacing * std::sqrt(static_cast<double>(count));
}

std::vector<Aabb> randomBoxes(Random& random, std::int64_t count, double side) {
    std::vector<Aabb> boxes;
    for (std::int64_t i = 0; i < count; ++i) {
        const Vec2 corner{random.uniform(0, side), random.uniform(0, side)};
        boxes.push_back({corner, corner + Vec2(boxSize, boxSize)});
    }
    return boxes;
}

using Sets = std::vector<std::vector<Aabb>>;

Sets setsOf(std::int64_t count) {
    constexpr std::int64_t boxesInAll = 20000;
    Random random;
    Sets sets;
    do {
        sets.push_back(randomBoxes(random, count, sideFor(count)));
    } while (static_cast<std::int64_t>(sets.size()) * count < boxesInAll);
    return sets;
}

void pairsByLoop(const std::vector<Aabb>& boxes, std::vector<std::uint32_t>& found) {
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (boxes[k].overlaps(boxes[i])) {
                found.push_back(static_cast<std::uint32_t>(k));
            }
        }
    }
}

void pairsByTree(const std::vector<Aabb>& boxes, MovingQuadtree& tree, std::vector<std::uint32_t>& found) {
    tree.fill(boxes);
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        near.clear();
        tree.query(boxes[i], near);
        std::copy_if(near.begin(), near.end(), std::back_inserter(found), [i](std::uint32_t k) { return k < i; });
    }
}

void movingLoop(benchmark::State& state) {
    const Sets sets = setsOf(state.range(0));
    std::vector<std::uint32_t> found;
    std::size_t i = 0;
    for (auto _ : state) {
        found.clear();
        pairsByLoop(sets[i++ % sets.size()], found);
        benchmark::DoNotOptimize(found.data());
    }
}

/// Filled anew each time, as an update does.
void movingTree(benchmark::State& state) {
    const Sets sets = setsOf(state.range(0));
    MovingQuadtree tree;
    std::vector<std::uint32_t> found, expected;
    pairsByTree(sets[0], tree, found);
    pairsByLoop(sets[0], expected);
    if (found.size() != expected.size()) {
        state.SkipWithError("the tree and the loop disagree");
        return;
    }
    std::size_t i = 0;
    for (auto _ : state) {
        const std::vector<Aabb>& boxes = sets[i++ % sets.size()];
        found.clear();
        pairsByTree(boxes, tree, found);
        benchmark::DoNotOptimize(found.data());
    }
    state.counters["pairs"] = static_cast<double>(expected.size());
}

void queryByLoop(const std::vector<Aabb>& boxes, const Aabb& area, std::vector<std::uint32_t>& found) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        if (boxes[k].overlaps(area)) {
            found.push_back(static_cast<std::uint32_t>(k));
        }
    }
}

std::vector<Aabb> queriesFor(std::int64_t count) {
    Random random(2);
    return randomBoxes(random, queryCount, sideFor(count));
}

void staticLoop(benchmark::State& state) {
    const std::vector<Aabb> boxes = setsOf(state.range(0)).front();
    const std::vector<Aabb> queries = queriesFor(state.range(0));
    std::vector<std::uint32_t> found;
    std::size_t i = 0;
    for (auto _ : state) {
        found.clear();
        queryByLoop(boxes, queries[i++ % queryCount], found);
        benchmark::DoNotOptimize(found.data());
    }
}

void staticTree(benchmark::State& state) {
    const std::vector<Aabb> boxes = setsOf(state.range(0)).front();
    const std::vector<Aabb> queries = queriesFor(state.range(0));
    const StaticQuadtree tree(boxes);
    std::vector<std::uint32_t> found, expected;
    for (const Aabb& query : queries) {
        tree.query(query, found);
        queryByLoop(boxes, query, expected);
    }
    if (found.size() != expected.size()) {
        state.SkipWithError("the tree and the loop disagree");
        return;
    }
    std::size_t i = 0;
    for (auto _ : state) {
        found.clear();
        tree.query(queries[i++ % queryCount], found);
        benchmark::DoNotOptimize(found.data());
    }
}

void staticBuild(benchmark::State& state) {
    const Sets sets = setsOf(state.range(0));
    std::size_t i = 0;
    for (auto _ : state) {
        const StaticQuadtree tree(sets[i++ % sets.size()]);
        benchmark::DoNotOptimize(tree.depth());
    }
    state.counters["levels"] = StaticQuadtree(sets[0]).depth();
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    for (const int count : {10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 100000}) {
        benchmark->Arg(count);
    }
}

BENCHMARK(movingLoop)->Name("all-pairs/loop")->Apply(sizes)->Unit(benchmark::kMicrosecond);
BENCHMARK(movingTree)->Name("all-pairs/moving-quadtree")->Apply(sizes)->Unit(benchmark::kMicrosecond);
BENCHMARK(staticLoop)->Name("one-query/loop")->Apply(sizes);
BENCHMARK(staticTree)->Name("one-query/static-quadtree")->Apply(sizes);
BENCHMARK(staticBuild)->Name("build/static-quadtree")->Apply(sizes)->Unit(benchmark::kMicrosecond);

} // namespace
