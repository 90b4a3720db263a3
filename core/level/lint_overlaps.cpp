// What is there twice: walls that lie on each other, and whole objects.
#include "core/level/lint_overlaps.h"

#include "core/level/bounds.h"
#include "core/level/lint_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace spacetow {

namespace {

/// A segment by its rounded ends, and by what else must be the same for two to do the same.
struct SegmentMark {
    std::array<std::int64_t, 4> ends{};
    std::array<std::uint32_t, 2> filter{};
    std::array<double, 3> surface{}; // restitution, friction, depth
    int party = 0;                   // what moves together; −1 for all that stands still
    bool oneWay = false;

    auto operator<=>(const SegmentMark&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
};

struct MarkedSegment {
    SegmentMark mark;
    int chain = 0;
    int segment = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
    auto operator<=>(const MarkedSegment&) const = default;
};

std::int64_t rounded(double value) {
    return std::llround(value / lint_limits::together);
}

SegmentMark markOf(const WallChain& chain, int segment) {
    const Vec2& a = chain.start(segment);
    const Vec2& b = chain.end(segment);
    SegmentMark mark{{rounded(a.x()), rounded(a.y()), rounded(b.x()), rounded(b.y())},
                     {chain.body->filter.tags.bits, chain.body->filter.touches.bits},
                     {chain.body->restitution, chain.body->friction, chain.depth},
                     chain.isStill() ? -1 : chain.object,
                     chain.oneWay};
    // Two-sided walls may run either way.
    if (!chain.oneWay && std::pair(mark.ends[2], mark.ends[3]) < std::pair(mark.ends[0], mark.ends[1])) {
        mark.ends = {mark.ends[2], mark.ends[3], mark.ends[0], mark.ends[1]};
    }
    return mark;
}

/// Alike to the eye, and so likely the same: what `==` is to be asked for.
std::array<double, 4> tellTale(const BodyObject& body) {
    std::array<double, 4> tale{body.position.x(), body.position.y(), body.angle, 0};
    for (const LevelShape& shape : body.shapes) {
        if (const auto* circle = std::get_if<Circle>(&shape)) {
            tale[3] += circle->radius + circle->center.x() + 2 * circle->center.y();
        } else if (const auto* polygon = std::get_if<Polygon>(&shape)) {
            for (const Vec2& vertex : polygon->vertices) {
                tale[3] += vertex.x() + 2 * vertex.y();
            }
        }
    }
    return tale;
}

bool isAllWalls(const BodyObject& body) {
    return std::ranges::all_of(body.shapes, [](const LevelShape& shape) {
        return std::holds_alternative<EdgeChain>(shape) || std::holds_alternative<LineChain>(shape);
    });
}

} // namespace

std::vector<WallOverlap> wallOverlaps(const std::vector<WallChain>& chains) {
    std::vector<MarkedSegment> all;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        for (int s = 0; s < chains[i].segments(); ++s) {
            all.push_back({markOf(chains[i], s), static_cast<int>(i), s});
        }
    }
    std::ranges::sort(all);
    std::map<std::pair<int, int>, std::vector<int>> found; // chain and the one it lies on
    for (std::size_t first = 0; first < all.size();) {
        std::size_t next = first + 1;
        for (; next < all.size() && all[next].mark == all[first].mark; ++next) {
            found[{all[next].chain, all[first].chain}].push_back(all[next].segment);
        }
        first = next;
    }
    std::vector<WallOverlap> overlaps;
    for (auto& [pair, segments] : found) {
        std::ranges::sort(segments);
        overlaps.push_back({pair.first, pair.second, std::move(segments)});
    }
    return overlaps;
}

void checkOverlaps(const Level& level, const Walls& walls, Findings& findings) {
    for (const WallOverlap& overlap : wallOverlaps(walls.chains)) {
        const WallChain& chain = walls.chains[static_cast<std::size_t>(overlap.chain)];
        const WallChain& under = walls.chains[static_cast<std::size_t>(overlap.under)];
        const int first = overlap.segments.front();
        const FindingPlace place = chain.place({chain.start(first), chain.end(first)});
        const std::string count = std::to_string(overlap.segments.size());
        if (overlap.chain == overlap.under) {
            findings.add(Severity::Warning, "walls-overlap-themselves", {count}, place);
            continue;
        }
        std::vector<std::string> arguments = whichObject(level, level.objects[under.object], *under.body);
        if (std::ssize(overlap.segments) == chain.segments()) {
            findings.add(Severity::Warning, "wall-twice", std::move(arguments), place);
        } else {
            arguments.push_back(count);
            findings.add(Severity::Warning, "walls-overlap", std::move(arguments), place);
        }
    }
}

void checkTwins(const Level& level, Findings& findings) {
    std::vector<std::pair<std::array<double, 4>, int>> tales;
    int place = -1;
    for (const Object& object : level.objects) {
        ++place;
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body != nullptr && !findings.isBad(place) && !isAllWalls(*body)) {
            tales.emplace_back(tellTale(*body), place);
        }
    }
    std::ranges::sort(tales);
    for (std::size_t i = 1, first = 0; i < tales.size(); ++i) {
        if (tales[i].first != tales[first].first) {
            first = i;
            continue;
        }
        const Object& original = level.objects[tales[first].second];
        const Object& object = level.objects[tales[i].second];
        const auto& body = std::get<BodyObject>(original.data);
        if (original.data == object.data) {
            findings.add(Severity::Warning, "object-twice", whichObject(level, original, body),
                         {tales[i].second, object.key, {}});
        }
    }
}

} // namespace spacetow
