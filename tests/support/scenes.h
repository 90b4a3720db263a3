#pragma once
// The scenes of tests and benchmarks, told without any engine: what is in them, and how they are stepped. SI units,
// radians, y up.

#include "core/physics/def/body.h"
#include "core/physics/def/connector.h"
#include "core/physics/world/world.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spacetow::test {

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

/// The names that makeScene() knows.
std::vector<std::string> sceneNames();
/// Nothing for an unknown name. Without `n`, the size of the default run.
std::optional<Scene> makeScene(std::string_view name, std::optional<int> n);
/// The scene in our own engine.
World worldOf(const Scene& scene);

} // namespace spacetow::test
