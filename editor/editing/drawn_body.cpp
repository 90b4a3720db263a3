#include "editor/editing/drawn_body.h"

#include "core/level/edits.h"

#include <utility>

namespace spacetow {

Edit withDrawnBody(const ToolContext& context, LevelShape shape, const Vec2& position) {
    BodyObject body;
    body.kind = BodyKind::Static;
    body.shapes.push_back(std::move(shape));
    body.position = position;
    body.filter.tags = TagMask::bit(wallTag);
    Object object;
    object.key = freshKey(*context.edit.level, context.seed);
    object.data = std::move(body);
    const Key key = object.key;
    return {std::make_shared<const Level>(added(*context.edit.level, std::move(object))), Selection({key})};
}

} // namespace spacetow
