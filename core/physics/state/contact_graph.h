#pragma once
// The contact graph: its vertices are bodies, its edges the solid pairs, whether they touch or not. See
// core/physics/solver/contact_graph.h.

#include "core/physics/lanes/wide.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace spacetow {

/// Valid until pairs change, or the set of moving bodies.
struct ContactGraph {
    /// An edge from an immovable body, kinematic or wholly frozen, to a component. `component` is the root.
    struct KinematicEdge {
        Slot body = 0, component = 0;
        auto operator<=>(const KinematicEdge&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0
    };
    std::vector<Slot> roots; // by slot: the lowest slot of the component
    std::vector<KinematicEdge> kinematicEdges;
    bool pushedByKinematicStale =
        true;                         // SolverScratch::pushedByKinematic of bodies may differ from that of their roots
    std::vector<Slot> componentRoots; // of all components that contain a moving body
    std::vector<BodyVelocity> inertias; // by slot: mass, mass (kg) and inertia (kg m²); 0 where infinite
};

} // namespace spacetow
