#pragma once
// Which one-way walls are open for what comes from behind. A body passes as a whole, and through all that is joined.

#include "core/geometry/passage.h"
#include "core/physics/state/world_parts.h"

namespace spacetow {

/// Notes the passage of the pair, and whether the face of its wall is open: only its free ends count then.
bool isOpenFor(const Bodies& bodies, PairTable& table, std::uint32_t index);

/// The same for a circle, which stands about its centre of mass, and the free side of a static edge.
bool isOpenForCircle(const Bodies& bodies, PairTable& table, std::uint32_t index, const WallSide& side);

/// Asked where a contact comes up that was none before: whether the body is on its way through this very wall with
/// another part, or through one that is joined to it. Behind a hollow joint only when the contact is deep in the wall
/// or parting: what is stopped by the front of a wall is neither. Notes that the part is on its way, too.
bool opensAtContact(const Bodies& bodies, PairTable& table, std::uint32_t index, const Manifold& manifold);

/// Whether another part of the body is on its way through the wall of the pair.
bool isPassedByBody(const Bodies& bodies, const PairTable& table, std::uint32_t index);

} // namespace spacetow
