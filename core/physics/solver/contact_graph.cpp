#include "core/physics/solver/contact_graph.h"

#include "core/base/sort_unique.h"

#include <algorithm>

namespace spacetow {

namespace {

void noteKinematicEdge(ContactGraph& graph, Slot body, Slot pushed) {
    const ContactGraph::KinematicEdge found{body, pushed};
    if (graph.kinematicEdges.empty() || graph.kinematicEdges.back() != found) {
        graph.kinematicEdges.push_back(found);
    }
}

/// Resets the roots of all bodies that may be united. Every other body has been its own root since resetSlots().
void beginRoots(const Bodies& bodies, const Contacts& contacts, ContactGraph& graph, const Sleep& sleep) {
    std::vector<Slot>& roots = graph.roots;
    for (const Slot slot : bodies.moving) {
        roots[slot] = slot;
    }
    if (sleep.sleepers.empty()) {
        return;
    }
    for (const PairBound& bound : contacts.table.bounds) {
        roots[slotOf(bound.moverA)] = slotOf(bound.moverA);
        if (bound.moverB != Mover::Static) {
            roots[slotOf(bound.moverB)] = slotOf(bound.moverB);
        }
    }
}

/// Adds the edges. Reads bounds and movability only: these take fewer bytes than pairs and bodies.
void addPairs(const Bodies& bodies, const Contacts& contacts, ContactGraph& graph) {
    auto sensors = contacts.sensors.begin();
    for (std::uint32_t i = 0; i < contacts.table.size(); ++i) {
        const PairBound& bound = contacts.table.bounds[i];
        if (sensors != contacts.sensors.end() && *sensors == i) {
            ++sensors;
            continue;
        }
        if (bound.moverB != Mover::Static) {
            addEdge(graph.roots, {slotOf(bound.moverA), bodies.movable[bound.moverA] != 0},
                    {slotOf(bound.moverB), bodies.movable[bound.moverB] != 0},
                    [&](Slot body, Slot pushed) { noteKinematicEdge(graph, body, pushed); });
        }
    }
}

/// Adds the roots that are asleep: a sleeping body near moving ones may be the root of their component.
void listSleepingRoots(const Bodies& bodies, ContactGraph& graph) {
    const std::size_t awake = graph.componentRoots.size();
    for (const Slot slot : bodies.moving) {
        if (bodies.records[graph.roots[slot]].asleep) {
            graph.componentRoots.push_back(graph.roots[slot]);
        }
    }
    sortUnique(graph.componentRoots, awake);
}

/// Clears the marks of the components that immovable bodies bounded.
void forgetKinematicEdges(const ContactGraph& graph, SolverScratch& solver) {
    std::vector<std::uint8_t>& pushedByKinematic = solver.pushedByKinematic;
    for (const ContactGraph::KinematicEdge& edge : graph.kinematicEdges) {
        if (edge.component < pushedByKinematic.size()) {
            pushedByKinematic[edge.component] = 0;
        }
    }
}

/// Resets the data of a slot: inertia, movability, root and merge count.
void resetSlot(Bodies& bodies, Constraints& constraints, ContactGraph& graph, Slot slot) {
    const BodyMotion& m = bodies.motions[slot];
    refreshInertia(m, graph, slot);
    bodies.movable[slot] = m.isMovable() ? 1 : 0;
    graph.roots[slot] = slot;
    constraints.mergeableContacts[slot] = 0;
}

} // namespace

void refreshInertia(const BodyMotion& m, ContactGraph& graph, Slot slot) {
    const double mass = m.inverseMass > 0 ? 1 / m.inverseMass : 0;
    graph.inertias[slot] = {mass, mass, m.inverseInertia > 0 ? 1 / m.inverseInertia : 0, 0};
}

void findComponents(const SolverStage& stage) {
    if (!stage.flags.contactGraphStale) {
        return;
    }
    stage.flags.contactGraphStale = false;
    beginRoots(stage.bodies, stage.contacts, stage.graph, stage.sleep);
    std::vector<Slot>& roots = stage.graph.roots;
    std::vector<ContactGraph::KinematicEdge>& edges = stage.graph.kinematicEdges;
    forgetKinematicEdges(stage.graph, stage.solver);
    stage.graph.pushedByKinematicStale = true;
    edges.clear();
    addPairs(stage.bodies, stage.contacts, stage.graph);
    stage.graph.componentRoots.clear();
    for (const Slot slot : stage.bodies.moving) {
        roots[slot] = rootOf(roots, slot);
        if (roots[slot] == slot) {
            stage.graph.componentRoots.push_back(slot);
        }
    }
    listSleepingRoots(stage.bodies, stage.graph);
    for (ContactGraph::KinematicEdge& edge : edges) {
        edge.component = roots[edge.component];
    }
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end()); // pairs come sorted: this leaves few to sort
    sortUnique(edges);
}

void markPushedByKinematic(const Bodies& bodies, ContactGraph& graph, SolverScratch& solver) {
    std::vector<std::uint8_t>& pushedByKinematic = solver.pushedByKinematic;
    beginBySlot(pushedByKinematic, bodies.motions.size() + 1, std::uint8_t{0});
    for (const Slot root : graph.componentRoots) {
        pushedByKinematic[root] = 0;
    }
    forgetKinematicEdges(graph, solver);
    bool any = false;
    for (const ContactGraph::KinematicEdge& edge : graph.kinematicEdges) {
        if (bodies.motions[edge.body].isMoving()) {
            pushedByKinematic[edge.component] = 1;
            any = true;
        }
    }
    if (any || graph.pushedByKinematicStale) {
        for (const Slot slot : bodies.moving) {
            pushedByKinematic[slot] = pushedByKinematic[graph.roots[slot]];
        }
    }
    graph.pushedByKinematicStale = any;
}

void resetSlots(const SolverStage& stage, std::span<const Slot> slots) {
    const std::size_t count = stage.bodies.motions.size();
    stage.graph.roots.resize(count);
    stage.graph.inertias.resize(count);
    stage.bodies.movable.resize(count);
    stage.constraints.mergeableContacts.resize(count);
    for (const Slot slot : slots) {
        resetSlot(stage.bodies, stage.constraints, stage.graph, slot);
    }
    stage.flags.contactGraphStale = true;
}

} // namespace spacetow
