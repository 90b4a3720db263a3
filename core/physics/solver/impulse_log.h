#pragma once
// Notes what contacts give, where that is wanted.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Forgets the update before. `seconds` are those of the new one.
void beginImpulseLog(ImpulseLog& impulses, double seconds);

/// The impulses of this iteration, when the solver is done with them and has taken none away yet. One pass over all
/// contacts.
void logImpulses(const Bodies& bodies, const Constraints& constraints, ImpulseLog& impulses);

} // namespace spacetow
