#include "core/physics/state/contact_data.h"

#include <algorithm>

namespace spacetow {

PairBound unknownBound(const Pair& pair) {
    return {moverOf(pair.bodyA), pair.staticB ? Mover::Static : moverOf(pair.bodyB), 0};
}

void PairTable::clear() {
    bounds.clear();
    flags.clear();
    pairs.clear();
}

void PairTable::add(const Pair& pair) {
    bounds.push_back(unknownBound(pair));
    flags.emplace_back();
    pairs.push_back(pair);
}

void PairTable::addFrom(const PairTable& other, std::size_t index) {
    bounds.push_back(other.bounds[index]);
    flags.push_back(other.flags[index]);
    pairs.push_back(other.pairs[index]);
}

std::size_t PairTable::firstFrom(std::uint64_t bodies) const {
    const auto isBefore = [](const Pair& pair, std::uint64_t key) { return pair.key().bodies() < key; };
    return static_cast<std::size_t>(std::lower_bound(pairs.begin(), pairs.end(), bodies, isBefore) - pairs.begin());
}

} // namespace spacetow
