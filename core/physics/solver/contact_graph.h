#pragma once
// Which bodies belong together. Two graphs have bodies for vertices, and one rule, addEdge(), for their edges:
// - the contact graph, of the solver, has the solid pairs for edges, whether they touch or not. Bodies of one component
//   may push each other in this iteration. Connectors are no edges, as they act as forces before contacts are solved.
// - the graph of islands, of sleep.h, has the solid pairs that touch and the connectors. Bodies of one island rest
//   on or hang from each other.

#include "core/base/disjoint_sets.h"
#include "core/physics/solver/solver_stage.h"

#include <span>

namespace spacetow {

struct EdgeEnd {
    Slot slot;
    bool movable;
};

/// Unites two bodies that can be moved. One that cannot is in no component: it bounds that of the other, for which
/// `bound(immovable, movable)` is called.
template <class Bound>
void addEdge(std::vector<Slot>& parents, const EdgeEnd& a, const EdgeEnd& b, const Bound& bound) {
    if (a.movable && b.movable) {
        uniteSets(parents, a.slot, b.slot);
    } else if (a.movable) {
        bound(b.slot, a.slot);
    } else if (b.movable) {
        bound(a.slot, b.slot);
    }
}

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

/// Of the contact graph, by the pairs there are, when these have changed since the last time.
void findComponents(const SolverStage& stage);

/// Marks the bodies of components that a moving kinematic body may push: it can do any work.
void markPushedByKinematic(const Bodies& bodies, ContactGraph& graph, SolverScratch& solver);

/// The component of a contact's bodies.
template <class Batch>
Slot rootAt(const ContactGraph& graph, const Batch& batch, std::uint32_t lane) {
    const bool yieldsA = batch.massA[lane] > 0 || batch.inertiaA[lane] > 0;
    return graph.roots[yieldsA ? batch.a[lane] : batch.b[lane]];
}

} // namespace spacetow
