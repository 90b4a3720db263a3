#pragma once
// What a timeline has marked, without the moments.

#include "core/game/timeline.h"

#include <vector>

namespace spacetow::test {

/// In the order of the marks.
inline std::vector<MarkKind> markKinds(const Timeline& timeline) {
    std::vector<MarkKind> kinds;
    if (!timeline.marks().empty()) {
        for (const TimelineMark& mark : timeline.marks().all()) {
            kinds.push_back(mark.kind);
        }
    }
    return kinds;
}

} // namespace spacetow::test
