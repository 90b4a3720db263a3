#pragma once
// How a view follows a ship: it stays where the player has put it while the ship is well inside, glides after it beyond
// that, and never lets it come near the edge. A level that is in sight as a whole stays as it is. World metres.

#include "core/game/snapshot.h"
#include "editor/editing/viewport.h"

#include <optional>

namespace spacetow {

/// What a view follows, and the level around it, whose bounds may be empty.
struct Chase {
    Vec2 ship{0, 0};
    Aabb level;
};

/// The view that follows the ship for so many seconds. Along an axis in which all of the level is in sight it stays,
/// as long as the ship is in the level.
Viewport chased(const Viewport& view, const Chase& chase, double seconds);

/// As a game begins for who has seen nothing of the level yet: 13.33 × 10 m about the ship, and as little as possible
/// of what lies beyond `bounds`; without a ship all of the bounds, which may be empty. `size` in pixels.
Viewport classicView(const Snapshot& snapshot, const Aabb& bounds, const Vec2& size);

/// Whether a ship there can be flown by this view: it is in sight, and more than a dot.
bool canFlyBy(const Viewport& view, const Vec2& ship);

/// Where the ship is, if there is one.
std::optional<Vec2> shipIn(const Snapshot& snapshot);

} // namespace spacetow
