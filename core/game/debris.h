#pragma once
// What is left of a ship or payload: a few small polygons that fly apart and fade after some seconds. They meet walls
// and each other, never ship or payload.

#include "core/base/random.h"
#include "core/physics/def/body.h"

#include <vector>

namespace spacetow {

namespace debris {
constexpr double minRadius = 0.05, maxRadius = 0.15; // m
constexpr double minMass = 0.15, maxMass = 0.65;     // kg
constexpr double maxOffset = 0.1;                    // m, from the source
constexpr double minSpeed = 0.2, maxSpeed = 0.5;     // m/s, relative to the source
constexpr double minLife = 2, maxLife = 5;           // s
constexpr double restitution = 0.95;
constexpr double linearDamping = 0.5;        // 1/s
constexpr double angularDamping = 5;         // 1/s
constexpr int fromShip = 2, fromPayload = 3; // pieces at least; up to four more
} // namespace debris

struct DebrisPiece {
    BodyDef def;
    double life; // s, still to go
};

/// `least` … `least + 4` pieces of a body that was destroyed in this state.
std::vector<DebrisPiece> debrisOf(const BodyState& source, int least, Random& random);

} // namespace spacetow
