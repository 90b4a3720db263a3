#include "core/physics/contacts/candidate_pairs.h"

#include "core/physics/contacts/contact_rules.h"

#include <cmath>

namespace spacetow {

namespace {

/// Fills `candidates` with the pairs whose separation bound is reached.
void listByBounds(const Bodies& bodies, const Contacts& contacts, NarrowPhase& narrow) {
    const auto count = static_cast<std::uint32_t>(contacts.table.size());
    if (narrow.candidates.capacity() < count) {
        narrow.candidates.reserve(contacts.table.capacity()); // resize() alone would reserve no more than `count`
    }
    narrow.candidates.resize(count);
    std::size_t size = 0;
    const auto isCandidate = [&](std::uint32_t i) { return contacts.mayTouchNow(bodies, i) ? 1U : 0U; };
    const auto note = [&](std::uint32_t i) { // without a branch, which would be unpredictable
        narrow.candidates[size] = i;
        size += isCandidate(i);
    };
    std::uint32_t i = 0;
    for (; i + 4 <= count; i += 4) { // at rest hardly any pair is a candidate: this branch is predictable
        if ((isCandidate(i) | isCandidate(i + 1) | isCandidate(i + 2) | isCandidate(i + 3)) != 0) {
            for (std::uint32_t k = i; k < i + 4; ++k) {
                note(k);
            }
        }
    }
    for (; i < count; ++i) {
        note(i);
    }
    narrow.candidates.resize(size);
}

/// Whether bounding circles are tested for the pair.
bool isUnknown(const Pair& pair) {
    return !pair.staticB && pair.contact == Pair::none && pair.kind != PairKind::Sensor;
}

/// Gives candidates whose bounding circles are apart a separation bound and removes them from the list. About half of
/// them are, at random, so the loop has no branch.
void boundByCircles(const Bodies& bodies, Contacts& contacts, NarrowPhase& narrow) {
    constexpr std::size_t ahead = 16;
    std::size_t left = 0;
    for (std::size_t k = 0; k < narrow.candidates.size(); ++k) {
        if (k + ahead < narrow.candidates.size()) {
            __builtin_prefetch(&contacts.table.pairs[narrow.candidates[k + ahead]]);
        }
        const std::uint32_t i = narrow.candidates[k];
        PairBound& bound = contacts.table.bounds[i];
        const BoundingCircles circles = boundingCirclesOf(bodies, bound);
        bool apart = isUnknown(contacts.table.pairs[i]);
        apart &= circles.areApart(); // no &&, which is a branch
        const double until = bodies.motionOf(bound) + circles.separation();
        bound.separationBound = apart ? until : bound.separationBound;
        contacts.table.flags[i].touching &= !apart;
        narrow.candidates[left] = i;
        left += apart ? 0 : 1;
    }
    narrow.candidates.resize(left);
}

} // namespace

void listCandidates(const Bodies& bodies, Contacts& contacts, NarrowPhase& narrow) {
    listByBounds(bodies, contacts, narrow);
    boundByCircles(bodies, contacts, narrow);
}

} // namespace spacetow
