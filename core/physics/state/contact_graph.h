#pragma once
// The contact graph: its vertices are bodies, its edges the solid pairs, whether they touch or not. See
// core/physics/solver/contact_graph.h.

#include "core/physics/lanes/wide.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace spacetow {

/// Holds until pairs change or who moves.
struct ContactGraph {
    /// From a body that nothing can move, kinematic or wholly frozen, to a component, by the root of that.
    struct KinematicEdge {
        Slot body = 0, component = 0;
        auto operator<=>(const KinematicEdge&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0
    };
    std::vector<Slot> roots; // by slot: the lowest of its component
    std::vector<KinematicEdge> kinematicEdges;
    bool pushedByKinematicStale = true; // bodies may have other marks in `pushedByKinematic` than their components
    std::vector<Slot> componentRoots;   // roots of the bodies that move
    std::vector<BodyVelocity> inertias; // by slot: mass, mass and inertia
};

} // namespace spacetow
