#pragma once
// The manifold of a pair at the present poses of its bodies.

#include "core/geometry/collide.h"
#include "core/physics/state/world_parts.h"

namespace spacetow {

/// Computes the manifold with this margin, m. If the one-way wall of the pair is open for the other body, only the free
/// ends of the wall collide.
Manifold presentManifold(const Bodies& bodies, const PairTable& table, std::size_t index, double margin);

} // namespace spacetow
