#include "tests/support/body_with.h"

namespace spacetow::test {

Object bodyWith(Key key, LevelShape shape, const Vec2& position) {
    BodyObject body;
    body.shapes.push_back(std::move(shape));
    body.position = position;
    Object object;
    object.key = key;
    object.data = std::move(body);
    return object;
}

} // namespace spacetow::test
