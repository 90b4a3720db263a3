#pragma once
// What the broad phase goes through and finds.

#include "core/physics/state/contact_data.h"

#include <cstdint>

namespace spacetow {

/// A part of a moving body.
struct MovingProxy {
    Slot body;
    std::uint32_t part;
    bool slender = false;       // its box is mostly empty
    bool movedProxy = false;    // its body has, and is looking for pairs
    bool isStaleInTree = false; // not where the tree has it
};

/// What the broad phase finds of a pair; sorted as pairs are.
struct FoundPair {
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t partA = 0, partB = 0;

    FoundPair() = default;
    FoundPair(Slot a, Slot b, std::uint32_t ofA, std::uint32_t ofB) : bodyA(a), bodyB(b), partA(ofA), partB(ofB) {}
    explicit FoundPair(const Pair& pair) : FoundPair(pair.bodyA, pair.bodyB, pair.partA, pair.partB) {}
    std::uint64_t bodies() const { return std::uint64_t{bodyA} << 32 | bodyB; }
    std::uint64_t parts() const { return std::uint64_t{partA} << 32 | partB; }
    bool operator<(const FoundPair& o) const {
        return bodies() != o.bodies() ? bodies() < o.bodies() : parts() < o.parts();
    }
};

/// Elements of a table that stay together when it changes.
struct Run {
    std::uint32_t begin = 0, end = 0; // in the table as it was
    std::uint32_t to = 0;             // where they begin in the table as it becomes
};

} // namespace spacetow
