#pragma once
// Continuous collision, so that no body tunnels. A body that moves further in an iteration than its speculative margin
// is swept, and stops at its first time of impact. The contact is solved in the next iteration. A kinematic body cannot
// be stopped: an iteration in which it would pass through something is split into parts.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: members that are not const may be changed through it.
struct ToiStage {
    Bodies& bodies;
    const BroadPhase& broadPhase;
    const Contacts& contacts;
    const StepFlags& flags;
    ToiSearch& toi;

    ToiStage(WorldData& data)
        : bodies(data.bodies), broadPhase(data.broadPhase), contacts(data.contacts), flags(data.flags),
          toi(data.scratch.toi) {}
};

/// How much of the planned motion, up to 1, may be made in one go: until what cannot be stopped has come up to what its
/// speed would take it past, and as long as the turns of bodies in contact, down to `least`, are covered.
double safeFraction(const Bodies& bodies, const Contacts& contacts, double least);

/// Shortens the motion (BodyStep::fraction) of swept bodies.
void stopAtImpacts(const ToiStage& stage);

} // namespace spacetow
