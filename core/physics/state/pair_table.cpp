#include "core/physics/state/contact_data.h"

namespace spacetow {

PairGate gateOf(const Pair& pair) {
    return {pair.bodyA + 1, pair.staticB ? 0 : pair.bodyB + 1, 0};
}

void PairTable::clear() {
    gates.clear();
    marks.clear();
    pairs.clear();
}

void PairTable::add(const Pair& pair) {
    gates.push_back(gateOf(pair));
    marks.emplace_back();
    pairs.push_back(pair);
}

void PairTable::addFrom(const PairTable& other, std::size_t index) {
    gates.push_back(other.gates[index]);
    marks.push_back(other.marks[index]);
    pairs.push_back(other.pairs[index]);
}

} // namespace spacetow
