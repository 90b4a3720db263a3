#pragma once
// Nothing is passed through: bodies that would move further in an iteration than the speculative margin covers are
// swept along their way and stop at the first thing they would hit. The contact itself is solved in the next iteration.
// Kinematic bodies cannot be stopped: iterations in which they would pass something are made in parts.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: what it shows may be changed unless it is const here.
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
