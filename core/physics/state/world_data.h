#pragma once
// All data of a world.

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

/// The state that a copy of the world saves, and the scratch data of an update.
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
    std::vector<BodyId> crushed; // in the last iteration, see CrushedEvent
    Events events;
    ImpulseLog impulses;

    Scratch scratch;

    /// To be called when a static body has been added, removed, moved, activated or deactivated.
    void noteStaticChange(Slot slot) {
        flags.staticsChanged = true;
        broadPhase.changedStatics.push_back(slot);
    }
};

} // namespace spacetow
