#pragma once
// Touch events: which touches began and ended, and which tags each body touched.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: members that are not const may be changed through it.
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

/// Joins the tag events from index `first` on, all of one iteration, to one event a body.
void joinTagReports(Events& events, std::size_t first);

/// Collects the tags that each body touched in the last iteration.
void collectTouchedTags(Bodies& bodies, const Contacts& contacts, const Sleep& sleep);

/// Collects the tags that sleeping bodies touch. Call it when the pairs of sleepers have changed.
void relistTouchedTags(Bodies& bodies, Sleep& sleep);

/// Ends all touches of a body that is about to be removed or deactivated. Call it while no contact has a lane.
void endTouches(const TouchStage& stage, NarrowPhase& narrow, Slot slot, int iteration);

} // namespace spacetow
