#pragma once
// Data of the broad phase: proxies, found pairs, and runs of the pair table.

#include "core/physics/state/contact_data.h"

#include <cstdint>

namespace spacetow {

/// One part of a moving or sleeping body in the broad phase.
struct MovingProxy {
    Slot body;
    std::uint32_t part;
    bool slender = false;       // a long part: most of its AABB is empty
    bool movedProxy = false;    // the body has left its fat AABB; set only while the broad phase searches
    bool isStaleInTree = false; // the tree still holds an older AABB of the part
};

/// The key of a pair that the broad phase has found. Ordered like Pair: by bodies, then by parts.
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

/// A run of consecutive pairs that stay consecutive when the pair table changes.
struct Run {
    std::uint32_t begin = 0, end = 0; // indices in the old table, without `end`
    std::uint32_t to = 0;             // index of the first pair in the new table
};

} // namespace spacetow
