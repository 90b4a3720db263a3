#pragma once
// What may keep the ship in: the walls of a level as segments. World coordinates, metres.

#include "core/level/level.h"

#include <functional>
#include <vector>

namespace spacetow {

/// A segment that the ship cannot cross, or only from its right to its left when it is one-way.
struct LeakWall {
    Vec2 a{0, 0};
    Vec2 b{0, 0};
    bool oneWay = false;
    int object = 0;  // place in the level
    int shape = 0;   // place in the body
    int segment = 0; // of a chain or polygon: the place of the vertex at which it begins; 0 for circles
};

/// Of all bodies that the ship can touch and that stay where they are: static ones, and kinematic ones, which go their
/// way by themselves and are taken where they start. Whether they are tangible does not matter, they end the ship.
/// Those are left out for which `isBad`. Circles become polygons that deviate by a few millimetres at most.
std::vector<LeakWall> leakWalls(const Level& level, const std::function<bool(int object)>& isBad);

} // namespace spacetow
