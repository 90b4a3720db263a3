#include "core/level/problem_place.h"

#include "core/level/fix_edits.h"
#include "core/level/level_index.h"
#include "core/level/nodes.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr std::size_t mostPoints = 200; // of a line

std::vector<Vec2> thinned(const std::vector<Vec2>& line) {
    if (line.size() <= mostPoints) {
        return line;
    }
    std::vector<Vec2> few;
    for (std::size_t i = 0; i < mostPoints; ++i) {
        few.push_back(line[i * (line.size() - 1) / (mostPoints - 1)]);
    }
    return few;
}

} // namespace

std::vector<Vec2> placeOf(const Level& level, const Problem& problem) {
    if (!problem.place.empty()) {
        return std::ranges::all_of(problem.place, isFinite) ? thinned(problem.place) : std::vector<Vec2>();
    }
    const int index = problem.object == 0 ? -1 : level.objects.indexOf(problem.object);
    if (index < 0) {
        return {};
    }
    const int shape = std::max(0, numberAfter(problem.pointer, "/shapes/"));
    const int vertex = numberAfter(problem.pointer, "/vertices/");
    if (vertex >= 0) {
        const auto at = nodePosition(level, {problem.object, shape, vertex});
        if (at && isFinite(*at)) {
            return {*at};
        }
    }
    const Aabb& box = levelIndex(level).boundsOf(index);
    const Vec2 center = box.center();
    return box.isEmpty() || !isFinite(center) ? std::vector<Vec2>() : std::vector{center};
}

std::vector<ProblemMark> marksOf(const Level& level, std::span<const Problem> problems,
                                 const std::vector<bool>& hidden) {
    std::vector<ProblemMark> marks;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        std::vector<Vec2> place = hidden[i] ? std::vector<Vec2>() : placeOf(level, problems[i]);
        if (!place.empty()) {
            const Vec2 at = place.size() == 2 ? Vec2(0.5 * (place[0] + place[1])) : place[place.size() / 2];
            if (place.size() == 1) {
                place.clear();
            }
            marks.push_back(
                {at, std::move(place), thinned(problems[i].wayOut), problems[i].severity, static_cast<int>(i)});
        }
    }
    return marks;
}

} // namespace spacetow
