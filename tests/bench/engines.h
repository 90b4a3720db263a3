#pragma once
// The engines that the benchmark runs its scenes on.

#include "tests/support/scenes.h"

#include <cstdint>
#include <vector>

namespace spacetow::bench {

using test::Joint;
using test::Scene;

/// What one engine made of a scene.
struct Run {
    double buildMs = 0;
    std::vector<double> updateMs; // one an update
    double minY = 0, meanY = 0;   // m, of the origins of dynamic bodies after the last update
    double kinetic = 0;           // J, of dynamic bodies
    std::uint64_t hash = 0;       // of the final state, ours only
};

Run runSpacetow(const Scene& scene, int updates);
/// Each wants its library; the program says with which it was built.
Run runBox2d(const Scene& scene, int updates);
Run runChipmunk(const Scene& scene, int updates);

} // namespace spacetow::bench
