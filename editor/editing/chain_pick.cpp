#include "editor/editing/chain_pick.h"

#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/nodes.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace spacetow {

namespace {

constexpr double chainEndPixels = 8;

struct EndInReach {
    ChainEnd end;
    int object = 0;
    double distance = 0; // m
};

/// Which end of an open chain of the kind the vertex is.
std::optional<ChainEnd> endOf(const Object& object, const VertexRef& ref, ChainKind kind) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    if (body == nullptr) {
        return {};
    }
    const LevelShape& shape = body->shapes[static_cast<std::size_t>(ref.shape)];
    const bool fits =
        kind == ChainKind::Edges ? std::holds_alternative<EdgeChain>(shape) : std::holds_alternative<LineChain>(shape);
    const std::vector<Vec2>* vertices = verticesOf(shape);
    const bool last = vertices != nullptr && ref.vertex + 1 == static_cast<int>(vertices->size());
    if (!fits || isClosed(shape) || (ref.vertex != 0 && !last)) {
        return {};
    }
    return ChainEnd{object.key, ref.shape, ref.vertex == 0};
}

} // namespace

std::optional<ChainEnd> chainEndAt(const Edit& edit, const Pointer& pointer, ChainKind kind) {
    const Level& level = *edit.level;
    const double reach = chainEndPixels * pointer.pixel;
    std::vector<EndInReach> ends;
    levelIndex(level).visitVertices(Aabb{pointer.world, pointer.world}.grown(reach),
                                    [&](const VertexRef& ref, const Vec2& at) {
                                        const double distance = (at - pointer.world).norm();
                                        const auto end = endOf(level.objects[ref.object], ref, kind);
                                        if (end && distance <= reach) {
                                            ends.push_back({*end, ref.object, distance});
                                        }
                                    });
    if (!ends.empty()) {
        const GroupTree tree(level);
        std::erase_if(ends, [&](const EndInReach& end) {
            const Object& object = level.objects[end.object];
            return !tree.isVisible(object) || tree.isLocked(object) || !openChain(level, end.end);
        });
    }
    const auto nearest = std::ranges::min_element(ends, {}, [&](const EndInReach& end) {
        return std::tuple(end.distance, !edit.selection.contains(end.end.key), -end.object);
    });
    return nearest == ends.end() ? std::nullopt : std::optional(nearest->end);
}

} // namespace spacetow
