#pragma once
// How a view follows a ship: it stays where the player has put it while the ship is well inside, glides after it beyond
// that, and never lets it come near the edge. World metres.

#include "core/game/snapshot.h"
#include "editor/editing/viewport.h"

#include <optional>

namespace spacetow {

/// The view that follows `ship` for so many seconds.
Viewport chased(const Viewport& view, const Vec2& ship, double seconds);

/// As a game begins for who has seen nothing of the level yet: 13.33 × 10 m about the ship, and as little as possible
/// of what lies beyond `bounds`; without a ship all of the bounds, which may be empty. `size` in pixels.
Viewport classicView(const Snapshot& snapshot, const Aabb& bounds, const Vec2& size);

/// Whether a ship there can be flown by this view: it is in sight, and more than a dot.
bool canFlyBy(const Viewport& view, const Vec2& ship);

/// Where the ship is, if there is one.
std::optional<Vec2> shipIn(const Snapshot& snapshot);

} // namespace spacetow
