#pragma once
// All edits of core/level in tables, each with a way of asking for it at random. A test holds the tables against the
// headers: an edit that is in none of them fails it.

#include "core/base/random.h"
#include "core/level/edits.h"
#include "core/level/nodes.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <span>
#include <vector>

namespace spacetow::test {

/// A level and what an edit may be asked to do with it.
struct EditTask {
    EditTask(std::uint64_t seed, const Level& given);

    template <class T>
    std::vector<T> some(const std::vector<T>& from) {
        const double share = random.unit();
        std::vector<T> chosen;
        std::ranges::copy_if(from, std::back_inserter(chosen), [&](const T&) { return random.unit() < share; });
        return chosen;
    }
    int below(int count) { return static_cast<int>(random.below(static_cast<std::uint32_t>(count))); }
    bool chance() { return below(2) == 0; }
    double number() { return random.uniform(-20, 20); }
    Vec2 point() { return {number(), number()}; }
    template <class Enum>
    Enum oneOf(std::initializer_list<Enum> values) {
        return values.begin()[below(static_cast<int>(values.size()))];
    }
    Affine map();
    /// A group, or 0 for the top.
    Key group();
    Object fresh(ObjectData data) { return {freshKey(level, random.next()), "made", std::move(data), {}}; }
    Guide guide() { return {point(), number(), "made"}; }
    std::size_t guideIndex() { return static_cast<std::size_t>(below(4)); }
    std::vector<Object> foreign();
    CopyPlace place() { return {point(), random.next(), group(), chance()}; }

    Level level;
    Random random;
    std::vector<Key> all, keys; // ascending
    std::vector<NodeRef> nodes; // ascending
    Key key = 0;                // of some object; 0 when there is none
    std::vector<Key> copies;
};

struct EditRow {
    const char* name;
    Level (*run)(EditTask& task);
};

/// What people do to a level.
std::span<const EditRow> everyEdit();
/// What cures the problems that lint finds.
std::span<const EditRow> everyCure();

} // namespace spacetow::test
