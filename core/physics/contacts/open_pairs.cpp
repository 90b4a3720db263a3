#include "core/physics/contacts/open_pairs.h"

#include "core/physics/contacts/contact_rules.h"

#include <cmath>

namespace spacetow {

namespace {

void listOpenGates(WorldData& data) {
    const auto count = static_cast<std::uint32_t>(data.table.size());
    if (data.open.capacity() < count) {
        data.open.reserve(data.table.capacity()); // resizing would add no more than what is needed now
    }
    data.open.resize(count);
    std::size_t size = 0;
    const auto opens = [&](std::uint32_t i) { return data.isGateOpen(i) ? 1U : 0U; };
    const auto note = [&](std::uint32_t i) { // without a branch that could not be foretold
        data.open[size] = i;
        size += opens(i);
    };
    std::uint32_t i = 0;
    for (; i + 4 <= count; i += 4) { // where all is at rest, all four are shut
        if ((opens(i) | opens(i + 1) | opens(i + 2) | opens(i + 3)) != 0) {
            for (std::uint32_t k = i; k < i + 4; ++k) {
                note(k);
            }
        }
    }
    for (; i < count; ++i) {
        note(i);
    }
    data.open.resize(size);
}

/// Whether the discs around the bodies are all that there is to go by.
bool isUnknown(const Pair& pair) {
    return !pair.staticB && pair.contact == Pair::none && pair.kind != PairKind::Felt;
}

/// Half of the open pairs end here, one as likely as the next: no branch could be foretold.
void shutWhereDiscsAreApart(WorldData& data) {
    constexpr std::size_t ahead = 16;
    std::size_t left = 0;
    for (std::size_t k = 0; k < data.open.size(); ++k) {
        if (k + ahead < data.open.size()) {
            __builtin_prefetch(&data.table.pairs[data.open[k + ahead]]);
        }
        const std::uint32_t i = data.open[k];
        PairGate& gate = data.table.gates[i];
        const Discs discs = discsOf(data, gate);
        const bool apart = isUnknown(data.table.pairs[i]) & discs.areApart();
        const double until = data.milesOf(gate) + discs.gap();
        gate.apartUntil = apart ? until : gate.apartUntil;
        data.table.marks[i].now &= !apart;
        data.open[left] = i;
        left += apart ? 0 : 1;
    }
    data.open.resize(left);
}

} // namespace

void listOpen(WorldData& data) {
    listOpenGates(data);
    shutWhereDiscsAreApart(data);
}

} // namespace spacetow
