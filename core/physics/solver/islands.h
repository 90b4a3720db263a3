#pragma once
// Islands: bodies that may push each other, directly or through others.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Sets of slots as trees: each slot leads to another of its set, the lowest one to itself. Returns the latter.
Slot rootOf(std::vector<Slot>& parents, Slot slot);
void joinSets(std::vector<Slot>& parents, Slot a, Slot b);

/// Notes the inertia of every body, and which can be moved. They hold while pairs are not stale.
void measureInertias(WorldData& data);

/// By the pairs there are, when these have changed since the last time.
void findIslands(WorldData& data);

/// Marks the bodies of islands that a moving body pushes which nothing can stop.
void findDriven(WorldData& data);

/// The island of a contact's bodies.
template <class Batch>
Slot rootAt(const WorldData& data, const Batch& batch, std::uint32_t lane) {
    const bool yieldsA = batch.massA[lane] > 0 || batch.inertiaA[lane] > 0;
    return data.islands.roots[yieldsA ? batch.a[lane] : batch.b[lane]];
}

} // namespace spacetow
