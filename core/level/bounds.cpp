#include "core/level/bounds.h"

#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/object_geometry.h"

#include <array>

namespace spacetow {

Aabb boundsOf(const Level& level, const Object& object) {
    if (std::holds_alternative<GroupObject>(object.data)) {
        return boundsOf(level, std::array{object.key});
    }
    Aabb box = ownBounds(object.data);
    const auto* connector = std::get_if<ConnectorObject>(&object.data);
    if (const auto ends = connector == nullptr ? std::nullopt : endsOf(*connector, level.objects)) {
        box.include(ends->front());
        box.include(ends->back());
    }
    return box;
}

Aabb boundsOf(const Level& level, std::span<const Key> keys) {
    const LevelIndex& index = levelIndex(level);
    Aabb box;
    for (const int place : level.objects.indicesOf(withMembers(level, keys))) {
        box.include(index.boundsOf(place));
    }
    return box;
}

Aabb boundsOf(const Level& level) {
    return levelIndex(level).bounds();
}

} // namespace spacetow
