#pragma once
// A benchmark scene, told without any engine: what is in it, and how it is stepped. SI units, radians, y up.

#include "core/physics/body.h"
#include "core/physics/connector.h"
#include "core/physics/world.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spacetow::bench {

/// Two bodies of a scene, by their place in it, and what joins them.
struct Joint {
    std::size_t a, b;
    ConnectorDef connector; // its bodies are not set
};

struct Scene {
    std::string name;
    int n = 0;       // the size asked for; what it counts depends on the scene
    int updates = 0; // in a default run
    UpdateParameters parameters;
    int referenceSteps = 1; // in which other engines carry out one update, where springs are too stiff for a single one
    std::vector<BodyDef> bodies;
    std::vector<Joint> joints;
};

/// What one engine made of a scene.
struct Run {
    double buildMs = 0;
    std::vector<double> updateMs; // one an update
    double minY = 0, meanY = 0;   // m, of the origins of dynamic bodies after the last update
    double kinetic = 0;           // J, of dynamic bodies
    std::uint64_t hash = 0;       // of the final state, ours only
};

/// The names that makeScene() knows.
std::vector<std::string> sceneNames();
/// Nothing for an unknown name. Without `n`, the size of the default run.
std::optional<Scene> makeScene(std::string_view name, std::optional<int> n);

Run runSpacetow(const Scene& scene, int updates);
/// Each wants its library; the program says with which it was built.
Run runBox2d(const Scene& scene, int updates);
Run runChipmunk(const Scene& scene, int updates);

} // namespace spacetow::bench
