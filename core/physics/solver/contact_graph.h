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

/// Unites the components of two movable bodies. An immovable body is in no component: it bounds the component of the
/// other one, which `bound(immovable, movable)` reports.
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

/// Resets the per-slot data of bodies that are new or have changed: inertia, movability, root and merge count.
void resetSlots(const SolverStage& stage, std::span<const Slot> slots);

/// Updates the inertia of a body in the graph after its mass has changed. Needs resetSlots() for a new slot before.
void refreshInertia(const BodyMotion& m, ContactGraph& graph, Slot slot);

/// Resizes per-slot data to `size` slots; new slots get the initial value. Slots of bodies that no longer move were
/// reset when the moving bodies were listed.
template <class T>
void beginBySlot(std::vector<T>& list, std::size_t size, const T& initial) {
    if (list.size() != size) {
        list.resize(size, initial);
    }
}

/// Finds the components of the contact graph, if the pair table has changed since the last call.
void findComponents(const SolverStage& stage);

/// Flags the bodies of components that a moving kinematic body may push: their energy is not limited.
void markPushedByKinematic(const Bodies& bodies, ContactGraph& graph, SolverScratch& solver);

/// The root of the component of a contact.
template <class Batch>
Slot rootAt(const ContactGraph& graph, const Batch& batch, std::uint32_t lane) {
    const bool yieldsA = batch.massA[lane] > 0 || batch.inertiaA[lane] > 0;
    return graph.roots[yieldsA ? batch.a[lane] : batch.b[lane]];
}

} // namespace spacetow
