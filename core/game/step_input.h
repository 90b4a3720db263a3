#pragma once
// All that comes from outside in one update of a session. A run is a function of level, seed and these: what a user
// does to a running level is one of them, so that it can be rewound, recorded and played again.

#include "core/game/controls.h"
#include "core/game/grab.h"
#include "core/level/level.h"

#include <memory>
#include <optional>

namespace spacetow {

struct StepInput {
    Controls controls;
    std::optional<Grab> grab;
    std::shared_ptr<const Level> level; // as it has been edited, from this update on; null: as before

    /// Of levels: the very same one.
    bool operator==(const StepInput&) const = default;
};

} // namespace spacetow
