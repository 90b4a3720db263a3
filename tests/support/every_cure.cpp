// The cures of what lint finds, for every_edit.h.
#include "core/level/chain_ends.h"
#include "core/level/field_edits.h"
#include "core/level/fix_edits.h"
#include "core/level/fixes.h"
#include "core/level/lint.h"
#include "tests/support/every_edit.h"

#include <optional>
#include <utility>

namespace spacetow::test {

namespace {

/// All objects one after the other.
template <Level (*cure)(Level level, Key key)>
Level curedAll(EditTask& task) {
    Level level = task.level;
    for (const Key key : task.all) {
        level = cure(std::move(level), key);
    }
    return level;
}

/// Likewise where everything lies on something.
template <Level (*cure)(Level level, Key key)>
Level curedTwins(EditTask& task) {
    Level level = duplicated(task.level, task.all, {{0, 0}, task.random.next()}, task.copies);
    for (const Key key : task.all) {
        level = cure(std::move(level), key);
    }
    return level;
}

/// One more object, of shapes with faults that no sound level has.
template <Level (*cure)(Level level, Key key)>
Level curedFaulty(EditTask& task) {
    const Vec2 at = task.point();
    const Object faulty = task.fresh(BodyObject{
        .shapes = {LineChain{{at, at + Vec2(1, 0), at + Vec2(1, 0), at + Vec2(1, 2)}}, Polygon{{at, at, at}}}});
    Level level = added(task.level, faulty);
    level = withoutUnbuildable(cure(std::move(level), faulty.key), faulty.key);
    return withoutRepeats(std::move(level), faulty.key);
}

Level shapesReversed(EditTask& task) {
    Level level = task.level;
    for (const Key key : task.keys) {
        level = reversedShape(std::move(level), key, task.below(2));
    }
    return level;
}

Level depthsLimited(EditTask& task) {
    Level level = task.level;
    for (const Key key : task.all) {
        level = withDepthAtMost(std::move(level), {key, task.below(2)}, task.random.uniform(0.05, 5));
    }
    return level;
}

/// From one open end to another one.
template <Level (*join)(Level level, const ShapeRef& chain, const Vec2& from, const Vec2& to)>
Level endsJoined(EditTask& task) {
    struct End {
        ShapeRef chain;
        Vec2 at{0, 0};
    };
    std::vector<End> ends;
    for (const Key key : task.all) {
        for (const bool first : {true, false}) {
            if (const std::optional<OpenChain> chain = openChain(task.level, {key, 0, first})) {
                ends.push_back({{key, 0}, chain->at});
            }
        }
    }
    if (ends.empty()) {
        return task.level;
    }
    const auto any = [&] { return ends[static_cast<std::size_t>(task.below(static_cast<int>(ends.size())))]; };
    const End from = any();
    return join(task.level, from.chain, from.at, any().at);
}

/// The last two objects have one key.
Level twiceNamed(EditTask& task) {
    Level level = task.level;
    level.objects.append(level.objects[level.objects.size() - 1]);
    return withFreshKey(level, level.objects.size() - 1);
}

std::optional<Problem> someProblem(EditTask& task) {
    const std::vector<Problem> problems = lint(task.level);
    return problems.empty()
               ? std::nullopt
               : std::optional(problems[static_cast<std::size_t>(task.below(static_cast<int>(problems.size())))]);
}

Level problemFixed(EditTask& task) {
    const std::optional<Problem> problem = someProblem(task);
    return problem ? fixed(task.level, *problem) : task.level;
}

Level problemHidden(EditTask& task) {
    const std::optional<Problem> problem = someProblem(task);
    return problem ? withProblemHidden(task.level, *problem, true) : task.level;
}

constexpr EditRow cureRows[] = {
    {"withoutRepeats", curedFaulty<withoutRepeats>},
    {"withoutIdlePoints", curedAll<withoutIdlePoints>},
    {"anticlockwise", curedAll<anticlockwise>},
    {"untangled", curedAll<untangled>},
    {"withoutUnbuildable", curedFaulty<withoutUnbuildable>},
    {"withoutParent", curedAll<withoutParent>},
    {"taggedAsWall", curedAll<taggedAsWall>},
    {"movedFree", curedAll<movedFree>},
    {"withoutOverlaps", curedTwins<withoutOverlaps>},
    {"withoutTwin", curedTwins<withoutTwin>},
    {"reversedShape", shapesReversed},
    {"withDepthAtMost", depthsLimited},
    {"withEndMoved", endsJoined<withEndMoved>},
    {"withWallAdded", endsJoined<withWallAdded>},
    {"withFreshKey", twiceNamed},
    {"fixed", problemFixed},
    {"withSafeFixes", [](EditTask& t) { return withSafeFixes(t.level).level; }},
    {"withProblemHidden", problemHidden},
};

} // namespace

std::span<const EditRow> everyCure() {
    return cureRows;
}

} // namespace spacetow::test
