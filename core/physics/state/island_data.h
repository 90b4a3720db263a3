#pragma once
// What is known of islands: bodies that may push each other. See energy_limit.h.

#include "core/physics/lanes/contact_batches.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace spacetow {

/// What the impulses of an iteration do to the energy of bodies, J: three sums over their motions to the sides, up and
/// around; see energy_limit.cpp.
struct EnergyChange {
    Wide a{}, b{}, c{};
};

/// The change with a share x of the impulses: a·x²/2 + b·x + c. `corrections` is the work of position corrections.
struct EnergyBalance {
    double a = 0, b = 0, c = 0, corrections = 0;

    double gain() const { return 0.5 * a + b + c; }
};

/// Bodies that may push each other, directly or through others.
struct Islands {
    /// A body that nothing can move, next to an island, by the root of that.
    struct Driver {
        Slot slot = 0, pushed = 0;
        auto operator<=>(const Driver&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
    };
    /// Of a contact that is solved again.
    struct SameLane {
        Lane here, there; // in the batches of all contacts and of those
    };
    std::vector<Slot> roots; // by slot: the lowest of its island
    std::vector<Driver> drivers;

    // Working memory.
    std::vector<Slot> islandRoots;         // roots of the bodies that move
    std::vector<BodyVelocity> inertias;    // by slot: mass, mass and inertia
    std::vector<EnergyChange> changes;     // by slot, of roots
    std::vector<EnergyBalance> balances;   // likewise
    ContactBatches batches;                // of islands that are solved again
    std::vector<SameLane> lanes;           // of their contacts
    std::vector<std::uint8_t> unconverged; // by slot, of roots: whether the island is solved again
    std::vector<std::uint8_t> driven;      // by slot: whether something that cannot be stopped pushes the island
    std::vector<std::uint8_t> limited;     // by slot: the round in which the motion was limited
    std::vector<double> fractions;         // by slot: of the motion that is left
};

} // namespace spacetow
