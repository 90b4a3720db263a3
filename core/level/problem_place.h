#pragma once
// Where in the level a problem is, for marks on the canvas. World coordinates, metres.

#include "core/level/problem.h"

#include <span>
#include <vector>

namespace spacetow {

/// A point, or a line along what is wrong; empty for what has no place. Long lines come with fewer points.
std::vector<Vec2> placeOf(const Level& level, const Problem& problem);

struct ProblemMark {
    Vec2 at{0, 0};
    std::vector<Vec2> line;   // as in Problem, empty for a mere point
    std::vector<Vec2> wayOut; // as in Problem
    Severity severity = Severity::Note;
    int problem = 0; // its place among the problems

    bool operator==(const ProblemMark&) const = default;
};
/// Of all that have a place, but for those that are `hidden`.
std::vector<ProblemMark> marksOf(const Level& level, std::span<const Problem> problems,
                                 const std::vector<bool>& hidden);

} // namespace spacetow
