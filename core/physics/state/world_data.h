#pragma once
// All that is behind a world, as the update sees it.

#include "core/physics/state/world_parts.h"

#include "core/physics/def/events.h"
#include "core/physics/def/parameters.h"
#include "core/physics/state/contact_graph.h"
#include "core/physics/state/impulse_log.h"
#include "core/physics/state/iteration_step.h"
#include "core/physics/state/scratch.h"
#include "core/physics/state/sleep_data.h"
#include "core/physics/state/step_flags.h"

namespace spacetow {

/// What a saved world is, and beside it what an update needs while it runs.
struct WorldData {
    UpdateParameters parameters;
    StepFlags flags;

    Bodies bodies;
    Forces forces;
    BroadPhase broadPhase;
    Contacts contacts;
    Constraints constraints;
    ContactGraph contactGraph;
    Sleep sleep;
    std::vector<BodyId> crushed; // and reported so
    Events events;
    ImpulseLog impulses;

    Scratch scratch;

    /// The static body is no longer what its geometry says.
    void noteStaticChange(Slot slot) {
        flags.staticsChanged = true;
        broadPhase.changedStatics.push_back(slot);
    }
};

} // namespace spacetow
