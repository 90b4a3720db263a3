#pragma once
// The level as it stands in a run: its objects where their bodies are now. For picking, and for marks on what moves.

#include "core/game/snapshot.h"
#include "core/math/aabb.h"

#include <span>

namespace spacetow {

/// The level that is shown, and as it is without what is being dragged.
struct ShownLevel {
    const Level& shown;
    const Level& current;
};

/// All of the level; what has gone in the run is left out. Linear in the number of bodies.
Level posed(const Level& level, const Snapshot& snapshot);
/// Only these objects, with their members, and the bodies that connectors among them need; their order is kept. What is
/// being dragged is as far from where its body is as it has been dragged.
Level posed(const ShownLevel& level, const Snapshot& snapshot, std::span<const Key> keys);

/// What stands still whatever happens: the level without bodies that move, and without connectors.
Level standing(const Level& level);
/// That, and above it what moves and may be within the box, and all connectors with their ends. What is elsewhere is
/// left out: a level of thousands of bodies would take longer than a frame to make.
Level posedNear(const Level& level, const Level& standing, const Snapshot& snapshot, const Aabb& box);

} // namespace spacetow
