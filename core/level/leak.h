#pragma once
// Where the ship can get out of its cave, and which wall is to blame.
//
// A leak is reported where the walls around the ship would enclose it but for walls that are solid on the wrong side,
// or openings that are small against what surrounds it: at most a third of the way round. A level without a cave has
// none, nor has one whose payload or finish is beyond the openings: these are the way then. What is narrower than the
// ship is no opening. The outside is what goes on for ever: a room with a door within a closed cave is no leak, however
// its walls face, for a hangar looks like that; a shaft that is open at the top is one, for nobody can tell it from a
// cave whose roof is missing, and there is no coming back. Where it is meant, the problem can be hidden.

#include "core/level/level.h"

#include <functional>
#include <stop_token>
#include <vector>

namespace spacetow {

/// A place at a wall. For circles and the inside of walls `isEnd` is false.
struct LeakPlace {
    int object = -1;    // place in the level
    int shape = 0;      // place in the body
    int segment = 0;    // place of the vertex at which the wall begins
    bool isEnd = false; // of an open chain
    Vec2 at{0, 0};      // world, m

    bool operator==(const LeakPlace&) const = default;
};

struct Leak {
    enum class Kind {
        Reversed, // walls that let the ship out from behind
        Opening   // nothing is there
    };
    Kind kind = Kind::Opening;
    LeakPlace from, to;     // the first wall from end to end, or the two sides of the opening
    int walls = 0;          // how many are reversed
    bool isWhole = false;   // and they are all that their shape has, but for what is behind others
    double width = 0;       // m, of the opening or the walls
    std::vector<Vec2> path; // world, m: the short way from the ship to the outside

    bool operator==(const Leak&) const = default;
};

/// The least width of the ship's hull: through less it does not fit, however it turns. m
double leastShipWidth();

/// In the order in which they were found, which is the same for equal levels. Objects for which `isBad` are left out.
/// Nothing without a ship, or when a stop is requested.
std::vector<Leak> leaksOf(const Level& level, const std::function<bool(int object)>& isBad,
                          const std::stop_token& stop = {});

} // namespace spacetow
