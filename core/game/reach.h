#pragma once
// Where the ship, and the payload on its rope, can be some seconds from now, whatever is steered; and where they will
// be when the keys stay as they are.
//
// The outlines hold for a ship that meets nothing and a rope that stays as it is, attached or not. They are never too
// small for the ship alone: at each moment the thrust is taken as pointing where it helps most among all angles that
// the ship can have turned to by then, so that for each direction the furthest point is a sum over the updates. The
// two on a rope are taken as one body at their centre of mass, about which the rope turns as fast as thrust can make
// it. Metres, seconds, world coordinates.

#include "core/game/session.h"

#include <stop_token>
#include <vector>

namespace spacetow {

/// Convex, anticlockwise; of the centres of mass.
struct ReachOutline {
    double seconds = 0;
    std::vector<Vec2> ship;
    std::vector<Vec2> payload; // empty unless it is on the rope
};

/// After the given seconds each, which are > 0 and ascending. Empty when there is no ship, or nobody steers it any
/// more.
std::vector<ReachOutline> reachOutlines(const Session& session, const std::vector<double>& seconds);

/// Centres of mass after each update, the first ones those of now.
struct HeldPath {
    std::vector<Vec2> ship;
    std::vector<Vec2> payload; // from where it is on the rope
    bool ends = false;         // because ship or payload is lost, or home, or bodies crowd (core/game/crowd.h)

    bool operator==(const HeldPath&) const = default;
};

/// By simulating a copy of the session.
HeldPath heldPath(const Session& session, const Controls& held, double seconds, const std::stop_token& stop = {});

} // namespace spacetow
