#pragma once
// What touches what in a game of SpaceTow, and what a touch means. Objects of the level keep the filter their author
// gave them: whatever carries the wall tag is fatal to ship and payload, intangible objects included.

#include "core/level/tag_table.h"
#include "core/physics/def/tags.h"

namespace spacetow::rules {

constexpr TagMask wall = TagMask::bit(wallTag);
constexpr TagMask ship = TagMask::bit(shipTag);
constexpr TagMask payload = TagMask::bit(payloadTag);
constexpr TagMask finish = TagMask::bit(finishTag);
constexpr TagMask debris = TagMask::bit(debrisTag);

constexpr Filter shipFilter{ship, wall | payload};
constexpr Filter payloadFilter{payload, wall | finish | ship};
constexpr Filter finishFilter{finish, payload | ship}; // the ship's own filter leaves the finish out
constexpr Filter debrisFilter{debris, wall | debris};

/// Physics knows that a roped payload does not touch its ship; any other touch ends the ship.
constexpr TagMask fatalToShip = wall | payload;
constexpr TagMask fatalToPayload = wall; // once it has been towed or dropped

} // namespace spacetow::rules
