#pragma once
// "Why do these two not collide?"

#include "core/physics/world/world.h"

#include <vector>

namespace spacetow {

enum class WhyApart : std::uint8_t {
    Touch,      // they do
    SameBody,   // both are the same
    Inactive,   // `body` is switched off
    Unmovable,  // neither is dynamic
    Mask,       // `body` touches none of the tags of the other, which are in `missing`
    Connected,  // by `connectors`, which keep them from colliding
    Intangible, // `body` is, so that it is felt but stops nothing
    Walls,      // both are nothing but walls, which pass through each other
    Behind,     // where they overlap, one is behind one-way walls of `body`, of which one goes from `from` to `to`
    Distance,   // they are `distance` apart, from `from` to `to`
    NextUpdate, // they overlap, and will collide as soon as an update looks
};

/// The first reason that holds, in the order above, and what it is about.
struct CollisionAnswer {
    WhyApart why = WhyApart::Touch;
    BodyId body;            // see above
    TagMask missing;        // the tags of the other; none: it has no tags, and nothing touches it
    bool bothMasks = false; // with `Mask`: the other one does not touch `body` either
    bool felt = false;      // with `Intangible`: they overlap, and events tell
    std::vector<ConnectorId> connectors;
    Vec2 from{0, 0}, to{0, 0}; // world
    double distance = 0;       // m
};

/// As of the last update: `Touch` when the engine has them in contact, and only then. Linear in the pairs of their
/// parts that are near each other.
CollisionAnswer whyNotColliding(const World& world, BodyId a, BodyId b);

} // namespace spacetow
