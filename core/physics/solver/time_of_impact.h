#pragma once
// Continuous collision, so that no body tunnels. A body that moves further in an iteration than its speculative margin
// is swept, and stops at its first time of impact. The contact is solved in the next iteration. A kinematic body cannot
// be stopped: an iteration in which it would pass through something is split into parts.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view that owns nothing, like a span. The time of impact changes the members that are not const.
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

/// The fraction of the planned motion, up to 1, that the next part of the iteration may make. It ends where an
/// immovable body meets one that it would pass through, and before bodies in contact turn further than their
/// speculative margins; these turns alone lower it to no less than `least`, 0 … 1.
double safeFraction(const Bodies& bodies, const Contacts& contacts, double least);

/// Shortens the motion (BodyStep::fraction) of swept bodies.
void stopAtImpacts(const ToiStage& stage);

} // namespace spacetow
