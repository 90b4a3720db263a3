#include "core/level/lint.h"

#include "core/level/key_text.h"
#include "core/level/lint_findings.h"
#include "core/level/lint_walls.h"
#include "core/level/unknown_fields.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>

namespace spacetow {

const char* severityName(Severity severity) {
    constexpr std::array names{"note", "warning", "error"};
    return names[static_cast<std::size_t>(severity)];
}

bool hasErrors(const std::vector<Problem>& problems) {
    return std::ranges::any_of(problems, [](const Problem& p) { return p.severity == Severity::Error; });
}

void Findings::add(Severity severity, LevelCode code, std::vector<std::string> arguments, const FindingPlace& place) {
    const std::string start = place.index < 0 ? std::string() : "/objects/" + std::to_string(place.index);
    m_found.emplace_back(place.index, Problem{severity, code, std::move(arguments), start + place.path, 0, place.key,
                                              place.place, place.wayOut});
    if (severity == Severity::Error) {
        m_bad.insert(place.index);
    }
}

std::vector<Problem> Findings::sorted() && {
    std::ranges::stable_sort(m_found, {}, &std::pair<int, Problem>::first);
    std::vector<Problem> problems;
    problems.reserve(m_found.size());
    for (auto& [index, problem] : m_found) {
        problems.push_back(std::move(problem));
    }
    return problems;
}

void checkTags(const Level& level, Findings& findings) {
    for (int i = 0; i < TagTable::size; ++i) {
        const std::string& name = level.tags[i].name;
        if (unnamedTag(name) >= 0) {
            findings.add(Severity::Error, "bad-tag-name", {name}, {.path = "/tags"});
        } else if (!name.empty() && *level.tags.indexOf(name) != i) {
            findings.add(Severity::Error, "duplicate-tag", {name}, {.path = "/tags"});
        }
    }
}

void checkKeys(const Level& level, Findings& findings) {
    std::map<Key, int> owners;
    for (int i = 0; i < level.objects.size(); ++i) {
        const Key key = level.objects[i].key;
        const auto [owner, isNew] = owners.emplace(key, i);
        if (!isNew || key == 0) {
            findings.add(Severity::Error, "key-taken", {keyText(key)}, {i, key, "/key"});
        }
    }
}

void checkFilters(const Level& level, Findings& findings) {
    // Levels use few different filters, so comparing each with each is cheap; one with more is past understanding.
    constexpr std::size_t maxFilters = 500;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Object& object : level.objects) {
        if (const auto* body = std::get_if<BodyObject>(&object.data)) {
            ++uses[{body->filter.tags.bits, body->filter.touches.bits}];
        }
    }
    const bool isGame = firstOf<ShipObject>(level) != nullptr || firstOf<PayloadObject>(level) != nullptr;
    const TagMask players = TagMask::bit(shipTag) | TagMask::bit(payloadTag) | TagMask::bit(debrisTag);
    const auto isAlone = [&](const Filter& filter, int count) {
        // Whoever plays touches walls, and is what it is named after.
        if (isGame && mayTouch(filter, {players, TagMask::bit(wallTag) | players | TagMask::bit(finishTag)})) {
            return false;
        }
        return std::ranges::none_of(uses, [&](const auto& use) {
            const Filter other{{use.first.first}, {use.first.second}};
            return mayTouch(filter, other) && (!(other == filter) || count > 1);
        });
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> alone;
    for (const auto& [bits, count] : uses) {
        const Filter filter{{bits.first}, {bits.second}};
        const bool canTouchNothing = filter.tags.bits == 0 || filter.touches.bits == 0;
        const bool hasCompany = uses.size() <= maxFilters && (uses.size() > 1 || isGame);
        alone[bits] = canTouchNothing || (hasCompany && isAlone(filter, count));
    }
    for (int i = 0; i < level.objects.size(); ++i) {
        const auto* body = std::get_if<BodyObject>(&level.objects[i].data);
        if (body != nullptr && body->tangible && alone[{body->filter.tags.bits, body->filter.touches.bits}]) {
            findings.add(Severity::Warning, "touches-nothing", {}, {i, level.objects[i].key, "/touches"});
        }
    }
}

namespace {

using Check = void (*)(const Level&, Findings&);

// What keeps an object from being built, and what is wrong with those that can be.
constexpr std::array buildingChecks{checkTags,   checkKeys,   checkRanges,    checkShapes,
                                    checkMasses, checkGroups, checkConnectors};
constexpr std::array playingChecks{checkFilters, checkStart, checkGame, checkWalls, checkTwins, checkLeaks};

void run(std::span<const Check> checks, const Level& level, Findings& findings) {
    for (const Check check : checks) {
        if (findings.isStopped()) {
            return;
        }
        check(level, findings);
    }
}

} // namespace

std::vector<Problem> lint(const Level& level, const std::stop_token& stop) {
    Findings findings(stop);
    run(buildingChecks, level, findings);
    run(playingChecks, level, findings);
    return std::move(findings).sorted();
}

std::vector<Problem> buildingProblems(const Level& level) {
    Findings findings;
    run(buildingChecks, level, findings);
    return std::move(findings).sorted();
}

std::vector<Problem> placingProblems(const Level& level) {
    Findings findings;
    run(buildingChecks, level, findings);
    checkStart(level, findings);
    checkCaves(level, Walls(wallChains(level, findings)), findings);
    return std::move(findings).sorted();
}

std::vector<bool> hiddenAmong(const Level& level, const std::vector<Problem>& problems) {
    std::vector<std::pair<Key, std::string_view>> wanted;
    for (const HiddenProblem& hidden : level.hiddenProblems) {
        wanted.emplace_back(hidden.object, hidden.rule);
    }
    std::ranges::sort(wanted);
    std::vector<bool> result;
    result.reserve(problems.size());
    for (const Problem& problem : problems) {
        result.push_back(!wanted.empty() &&
                         std::ranges::binary_search(wanted, std::pair(problem.object, problem.code.text())));
    }
    return result;
}

Level withProblemHidden(Level level, const Problem& problem, bool hidden) {
    const HiddenProblem entry{std::string(problem.code.text()), problem.object};
    std::vector<int> lost;
    for (std::size_t i = 0; i < level.hiddenProblems.size(); ++i) {
        if (level.hiddenProblems[i] == entry) {
            lost.push_back(static_cast<int>(i));
        }
    }
    if (hidden && !lost.empty()) {
        return level; // with what its entry says besides
    }
    std::erase(level.hiddenProblems, entry);
    level.unknownFields = withoutEntries(level.unknownFields, "/hiddenProblems", lost);
    if (hidden) {
        level.hiddenProblems.push_back(entry);
    }
    return level;
}

} // namespace spacetow
