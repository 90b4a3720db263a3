#pragma once
// Records the impulses of contacts, while the log is on.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Clears the log at the start of an update. `seconds` is the duration of the update.
void beginImpulseLog(ImpulseLog& impulses, double seconds);

/// Adds the contact impulses of this iteration to the log. To be called after the last pass of the velocity solver and
/// before the solver changes the impulses of contacts that bounce. Costs one pass over all contacts.
void logImpulses(const Bodies& bodies, const Constraints& constraints, ImpulseLog& impulses);

} // namespace spacetow
