#pragma once
// Touch events: which touches began and ended, and which tags each body touched.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view that owns nothing, like a span. The reports change the members that are not const.
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

/// Adds the events of all pairs of bodies that have begun or ended to touch since the last report, in the order of the
/// pair table, and those of touched tags for the bodies that report them.
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
