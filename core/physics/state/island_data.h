#pragma once
// What is known of islands: bodies that may push each other. See energy_limit.h.

#include "core/physics/lanes/wide.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace spacetow {

/// Bodies that may push each other, directly or through others. They hold until pairs change or who moves.
struct Islands {
    /// A body that nothing can move, next to an island, by the root of that.
    struct Driver {
        Slot slot = 0, pushed = 0;
        auto operator<=>(const Driver&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
    };
    std::vector<Slot> roots; // by slot: the lowest of its island
    std::vector<Driver> drivers;
    bool drivenStale = true;            // bodies may have other marks in `driven` than their islands
    std::vector<Slot> islandRoots;      // roots of the bodies that move
    std::vector<BodyVelocity> inertias; // by slot: mass, mass and inertia
};

} // namespace spacetow
