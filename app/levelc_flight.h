#pragma once
// The picture of a recorded flight: the ways of ship and payload, and how things stood at the end.

#include "core/game/replay.h"
#include "core/game/session.h"
#include "core/game/snapshot.h"
#include "core/physics/query/overlay_flags.h"
#include "editor/canvas/stage.h"

#include <memory>
#include <vector>

namespace spacetow {

struct Flight {
    /// Each without a jump: a new attempt begins a new one. World, m.
    std::vector<std::vector<Vec2>> shipWays, payloadWays;
    std::shared_ptr<const Snapshot> end;
    std::shared_ptr<const Session> session; // at the end
};

/// Plays the whole replay.
Flight flown(const Level& level, const Replay& replay);
void paintFlight(const Stage& stage, const Flight& flight, const OverlayFlags& overlays);

} // namespace spacetow
