#pragma once
// Deferred changes wait until no stage of the update is at work: removals and flags, carried out in the order in which
// they were asked for.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// True when something was changed, so that lists of bodies must be made anew. `iteration` dates the events.
bool applyPending(WorldData& data, int iteration);

/// Masses as contacts feel them, from kind, mass and frozen flags.
void refreshInverseMass(Bodies& bodies, Slot slot);

/// Which bodies are connected, and which of them do not collide with each other.
void refreshConnections(Bodies& bodies, Forces& forces, StepFlags& flags);

/// Which bodies move in sub-steps: the part of refreshConnections that does not concern collisions.
void refreshSubsteps(Bodies& bodies, Forces& forces);

} // namespace spacetow
