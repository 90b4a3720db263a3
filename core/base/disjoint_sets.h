#pragma once
// Disjoint sets of indices as trees (union-find): each index has a parent in its set, the lowest has itself.

#include <algorithm>
#include <cstdint>
#include <vector>

namespace spacetow {

/// The lowest index of the set. Halves the path to it.
inline std::uint32_t rootOf(std::vector<std::uint32_t>& parents, std::uint32_t index) {
    while (parents[index] != index) {
        parents[index] = parents[parents[index]];
        index = parents[index];
    }
    return index;
}

inline void uniteSets(std::vector<std::uint32_t>& parents, std::uint32_t a, std::uint32_t b) {
    if (parents[a] == parents[b]) {
        return;
    }
    const std::uint32_t rootA = rootOf(parents, a);
    const std::uint32_t rootB = rootOf(parents, b);
    const std::uint32_t root = std::min(rootA, rootB);
    parents[std::max(rootA, rootB)] = root;
    parents[a] = parents[b] = root; // so that most of the others that are united with them see it at once
}

} // namespace spacetow
