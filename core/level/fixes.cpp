#include "core/level/fixes.h"

#include "core/geometry/polygon.h"
#include "core/level/edits.h"
#include "core/level/fix_edits.h"
#include "core/level/groups.h"
#include "core/level/lint.h"

#include <algorithm>
#include <array>
#include <set>

namespace spacetow {

namespace {

Level removeIt(Level level, const Problem& problem) {
    const std::array keys{problem.object};
    return removed(std::move(level), keys);
}

Level showIt(Level level, const Problem& problem) {
    const std::array keys{problem.object};
    return withVisible(std::move(level), keys, true);
}

template <Level (*edit)(Level, Key)>
Level wholeObject(Level level, const Problem& problem) {
    return edit(std::move(level), problem.object);
}

template <Level (*edit)(Level, Key, int)>
Level shapeOf(Level level, const Problem& problem) {
    const int shape = numberAfter(problem.pointer, "/shapes/");
    return shape < 0 ? level : edit(std::move(level), problem.object, shape);
}

Level closeGap(Level level, const Problem& problem) {
    const int shape = numberAfter(problem.pointer, "/shapes/");
    return shape < 0 || problem.place.size() != 2
               ? level
               : withEndMoved(std::move(level), {problem.object, shape}, problem.place[0], problem.place[1]);
}

Level addWall(Level level, const Problem& problem) {
    const int shape = numberAfter(problem.pointer, "/shapes/");
    return shape < 0 || problem.place.size() != 2
               ? level
               : withWallAdded(std::move(level), {problem.object, shape}, problem.place[0], problem.place[1]);
}

Level limitDepth(Level level, const Problem& problem) {
    constexpr double shelf = 0.15; // m, of a wall in the open
    const int shape = numberAfter(problem.pointer, "/shapes/");
    const double thickness = problem.place.size() == 2 ? (problem.place[1] - problem.place[0]).norm() : shelf;
    return shape < 0 ? level : withDepthAtMost(std::move(level), {problem.object, shape}, thickness);
}

Level plainBackground(Level level, const Problem&) {
    level.rules.background = shippedBackgrounds.back();
    return level;
}

Level renumber(Level level, const Problem& problem) {
    return withFreshKey(std::move(level), numberAfter(problem.pointer, "/objects/"));
}

Level putToTop(Level level, const Problem& problem) {
    return withoutParent(std::move(level), problem.object);
}

constexpr Fix table[] = {
    {"idle-points", "fix-remove-idle-points", true, true, wholeObject<withoutIdlePoints>},
    {"zero-length-wall", "fix-merge-points", true, true, wholeObject<withoutRepeats>},
    {"repeated-vertex", "fix-merge-points", true, true, wholeObject<withoutRepeats>},
    {"polygon-clockwise", "fix-turn-outline", true, true, wholeObject<anticlockwise>},
    {"wall-reversed", "fix-reverse", true, false, shapeOf<reversedShape>},
    {"walls-disagree", "fix-reverse", false, false, shapeOf<reversedShape>},
    {"chain-nearly-closed", "fix-close-gap", true, false, closeGap},
    {"chain-gap", "fix-close-gap", true, false, closeGap},
    {"leak-wall-reversed", "fix-reverse", false, false, shapeOf<reversedShape>},
    {"leak-chain-reversed", "fix-reverse", false, false, shapeOf<reversedShape>},
    {"leak-not-closed", "fix-add-wall", false, false, addWall},
    {"leak-wall-missing", "fix-add-wall", false, false, addWall},
    {"leak-gap", "fix-add-wall", false, false, addWall},
    {"leak-too-short", "fix-add-wall", false, false, addWall},
    {"wall-twice", "fix-remove-twice", true, true, wholeObject<withoutOverlaps>},
    {"walls-overlap", "fix-remove-twice", false, true, wholeObject<withoutOverlaps>},
    {"walls-overlap-themselves", "fix-remove-twice", false, true, wholeObject<withoutOverlaps>},
    {"object-twice", "fix-remove-twice", true, true, wholeObject<withoutTwin>},
    {"no-back-reaches-through", "fix-limit-depth", true, false, limitDepth},
    {"depth-reaches-through", "fix-limit-depth", true, false, limitDepth},
    {"shelf-without-back", "fix-limit-depth", true, false, limitDepth},
    {"background-unknown", "fix-plain-background", true, true, plainBackground},
    {"parent-missing", "fix-put-to-top", true, true, putToTop},
    {"parent-no-group", "fix-put-to-top", true, true, putToTop},
    {"parent-circle", "fix-put-to-top", true, true, putToTop},
    {"layer-in-group", "fix-put-to-top", false, true, putToTop},
    {"key-taken", "fix-renumber", true, false, renumber},
    {"wall-not-tagged", "fix-tag-as-wall", false, true, wholeObject<taggedAsWall>},
    {"hidden-in-play", "fix-show", false, true, showIt},
    {"several-ships", "fix-remove", false, true, removeIt},
    {"several-payloads", "fix-remove", false, true, removeIt},
    {"several-finishes", "fix-remove", false, true, removeIt},
    {"connector-end-missing", "fix-remove", false, true, removeIt},
    {"connector-end-no-body", "fix-remove", false, true, removeIt},
    {"connector-same-ends", "fix-remove", false, true, removeIt},
    {"no-shape", "fix-remove", false, true, removeIt},
    {"chain-too-short", "fix-remove-unbuildable", false, true, wholeObject<withoutUnbuildable>},
    {"chain-without-length", "fix-remove-unbuildable", false, true, wholeObject<withoutUnbuildable>},
    {"polygon-too-few-vertices", "fix-remove-unbuildable", false, true, wholeObject<withoutUnbuildable>},
    {"polygon-flat", "fix-remove-unbuildable", false, true, wholeObject<withoutUnbuildable>},
    {"polygon-crosses-itself", "fix-untangle", false, true, wholeObject<untangled>},
    {"polygon-not-simple", "fix-untangle", false, true, wholeObject<untangled>},
    {"cave-inside-out", "fix-reverse", false, false, shapeOf<reversedShape>},
    {"ship-in-wall", "fix-move-free", false, true, wholeObject<movedFree>},
    {"payload-in-wall", "fix-move-free", false, true, wholeObject<movedFree>},
};

} // namespace

std::span<const Fix> fixes() {
    return table;
}

const Fix* fixFor(const Problem& problem) {
    const auto* const found = std::ranges::find(table, problem.code, &Fix::problem);
    const bool isGap = problem.code == "chain-gap" || problem.code == "chain-nearly-closed";
    return found == std::end(table) || (isGap && problem.place.size() != 2) ? nullptr : found;
}

Level fixed(Level level, const Problem& problem) {
    const Fix* const fix = fixFor(problem);
    return fix == nullptr ? level : fix->apply(std::move(level), problem);
}

FixedLevel withSafeFixes(Level level, const std::stop_token& stop) {
    constexpr int rounds = 8; // what one fix uncovers is for the next round; that ends soon
    FixedLevel result{std::move(level), {}};
    for (int round = 0; round < rounds; ++round) {
        const std::vector<Problem> problems = lint(result.level, stop);
        const std::vector<bool> hidden = hiddenAmong(result.level, problems);
        std::set<std::pair<Key, FixCode>> done; // by fixes for whole objects
        std::set<Key> changed;                  // by those: pointers into these are out of date
        const Level before = result.level;
        for (std::size_t i = 0; i < problems.size() && !stop.stop_requested(); ++i) {
            const Problem& problem = problems[i];
            const Fix* const fix = fixFor(problem);
            if (fix == nullptr || !fix->isSafe || hidden[i]) {
                continue;
            }
            const bool isSame = fix->isWhole && done.contains({problem.object, fix->label});
            if (!isSame && problem.object != 0 && changed.contains(problem.object)) {
                continue;
            }
            if (!isSame) {
                Level next = fix->apply(result.level, problem);
                if (next == result.level) {
                    continue;
                }
                result.level = std::move(next);
            }
            if (fix->isWhole) {
                done.insert({problem.object, fix->label});
                changed.insert(problem.object);
            }
            result.cured.push_back(problem);
        }
        if (result.level == before) {
            break;
        }
    }
    return result;
}

} // namespace spacetow
