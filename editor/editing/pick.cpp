#include "editor/editing/pick.h"

#include "core/level/edits.h"
#include "editor/editing/outline.h"

#include <algorithm>
#include <tuple>

namespace spacetow {

namespace {

/// Things that move or are aimed for are picked before the walls behind them.
int rankOf(const Object& object) {
    if (std::holds_alternative<ShipObject>(object.data) || std::holds_alternative<PayloadObject>(object.data)) {
        return 0;
    }
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body && body->kind == BodyKind::Static ? 2 : 1;
}

/// Bounds that are quick to have, for leaving out what is far away; empty when only the outline can tell.
Aabb roughBounds(const Level& level, const Object& object) {
    return std::holds_alternative<ConnectorObject>(object.data) ? Aabb{} : boundsOf(level, object);
}

} // namespace

std::vector<Key> picked(const Level& level, const Vec2& point, double tolerance) {
    using Candidate = std::tuple<int, double, int, Key>; // rank, size, minus the place in the level
    std::vector<Candidate> candidates;
    const Outlines outlines(level);
    int index = 0;
    for (const Object& object : level.objects) {
        ++index;
        const Aabb rough = roughBounds(level, object);
        if (!rough.isEmpty() && !rough.grown(tolerance).contains(point)) {
            continue;
        }
        const Outline outline = outlines.of(object);
        if (distanceTo(outline, point) <= tolerance) {
            candidates.emplace_back(rankOf(object), boundsOf(outline).size().norm(), -index, object.key);
        }
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<Key> keys;
    keys.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
        keys.push_back(std::get<Key>(candidate));
    }
    return keys;
}

std::vector<Key> pickedIn(const Level& level, const Aabb& box, bool wholly) {
    std::vector<Key> keys;
    const Outlines outlines(level);
    for (const Object& object : level.objects) {
        const Aabb rough = roughBounds(level, object);
        if (!rough.isEmpty() && !rough.overlaps(box)) {
            continue;
        }
        if (!rough.isEmpty() && box.contains(rough)) {
            keys.push_back(object.key);
            continue;
        }
        const Outline outline = outlines.of(object);
        const Aabb exact = boundsOf(outline);
        if (wholly ? !exact.isEmpty() && box.contains(exact) : touches(outline, box)) {
            keys.push_back(object.key);
        }
    }
    return keys;
}

} // namespace spacetow
