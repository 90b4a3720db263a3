#pragma once
// Sleep: islands of bodies that have come to rest cost nothing until something wakes them. An island is
// what touching solid pairs and connectors join (see core/physics/solver/contact_graph.h for the rule); static bodies,
// kinematic ones and wholly frozen ones join nothing. It falls asleep when all of its bodies have been slow for half a
// second, and wakes as a whole. See WorldData::sleep.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: what it shows may be changed unless it is const here.
struct SleepStage {
    Bodies& bodies;
    const Forces& forces;
    Contacts& contacts;
    Constraints& constraints;
    Sleep& sleep;
    Events& events;
    StepFlags& flags;
    SleepSearch& search;
    PairTable& newTable;   // of bodies that are awake
    SolverScratch& solver; // both cleared of bodies that no longer move
    ToiSearch& toi;

    SleepStage(WorldData& data)
        : bodies(data.bodies), forces(data.forces), contacts(data.contacts), constraints(data.constraints),
          sleep(data.sleep), events(data.events), flags(data.flags), search(data.scratch.sleep),
          newTable(data.scratch.changes.newTable), solver(data.scratch.solver), toi(data.scratch.toi) {}
};

/// The body, or something about it, is about to change: with the next wakeRequested() its island wakes, and, when it
/// cannot be moved, all that is near it; near its new place, too, when it is static. Costs nothing while nobody sleeps.
void requestWake(Bodies& bodies, Sleep& sleep, Slot slot);

/// `iteration` dates the events, here and below.
void wakeRequested(const SleepStage& stage, int iteration);

/// At the start of an update: wakes whom it was requested for, and everybody when sleep is no longer allowed or gravity
/// has changed.
void beginSleep(const SleepStage& stage, const Vec2& gravity);

/// Wakes the islands that contacts have just been found with. If there are any, velocities are those of the start of
/// the iteration once more, and it is to be begun anew with everybody who takes part.
bool wakeTouched(const SleepStage& stage, const IterationStep& step);

/// At the end of an update of so many seconds: islands that have been slow for long enough fall asleep.
void fallAsleep(const SleepStage& stage, double seconds, int iteration);

} // namespace spacetow
