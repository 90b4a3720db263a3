#include "editor/editing/collisions.h"

#include "core/game/rules.h"

#include <algorithm>
#include <map>
#include <utility>

namespace spacetow {

namespace {

/// What decides whether two objects meet.
struct Sort {
    std::uint32_t tags = 0;
    std::uint32_t touches = 0;
    bool moves = false;
    bool isTangible = true;
    bool isWall = false; // of nothing but chains

    auto operator<=>(const Sort&) const = default;
};

bool isChain(const LevelShape& shape) {
    return std::holds_alternative<EdgeChain>(shape) || std::holds_alternative<LineChain>(shape);
}

std::optional<Sort> sortOf(const Object& object) {
    const std::optional<Filter> filter = filterOf(object);
    if (!filter) {
        return {};
    }
    Sort sort{filter->tags.bits, filter->touches.bits};
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        sort.moves = body->kind == BodyKind::Dynamic;
        sort.isTangible = body->tangible;
        sort.isWall = std::ranges::all_of(body->shapes, isChain);
    } else {
        const bool isFinish = std::holds_alternative<FinishObject>(object.data);
        sort.moves = !isFinish;
        sort.isTangible = !isFinish;
        sort.isWall = isFinish;
    }
    return sort;
}

bool meet(const Sort& a, const Sort& b) {
    const bool isAny = a.moves || b.moves || !a.isTangible || !b.isTangible;
    return isAny && !(a.isWall && b.isWall) && mayTouch({{a.tags}, {a.touches}}, {{b.tags}, {b.touches}});
}

/// Pairs of bodies that a connector keeps apart, both ways round, ascending.
std::vector<std::pair<Key, Key>> pairsKeptApart(const Level& level) {
    std::vector<std::pair<Key, Key>> pairs;
    for (const Object& object : level.objects) {
        const auto* connector = std::get_if<ConnectorObject>(&object.data);
        if (connector != nullptr && !connector->bodiesCollide) {
            pairs.emplace_back(connector->a, connector->b);
            pairs.emplace_back(connector->b, connector->a);
        }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

} // namespace

std::optional<Filter> filterOf(const Object& object) {
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        return body->filter;
    }
    if (std::holds_alternative<ShipObject>(object.data)) {
        return rules::shipFilter;
    }
    if (std::holds_alternative<PayloadObject>(object.data)) {
        return rules::payloadFilter;
    }
    return std::holds_alternative<FinishObject>(object.data) ? std::optional(rules::finishFilter) : std::nullopt;
}

std::vector<Key> keysTagged(const Level& level, int tag) {
    std::vector<Key> keys;
    for (const Object& object : level.objects) {
        const std::optional<Filter> filter = filterOf(object);
        if (filter && filter->tags.contains(tag)) {
            keys.push_back(object.key);
        }
    }
    std::ranges::sort(keys);
    return keys;
}

std::vector<Key> collidingWith(const Level& level, std::span<const Key> keys) {
    std::vector<Key> wanted(keys.begin(), keys.end());
    std::ranges::sort(wanted);
    std::map<Sort, int> selected;
    std::map<Key, Sort> selectedSorts;
    std::vector<std::pair<Key, Sort>> all;
    const std::vector<std::pair<Key, Key>> apart = pairsKeptApart(level);
    for (const Object& object : level.objects) {
        const std::optional<Sort> sort = sortOf(object);
        if (!sort) {
            continue;
        }
        all.emplace_back(object.key, *sort);
        if (std::ranges::binary_search(wanted, object.key)) {
            ++selected[*sort];
            if (!apart.empty()) {
                selectedSorts.emplace(object.key, *sort);
            }
        }
    }
    std::map<Sort, int> partners; // how many of the selected each sort meets
    std::vector<Key> result;
    for (const auto& [key, sort] : all) {
        const auto [known, isNew] = partners.try_emplace(sort, 0);
        if (isNew) {
            for (const auto& [other, count] : selected) {
                known->second += meet(sort, other) ? count : 0;
            }
        }
        int count = known->second;
        count -= meet(sort, sort) && std::ranges::binary_search(wanted, key) ? 1 : 0; // itself
        auto pair = std::ranges::lower_bound(apart, std::pair(key, Key(0)));
        for (; pair != apart.end() && pair->first == key; ++pair) {
            const auto other = selectedSorts.find(pair->second);
            count -= other != selectedSorts.end() && meet(sort, other->second) ? 1 : 0;
        }
        if (count > 0) {
            result.push_back(key);
        }
    }
    std::ranges::sort(result);
    return result;
}

} // namespace spacetow
