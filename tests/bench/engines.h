#pragma once
// The engines that the benchmark runs its scenes on.

#include "tests/support/scenes.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace spacetow::bench {

using test::Joint;
using test::Scene;

/// What has become of a scene.
struct Outcome {
    double minY = 0, meanY = 0; // m, of the origins of dynamic bodies
    double kinetic = 0;         // J, of dynamic bodies
    std::uint64_t hash = 0;     // of the state, ours only
};

/// A scene built in one engine, which can then be carried on update by update, in turns with others.
struct Engine {
    std::string name; // as in "box2d"
    double buildMs = 0;
    std::function<void()> update;
    std::function<Outcome()> outcome;
};

Engine spacetowEngine(const Scene& scene);
/// Each wants its library; peers() knows with which the program was built.
Engine box2dEngine(const Scene& scene);
Engine chipmunkEngine(const Scene& scene);

/// The scene in one of the other engines, or nothing where it is not installed.
struct Peer {
    const char* name;
    std::optional<Engine> engine;
};
std::vector<Peer> peers(const Scene& scene);

} // namespace spacetow::bench
