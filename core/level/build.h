#pragma once
// From the document to the running world.

#include "core/level/problem.h"
#include "core/physics/world/world.h"

#include <utility>
#include <vector>

namespace spacetow {

/// What a level became. Bodies carry their object's key in `user`. Ship, payload and finish are left to the game.
struct BuiltWorld {
    World world;
    std::vector<std::pair<Key, BodyId>> bodies;          // sorted by key
    std::vector<std::pair<Key, ConnectorId>> connectors; // likewise
};

/// Objects that lint reports as errors (a polygon that crosses itself, say) are left out.
BuiltWorld builtWorld(const Level& level);
/// About how much there is to build: corners and circles of bodies, counted until they are more than `most`.
std::size_t partsToBuild(const Level& level, std::size_t most);
/// The first error of each object that is left out.
std::vector<Problem> problemsLeftOut(const Level& level);

/// The shapes of one body object as the physics takes them: chains become edges and lines.
std::vector<Shape> physicsShapes(const BodyObject& body);

/// What the physics makes each from; `user` is the key.
BodyDef bodyDef(const BodyObject& body, Key key);
ConnectorDef connectorDef(const ConnectorObject& connector, BodyId a, BodyId b);

UpdateParameters updateParameters(const Level& level);

} // namespace spacetow
