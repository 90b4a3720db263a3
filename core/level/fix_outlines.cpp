// Polygons that cross themselves are untangled.
#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"
#include "core/level/fix_edits.h"
#include "core/level/nodes.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

/// Two sides, i before j and no neighbours, that meet; nothing when there are none.
std::optional<std::pair<std::ptrdiff_t, std::ptrdiff_t>> crossingOf(const std::vector<Vec2>& v) {
    const std::ptrdiff_t count = std::ssize(v);
    const auto at = [&](std::ptrdiff_t i) -> const Vec2& { return v[static_cast<std::size_t>(i % count)]; };
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        for (std::ptrdiff_t j = i + 2; j < count - (i == 0 ? 1 : 0); ++j) {
            if (segmentsMeet(at(i), at(i + 1), at(j), at(j + 1))) {
                return std::pair(i, j);
            }
        }
    }
    return {};
}

/// A corner at which the outline runs back over itself; −1 for none.
std::ptrdiff_t spikeOf(const std::vector<Vec2>& v) {
    const std::ptrdiff_t count = std::ssize(v);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const auto at = [&](std::ptrdiff_t k) -> const Vec2& {
            return v[static_cast<std::size_t>((k + count) % count)];
        };
        const Vec2 arriving = at(i) - at(i - 1);
        const Vec2 leaving = at(i + 1) - at(i);
        if (cross(arriving, leaving) == 0 && arriving.dot(leaving) <= 0) {
            return i;
        }
    }
    return -1;
}

/// The way between two crossing sides is gone the other way round, which makes it shorter, until none cross. False when
/// that does not end well.
bool untangle(std::vector<Vec2>& v) {
    constexpr int mostTurns = 300;
    for (int turn = 0; turn < mostTurns && v.size() >= 3; ++turn) {
        if (isSimple(v)) {
            return true;
        }
        if (const std::ptrdiff_t spike = spikeOf(v); spike >= 0) {
            v.erase(v.begin() + spike);
        } else if (const auto crossing = crossingOf(v)) {
            std::reverse(v.begin() + crossing->first + 1, v.begin() + crossing->second + 1);
        } else {
            return false;
        }
    }
    return false;
}

} // namespace

Level untangled(Level level, Key key) {
    const int index = level.objects.indexOf(key);
    if (index < 0) {
        return level;
    }
    Object object = level.objects[index];
    auto* body = std::get_if<BodyObject>(&object.data);
    bool isChanged = false;
    for (std::size_t i = 0; body != nullptr && i < body->shapes.size(); ++i) {
        const auto* polygon = std::get_if<Polygon>(&std::as_const(body->shapes)[i]);
        if (polygon == nullptr || isSimple(polygon->vertices)) {
            continue;
        }
        std::vector<Vec2> vertices = polygon->vertices;
        if (untangle(vertices)) {
            if (signedArea(vertices) < 0) {
                std::ranges::reverse(vertices);
            }
            body->shapes[i] = Polygon{std::move(vertices)};
            isChanged = true;
        }
    }
    if (isChanged) {
        level.objects.replace(index, std::move(object));
    }
    return level;
}

} // namespace spacetow
