#include "editor/editing/lasso_gesture.h"

#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/outline.h"
#include "editor/editing/group_picking.h"

#include <algorithm>

namespace spacetow {

namespace {

/// Calls `visit(a, b)` for each segment until it answers true; whether it did.
template <class Visit>
bool anySegment(std::span<const Vec2> points, bool closed, Visit visit) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (visit(points[i - 1], points[i])) {
            return true;
        }
    }
    return closed && points.size() > 1 && visit(points.back(), points.front());
}

bool crosses(std::span<const Vec2> line, const Vec2& a, const Vec2& b) {
    return anySegment(line, true, [&](const Vec2& c, const Vec2& d) { return segmentsMeet(a, b, c, d); });
}

bool touches(const Outline& outline, std::span<const Vec2> line) {
    for (const OutlinePath& path : outline.paths) {
        if (contains(line, path.points.front()) || (path.filled && contains(path.points, line.front())) ||
            anySegment(path.points, path.closed, [&](const Vec2& a, const Vec2& b) { return crosses(line, a, b); })) {
            return true;
        }
    }
    return std::ranges::any_of(outline.discs, [&](const Circle& disc) {
        return contains(line, disc.center) || anySegment(line, true, [&](const Vec2& a, const Vec2& b) {
                   return (closestOnSegment(a, b, disc.center) - disc.center).norm() <= disc.radius;
               });
    });
}

bool encloses(std::span<const Vec2> line, const Outline& outline) {
    const bool crossed = std::ranges::any_of(outline.paths, [&](const OutlinePath& path) {
        return !contains(line, path.points.front()) ||
               anySegment(path.points, path.closed, [&](const Vec2& a, const Vec2& b) { return crosses(line, a, b); });
    });
    return !crossed && std::ranges::all_of(outline.discs, [&](const Circle& disc) {
        return contains(line, disc.center) && !anySegment(line, true, [&](const Vec2& a, const Vec2& b) {
                   return (closestOnSegment(a, b, disc.center) - disc.center).norm() < disc.radius;
               });
    });
}

} // namespace

std::vector<Key> pickedInLasso(const Level& level, std::span<const Vec2> line, bool wholly) {
    std::vector<Key> keys;
    if (line.size() < 3) {
        return keys;
    }
    Aabb around;
    for (const Vec2& point : line) {
        around.include(point);
    }
    const GroupTree tree(level);
    const Outlines outlines(level);
    levelIndex(level).visitObjects(around, [&](int place) {
        const Object& object = level.objects[place];
        if (tree.isVisible(object) && !tree.isLocked(object)) {
            const Outline outline = outlines.of(object);
            const bool seen = !outline.paths.empty() || !outline.discs.empty();
            if (seen && (wholly ? encloses(line, outline) : touches(outline, line))) {
                keys.push_back(object.key);
            }
        }
    });
    return keys;
}

Edit LassoGesture::at(const Pointer& pointer) const {
    const Selection& before = edit().selection;
    std::vector<Key> keys = membersOf(edit(), pickedInLasso(*edit().level, lineAt(pointer), pointer.modifiers.ctrl));
    keys.insert(keys.end(), before.keys().begin(), before.keys().end());
    return {edit().level, Selection(std::move(keys)).entering(before.entered())};
}

Hint LassoGesture::hint(const Pointer& pointer) const {
    return {"select.lasso", {std::to_string(at(pointer).selection.size())}};
}

} // namespace spacetow
