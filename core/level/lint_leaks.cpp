// Where the ship can get out of its cave.
#include "core/level/bounds.h"
#include "core/level/leak.h"
#include "core/level/lint_findings.h"

#include <utility>

namespace spacetow {

namespace {

/// What the sentence about a leak needs to know.
struct LeakWords {
    LevelCode code;
    std::vector<std::string> arguments;
};

LeakWords wordsOf(const Level& level, const Leak& leak) {
    if (leak.kind == Leak::Kind::Reversed) {
        const bool isOne = leak.walls == 1;
        if (leak.isWhole) {
            return isOne ? LeakWords{"leak-wall-reversed", {}}
                         : LeakWords{"leak-chain-reversed", {std::to_string(leak.walls)}};
        }
        return isOne ? LeakWords{"leak-edge-reversed", {std::to_string(leak.from.segment + 1)}}
                     : LeakWords{"leak-edges-reversed", {std::to_string(leak.walls)}};
    }
    if (leak.from.object == leak.to.object) {
        const bool areEnds = leak.from.isEnd && leak.to.isEnd;
        const bool isOneChain = areEnds && leak.from.shape == leak.to.shape;
        return {isOneChain ? LevelCode("leak-not-closed") : (areEnds ? LevelCode("leak-wall-missing") : "leak-opening"),
                {metres(leak.width)}};
    }
    const Object& other = level.objects[leak.to.object];
    std::vector<std::string> arguments = whichObject(level, other, std::get<BodyObject>(other.data));
    arguments.push_back(metres(leak.width));
    return {leak.from.isEnd && leak.to.isEnd ? LevelCode("leak-gap")
                                             : (leak.from.isEnd ? LevelCode("leak-too-short") : "leak-between"),
            std::move(arguments)};
}

/// What was found before and is all that there is to say of the leak; null for none.
Problem* causeOf(const Level& level, const Leak& leak, Findings& findings) {
    if (leak.kind == Leak::Kind::Reversed) {
        const std::string path = "/shapes/" + std::to_string(leak.from.shape);
        return findings.find([&](int index, const Problem& problem) {
            return leak.isWhole && index == leak.from.object && problem.code == "wall-reversed" &&
                   problem.pointer.ends_with(path);
        });
    }
    // The wall is there, but not for the ship.
    return findings.find([&](int index, const Problem& problem) {
        constexpr double near = 0.1; // m
        if (problem.code != "wall-not-tagged") {
            return false;
        }
        const Aabb box = boundsOf(level, level.objects[index]).grown(near);
        return box.contains(leak.from.at) && box.contains(leak.to.at);
    });
}

} // namespace

void checkLeaks(const Level& level, Findings& findings) {
    const auto isBad = [&findings](int object) { return findings.isBad(object); };
    for (Leak& leak : leaksOf(level, isBad, findings.stop())) {
        if (leak.to.isEnd && !leak.from.isEnd) {
            std::swap(leak.from, leak.to); // the wall that is too short is the one to name
        }
        if (Problem* const known = causeOf(level, leak, findings)) {
            known->wayOut = std::move(leak.path);
            continue;
        }
        LeakWords words = wordsOf(level, leak);
        FindingPlace place{leak.from.object, level.objects[leak.from.object].key,
                           "/shapes/" + std::to_string(leak.from.shape)};
        place.place = {leak.from.at, leak.to.at};
        place.wayOut = std::move(leak.path);
        findings.add(Severity::Warning, words.code, std::move(words.arguments), place);
    }
}

} // namespace spacetow
