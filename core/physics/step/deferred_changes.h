#pragma once
// Deferred changes: removals and flags. They are applied between the stages of an update, in the order of the calls.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Applies the deferred changes. Returns whether there were any: the caller then rebuilds the lists of bodies. The
/// events get this `iteration`.
bool applyPending(WorldData& data, int iteration);

/// Sets the inverse mass and inertia of a body from its kind, mass and frozen flags.
void refreshInverseMass(Bodies& bodies, Slot slot);

/// Lists the bodies that connectors act on, which are integrated in sub-steps, and the pairs that do not collide
/// because a connector joins them.
void refreshConnections(Bodies& bodies, Forces& forces, StepFlags& flags);

} // namespace spacetow
