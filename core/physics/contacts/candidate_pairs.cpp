#include "core/physics/contacts/candidate_pairs.h"

#include "core/physics/contacts/contact_rules.h"

#include <cmath>

namespace spacetow {

namespace {

void listByBounds(WorldData& data) {
    const auto count = static_cast<std::uint32_t>(data.table.size());
    if (data.scratch.narrow.candidates.capacity() < count) {
        data.scratch.narrow.candidates.reserve(
            data.table.capacity()); // resizing would add no more than what is needed now
    }
    data.scratch.narrow.candidates.resize(count);
    std::size_t size = 0;
    const auto isCandidate = [&](std::uint32_t i) { return data.mayTouchNow(i) ? 1U : 0U; };
    const auto note = [&](std::uint32_t i) { // without a branch that could not be foretold
        data.scratch.narrow.candidates[size] = i;
        size += isCandidate(i);
    };
    std::uint32_t i = 0;
    for (; i + 4 <= count; i += 4) { // where all is at rest, none of four is one
        if ((isCandidate(i) | isCandidate(i + 1) | isCandidate(i + 2) | isCandidate(i + 3)) != 0) {
            for (std::uint32_t k = i; k < i + 4; ++k) {
                note(k);
            }
        }
    }
    for (; i < count; ++i) {
        note(i);
    }
    data.scratch.narrow.candidates.resize(size);
}

/// Whether the discs around the bodies are all that there is to go by.
bool isUnknown(const Pair& pair) {
    return !pair.staticB && pair.contact == Pair::none && pair.kind != PairKind::Sensor;
}

/// Half of the open pairs end here, one as likely as the next: no branch could be foretold.
void boundByDiscs(WorldData& data) {
    constexpr std::size_t ahead = 16;
    std::size_t left = 0;
    for (std::size_t k = 0; k < data.scratch.narrow.candidates.size(); ++k) {
        if (k + ahead < data.scratch.narrow.candidates.size()) {
            __builtin_prefetch(&data.table.pairs[data.scratch.narrow.candidates[k + ahead]]);
        }
        const std::uint32_t i = data.scratch.narrow.candidates[k];
        PairBound& bound = data.table.bounds[i];
        const Discs discs = discsOf(data, bound);
        const bool apart = isUnknown(data.table.pairs[i]) & discs.areApart();
        const double until = data.motionOf(bound) + discs.gap();
        bound.separationBound = apart ? until : bound.separationBound;
        data.table.flags[i].touching &= !apart;
        data.scratch.narrow.candidates[left] = i;
        left += apart ? 0 : 1;
    }
    data.scratch.narrow.candidates.resize(left);
}

} // namespace

void listCandidates(WorldData& data) {
    listByBounds(data);
    boundByDiscs(data);
}

} // namespace spacetow
