#pragma once
// Ship, payload and finish as an attempt begins with them.

#include "core/level/level.h"
#include "core/physics/def/body.h"

#include <optional>

namespace spacetow {

struct StartBody {
    Key key = 0; // of its object
    BodyDef def;
};

/// None when the level has no such object; the first of several. Ship and payload are frozen.
std::optional<StartBody> startOfShip(const Level& level);
std::optional<StartBody> startOfPayload(const Level& level);
std::optional<StartBody> startOfFinish(const Level& level);

} // namespace spacetow
