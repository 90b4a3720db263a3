// How chains of walls go on from each other.
#include "core/level/level_index.h"
#include "core/level/lint_walls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

const WallChain& chainAt(const Walls& walls, int end) {
    return walls.chains[static_cast<std::size_t>(walls.ends.ends()[static_cast<std::size_t>(end)].chain)];
}

/// Nothing but these two ends is here: where others pass, it is no simple corner.
bool isCorner(const Level& level, const Walls& walls, int end, int other) {
    const Vec2& at = walls.ends.ends()[static_cast<std::size_t>(end)].at;
    int vertices = 0;
    levelIndex(level).visitVertices(Aabb{at, at}.grown(lint_limits::together), [&](const VertexRef& ref, const Vec2&) {
        vertices += std::holds_alternative<BodyObject>(level.objects[ref.object].data) ? 1 : 0;
    });
    return vertices == 2 && chainAt(walls, end).oneWay && chainAt(walls, other).oneWay;
}

/// Chains that hang together, each with whether it runs against the first of them.
struct Party {
    std::vector<std::pair<int, bool>> chains;
    std::array<double, 2> lengths{0, 0}; // m, of those that run with it and against it
};

/// Follows the corners from chain to chain. Every chain has two ends, so that this is a walk both ways.
class PartyWalk {
  public:
    PartyWalk(const Level& level, const Walls& walls)
        : m_level(level), m_walls(walls), m_firstEnd(walls.chains.size(), -1), m_seen(walls.chains.size(), false) {
        const auto& ends = walls.ends.ends();
        for (std::size_t i = 0; i < ends.size(); i += 2) {
            m_firstEnd[static_cast<std::size_t>(ends[i].chain)] = static_cast<int>(i);
        }
    }

    /// Nothing when the chain was in another party.
    Party from(int chain) {
        Party party;
        if (m_seen[static_cast<std::size_t>(chain)] || m_firstEnd[static_cast<std::size_t>(chain)] < 0) {
            return party;
        }
        take(party, chain, false);
        const int start = m_firstEnd[static_cast<std::size_t>(chain)];
        walk(party, start);
        walk(party, start + 1);
        return party;
    }

  private:
    void take(Party& party, int chain, bool against) {
        m_seen[static_cast<std::size_t>(chain)] = true;
        party.chains.emplace_back(chain, against);
        party.lengths[against ? 1 : 0] += m_walls.chains[static_cast<std::size_t>(chain)].length();
    }
    void walk(Party& party, int end) {
        const auto& ends = m_walls.ends.ends();
        bool against = false;
        for (int partner = m_walls.ends.partner(end); partner >= 0; partner = m_walls.ends.partner(end)) {
            const WallEndPoint& here = ends[static_cast<std::size_t>(end)];
            const WallEndPoint& there = ends[static_cast<std::size_t>(partner)];
            const bool turns = here.isStart == there.isStart;
            if (m_seen[static_cast<std::size_t>(there.chain)] || !chainAt(m_walls, end).oneWay ||
                !chainAt(m_walls, partner).oneWay || (turns && !isCorner(m_level, m_walls, end, partner))) {
                return;
            }
            against = against != turns;
            take(party, there.chain, against);
            end = WallEnds::opposite(partner);
        }
    }

    const Level& m_level;
    const Walls& m_walls;
    std::vector<int> m_firstEnd;
    std::vector<bool> m_seen;
};

} // namespace

void checkDirections(const Level& level, const Walls& walls, Findings& findings) {
    constexpr double clearly = 2; // times as long is what the majority has to be
    PartyWalk walk(level, walls);
    for (std::size_t i = 0; i < walls.chains.size() && !findings.isStopped(); ++i) {
        const Party party = walk.from(static_cast<int>(i));
        if (party.lengths[0] == 0 || party.lengths[1] == 0) {
            continue;
        }
        const bool wrong = party.lengths[1] <= party.lengths[0]; // whether those that run against the first are
        const bool isClear = party.lengths[wrong ? 0 : 1] >= clearly * party.lengths[wrong ? 1 : 0];
        for (const auto& [chain, against] : party.chains) {
            if (against == wrong) {
                const WallChain& culprit = walls.chains[static_cast<std::size_t>(chain)];
                if (isClear) {
                    findings.add(Severity::Warning, "wall-reversed", {}, culprit.place(culprit.points));
                } else {
                    findings.add(Severity::Warning, "walls-disagree", {}, culprit.place(culprit.points));
                }
            }
        }
    }
}

void checkGaps(const Level& level, const Walls& walls, Findings& findings) {
    const auto& ends = walls.ends.ends();
    for (std::size_t i = 0; i < ends.size() && !findings.isStopped(); ++i) {
        const WallEndPoint& own = ends[i];
        const std::vector<int> near = walls.ends.around(static_cast<int>(i), lint_limits::nearly);
        const auto distance = [&](int other) { return (ends[static_cast<std::size_t>(other)].at - own.at).norm(); };
        if (near.empty() || std::ranges::any_of(near, [&](int o) { return distance(o) <= lint_limits::together; })) {
            continue;
        }
        const int other = *std::ranges::min_element(near, {}, distance);
        const WallEndPoint& there = ends[static_cast<std::size_t>(other)];
        // Small levels have small gaps that are meant. A pair is told of once.
        const bool isSmall = distance(other) <= 0.5 * std::min(own.beside, there.beside);
        const bool isTaken = walls.ends.partner(other) >= 0;
        if (!isSmall || isTaken || other < static_cast<int>(i)) {
            continue;
        }
        const WallChain& chain = chainAt(walls, static_cast<int>(i));
        const WallChain& next = chainAt(walls, other);
        // The second mark is where the end could go; not so where the walls would be solid on different sides then.
        const bool fits = !chain.oneWay || !next.oneWay || own.isStart != there.isStart;
        FindingPlace place = chain.place(fits ? std::vector{own.at, there.at} : std::vector{own.at});
        place.path += "/vertices/" + std::to_string(own.isStart ? 0 : chain.vertices() - 1);
        const std::string millimetres = std::to_string(std::max(1L, std::lround(1000 * distance(other))));
        if (own.chain == there.chain) {
            findings.add(Severity::Warning, "chain-nearly-closed", {millimetres}, place);
        } else {
            std::vector<std::string> arguments = whichObject(level, level.objects[next.object], *next.body);
            arguments.push_back(millimetres);
            findings.add(Severity::Warning, "chain-gap", std::move(arguments), place);
        }
    }
}

} // namespace spacetow
