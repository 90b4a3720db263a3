#pragma once
// Answers "Why do these two bodies not collide?"

#include "core/physics/world/world.h"

#include <vector>

namespace spacetow {

enum class WhyApart : std::uint8_t {
    Touch,      // they touch
    SameBody,   // a and b are the same body
    Inactive,   // `body` is inactive
    Unmovable,  // neither is dynamic
    Mask,       // the mask of `body` has none of the other's tags, see `missing`
    Connected,  // `connectors` join them, with bodiesCollide off
    Intangible, // `body` is a sensor: it reports touches and stops nothing
    Walls,      // both have walls only, and walls do not collide with walls
    Passing,    // the other is on its way from behind through one-way walls of `body`; one of them is `from`–`to`
    Behind,     // the other is behind the one-way walls of `body`; one of them is `from`–`to`
    Distance,   // they are `distance` apart; the nearest points are `from` and `to`
    NextUpdate, // they overlap, and the next update will find the contact
};

/// The first reason that applies, in the order above, with its details.
struct CollisionAnswer {
    WhyApart why = WhyApart::Touch;
    BodyId body;            // the one that the reason is about
    TagMask missing;        // Mask: the tags of the other body; empty when it has none
    bool bothMasks = false; // Mask: the other's mask does not admit `body` either
    bool sensed = false;    // Intangible: they overlap, and events report it
    std::vector<ConnectorId> connectors;
    Vec2 from{0, 0}, to{0, 0}; // world
    double distance = 0;       // m
};

/// As of the last update: `Touch` exactly when the engine has the bodies in contact. Linear in the pairs of parts of
/// the two bodies that are near each other.
CollisionAnswer whyNotColliding(const World& world, BodyId a, BodyId b);

} // namespace spacetow
