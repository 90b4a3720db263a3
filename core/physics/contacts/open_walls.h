#pragma once
// One-way walls that are open for a body on its way through from behind. A body passes as a whole, and a chain of
// joined walls is open as a whole.

#include "core/geometry/passage.h"
#include "core/physics/state/world_parts.h"

namespace spacetow {

/// Updates the passage of the pair. Returns whether the face of its wall is open for the body: then only the free ends
/// of the wall collide.
bool isOpenFor(const Bodies& bodies, PairTable& table, std::uint32_t index);

/// The same for a circle about the centre of mass and a static edge, of which `side` is the free side.
bool isOpenForCircle(const Bodies& bodies, PairTable& table, std::uint32_t index, const WallSide& side);

/// Call it for a pair with a new contact. Returns whether another part of the body is on its way through the same wall,
/// or the body through a joined wall; then the passage of the pair becomes `Passing`. Walls beyond a hollow joint count
/// only if the contact is deep in the wall or separates, as contacts with the front of a wall do neither.
bool opensAtContact(const Bodies& bodies, PairTable& table, std::uint32_t index, const Manifold& manifold);

/// Whether another part of the body is on its way through the wall of the pair.
bool isPassedByBody(const Bodies& bodies, const PairTable& table, std::uint32_t index);

} // namespace spacetow
