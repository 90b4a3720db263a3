// Whether ship, payload and finish are in the same cave. Caves that do not close are left to the search for leaks.
#include "core/geometry/polygon.h"
#include "core/level/lint_walls.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

struct Loop {
    std::vector<Vec2> outline;
    double area = 0; // m², positive when its inside is free
    Aabb box;
};

void addLoop(std::vector<Loop>& loops, std::vector<Vec2> outline) {
    Loop loop{std::move(outline), 0, {}};
    loop.area = signedArea(loop.outline);
    for (const Vec2& point : loop.outline) {
        loop.box.include(point);
    }
    if (loop.outline.size() > 2 && loop.area != 0) {
        loops.push_back(std::move(loop));
    }
}

/// What closes in still one-way walls that ship and payload feel, of one chain or of several that go on from each
/// other.
std::vector<Loop> loopsOf(const Walls& walls) {
    std::vector<Loop> loops;
    const auto isPart = [&](int chain) {
        const WallChain& c = walls.chains[static_cast<std::size_t>(chain)];
        return c.oneWay && c.isStill() && c.isWall();
    };
    for (std::size_t i = 0; i < walls.chains.size(); ++i) {
        if (walls.chains[i].closed && isPart(static_cast<int>(i))) {
            addLoop(loops, walls.chains[i].points);
        }
    }
    const auto& ends = walls.ends.ends();
    std::vector<bool> seen(walls.chains.size(), false);
    for (std::size_t first = 0; first < ends.size(); first += 2) {
        std::vector<Vec2> outline;
        int end = static_cast<int>(first) + 1; // of the chain whose start is `first`
        while (true) {
            const int chain = ends[static_cast<std::size_t>(end)].chain;
            const auto at = static_cast<std::size_t>(chain);
            if (seen[at] || !isPart(chain)) {
                break;
            }
            seen[at] = true;
            outline.insert(outline.end(), walls.chains[at].points.begin(), walls.chains[at].points.end() - 1);
            const int next = walls.ends.partner(end);
            if (next < 0 || !ends[static_cast<std::size_t>(next)].isStart) {
                break;
            }
            if (next == static_cast<int>(first)) {
                addLoop(loops, std::move(outline));
                break;
            }
            end = WallEnds::opposite(next);
        }
    }
    return loops;
}

/// The smallest loop round the point when its inside is free, else null: then it is in the open or in a rock.
const Loop* caveAt(const std::vector<Loop>& loops, const Vec2& point) {
    const Loop* smallest = nullptr;
    for (const Loop& loop : loops) {
        if (loop.box.contains(point) && (smallest == nullptr || std::abs(loop.area) < std::abs(smallest->area)) &&
            contains(loop.outline, point)) {
            smallest = &loop;
        }
    }
    return smallest != nullptr && smallest->area > 0 ? smallest : nullptr;
}

template <class T>
std::optional<std::pair<int, T>> onlyOne(const Level& level, const Findings& findings) {
    int index = -1;
    for (const Object& object : level.objects) {
        ++index;
        if (const auto* data = std::get_if<T>(&object.data)) {
            return findings.isBad(index) ? std::nullopt : std::optional(std::pair(index, *data));
        }
    }
    return {};
}

} // namespace

void checkCaves(const Level& level, const Walls& walls, Findings& findings) {
    const auto ship = onlyOne<ShipObject>(level, findings);
    const auto payload = onlyOne<PayloadObject>(level, findings);
    const auto finish = onlyOne<FinishObject>(level, findings);
    if (!ship || (!payload && !finish)) {
        return;
    }
    const std::vector<Loop> loops = loopsOf(walls);
    if (std::ranges::none_of(loops, [](const Loop& loop) { return loop.area > 0; })) {
        return;
    }
    const auto placeOf = [&level](int index, std::vector<Vec2> marks) {
        return FindingPlace{index, level.objects[index].key, {}, std::move(marks)};
    };
    const Loop* const cave = caveAt(loops, ship->second.position);
    const Loop* const beside = payload ? caveAt(loops, payload->second.position) : nullptr;
    if (cave == nullptr) {
        // Out there, one may fly in through the backs of walls; but who puts everything else inside has erred.
        if (beside != nullptr) {
            findings.add(Severity::Warning, "ship-outside", {}, placeOf(ship->first, {ship->second.position}));
        }
        return;
    }
    if (payload && beside != cave) {
        findings.add(Severity::Error, "payload-outside", {}, placeOf(payload->first, {payload->second.position}));
    }
    if (finish) {
        constexpr int samples = 16;
        const Vec2 along = finish->second.b - finish->second.a;
        bool inside = false;
        for (int i = 0; i <= samples && !inside; ++i) {
            inside = caveAt(loops, finish->second.a + double(i) / samples * along) == cave;
        }
        if (!inside) {
            findings.add(Severity::Error, "finish-outside", {},
                         placeOf(finish->first, {finish->second.a, finish->second.b}));
        }
    }
}

} // namespace spacetow
