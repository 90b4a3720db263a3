#pragma once
// From touching pairs to events: what began, what ended, and the tags each body touched.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: what it shows may be changed unless it is const here.
struct TouchStage {
    Bodies& bodies;
    Contacts& contacts;
    const Sleep& sleep;
    Events& events;
    PairChanges& changes;

    TouchStage(WorldData& data)
        : bodies(data.bodies), contacts(data.contacts), sleep(data.sleep), events(data.events),
          changes(data.scratch.changes) {}
};

/// Events of the pairs whose marks have changed since they were last reported, in the order of the table, and the tags
/// that the bodies which ask for them touched in this iteration.
void reportTouches(const TouchStage& stage, int iteration);

/// Makes the tag reports from this index on, all of one iteration, one report of each body.
void joinTagReports(Events& events, std::size_t first);

/// The tags that every body touched in the last iteration.
void collectTouchedTags(Bodies& bodies, const Contacts& contacts, const Sleep& sleep);

/// Those of the pairs of sleepers, when these or who sleeps have changed.
void relistTouchedTags(Bodies& bodies, Sleep& sleep);

/// Ends all touches of a body that is about to leave or to be switched off. To be called while no
/// contact has a lane.
void endTouches(const TouchStage& stage, NarrowPhase& narrow, Slot slot, int iteration);

} // namespace spacetow
