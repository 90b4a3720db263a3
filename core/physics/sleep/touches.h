#pragma once
// From touching pairs to events: what began, what ended, and the tags each body touched.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Events of the pairs whose marks have changed since they were last reported, in the order of the table, and the tags
/// that the bodies which ask for them touched in this iteration.
void reportTouches(WorldData& data, int iteration);

/// Makes the tag reports from this index on, all of one iteration, one report of each body.
void joinTagReports(Events& events, std::size_t first);

/// The tags that every body touched in the last iteration.
void collectTouchedTags(Bodies& bodies, const Contacts& contacts, const Sleep& sleep);

/// Those of the pairs of sleepers, when these or who sleeps have changed.
void relistTouchedTags(Bodies& bodies, Sleep& sleep);

/// Ends all touches of a body that is about to leave or to be switched off.
void endTouches(WorldData& data, Slot slot, int iteration);

} // namespace spacetow
