#include "editor/editing/drawn_body.h"

#include "core/geometry/polygon.h"
#include "core/level/edits.h"
#include "core/math/affine.h"

#include <algorithm>
#include <utility>

namespace spacetow {

Edit withDrawnBody(const ToolContext& context, LevelShape shape, const Vec2& position, BodyKind kind) {
    BodyObject body;
    body.kind = kind;
    body.shapes.push_back(std::move(shape));
    body.position = position;
    body.filter.tags = TagMask::bit(wallTag);
    Object object;
    object.key = freshKey(*context.edit.level, context.seed);
    object.data = std::move(body);
    const Key key = object.key;
    return {std::make_shared<const Level>(added(*context.edit.level, std::move(object))), Selection({key})};
}

Edit withDrawnPolygon(const ToolContext& context, std::vector<Vec2> outline, BodyKind kind) {
    Aabb box;
    for (const Vec2& point : outline) {
        box.include(point);
    }
    const Vec2 middle = tidied(box.center());
    const Vec2 position = kind == BodyKind::Kinematic ? middle : onGridWithin(context.snap, box, middle);
    if (signedArea(outline) < 0) {
        std::reverse(outline.begin() + 1, outline.end());
    }
    for (Vec2& point : outline) {
        point = tidied(Vec2(point - position));
    }
    return withDrawnBody(context, Polygon{std::move(outline)}, position, kind);
}

} // namespace spacetow
