#pragma once
// Sleep: islands of bodies at rest cost nothing until something wakes them. An island is a set of movable bodies that
// touching solid pairs and connectors join, by the rule of core/physics/solver/contact_graph.h. Static, kinematic and
// wholly frozen bodies join nothing. An island falls asleep when all of its bodies have been slow for half a second,
// and wakes as a whole.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view that owns nothing, like a span. Falling asleep and waking change the members that are not const.
struct SleepStage {
    Bodies& bodies;
    const Forces& forces;
    Contacts& contacts;
    Constraints& constraints;
    Sleep& sleep;
    Events& events;
    StepFlags& flags;
    SleepSearch& search;
    PairTable& newTable;   // the next table of awake pairs
    SolverScratch& solver; // cleared for bodies that no longer move
    ToiSearch& toi;        // likewise

    SleepStage(WorldData& data)
        : bodies(data.bodies), forces(data.forces), contacts(data.contacts), constraints(data.constraints),
          sleep(data.sleep), events(data.events), flags(data.flags), search(data.scratch.sleep),
          newTable(data.scratch.changes.newTable), solver(data.scratch.solver), toi(data.scratch.toi) {}
};

/// Call it before the body changes: the next wakeRequested() wakes its island. If the body is immovable, it wakes all
/// bodies near it; if it is static, also those near its new place. Costs nothing while no body sleeps.
void requestWake(Bodies& bodies, Sleep& sleep, Slot slot);

/// Wakes the islands that requestWake() has named. The events get this `iteration`, here and below.
void wakeRequested(const SleepStage& stage, int iteration);

/// Call it at the start of an update: it wakes the requested islands, or all of them if sleep is no longer allowed or
/// gravity has changed.
void beginSleep(const SleepStage& stage, const Vec2& gravity);

/// Wakes the sleeping islands that have a new contact. Returns whether there are any: velocities are then restored to
/// those of the start of the iteration, and the caller begins the iteration anew with all awake bodies.
bool wakeTouched(const SleepStage& stage, const IterationStep& step);

/// Call it at the end of an update of `seconds`: islands that have been slow for half a second fall asleep.
void fallAsleep(const SleepStage& stage, double seconds, int iteration);

} // namespace spacetow
