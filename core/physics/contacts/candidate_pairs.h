#pragma once
// Selects the pairs that the narrow phase has to update.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Fills `candidates` with the indices of all pairs without a constraint whose parts may touch in this iteration: the
/// motion bounds of the two bodies have reached the separation bound of the pair. For a pair of two non-static bodies
/// without a contact, the bounding circles are tested too. If the circles stay apart, the pair gets a new separation
/// bound, no longer counts as touching, and is no candidate. Sensor pairs are not tested by circles and may be listed.
void listCandidates(const Bodies& bodies, Contacts& contacts, NarrowPhase& narrow);

} // namespace spacetow
