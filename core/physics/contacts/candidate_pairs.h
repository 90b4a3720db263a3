#pragma once
// Which pairs the narrow phase has to update.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Fills `candidates` with the pairs that have no constraint and may come into contact in this iteration. A pair
/// without a contact, the discs around whose bodies do not meet, gets a new separation bound instead.
void listCandidates(const Bodies& bodies, Contacts& contacts, NarrowPhase& narrow);

} // namespace spacetow
