#pragma once
// Islands: bodies that may push each other, directly or through others.

#include "core/physics/solver/solver_stage.h"

#include <span>

namespace spacetow {

/// Sets of slots as trees: each slot leads to another of its set, the lowest one to itself. Returns the latter.
Slot rootOf(std::vector<Slot>& parents, Slot slot);
void joinSets(std::vector<Slot>& parents, Slot a, Slot b);

/// Begins what is kept of bodies by slot anew for those that are new or have changed: their inertia, whether they can
/// be moved, and what iterations write.
void renewSlots(const SolverStage& stage, std::span<const Slot> slots);

/// What an iteration keeps by slot, before it begins with the bodies that move: new ones get the initial value. Those
/// that no longer move have got it when the list of those that do was made.
template <class T>
void beginBySlot(std::vector<T>& list, std::size_t size, const T& initial) {
    if (list.size() != size) {
        list.resize(size, initial);
    }
}

/// By the pairs there are, when these have changed since the last time.
void findIslands(const SolverStage& stage);

/// Marks the bodies of islands that a moving body pushes which nothing can stop.
void findDriven(const Bodies& bodies, Islands& islands, SolverScratch& solver);

/// The island of a contact's bodies.
template <class Batch>
Slot rootAt(const Islands& islands, const Batch& batch, std::uint32_t lane) {
    const bool yieldsA = batch.massA[lane] > 0 || batch.inertiaA[lane] > 0;
    return islands.roots[yieldsA ? batch.a[lane] : batch.b[lane]];
}

} // namespace spacetow
