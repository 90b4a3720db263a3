#include "tests/support/bodies.h"

namespace spacetow::test {

BodyDef edgeBody(const Vec2& a, const Vec2& b, double depth) {
    return {.kind = BodyKind::Static, .shapes = {Edge{a, b, depth}}};
}

BodyDef lineBody(const Vec2& a, const Vec2& b) {
    return {.kind = BodyKind::Static, .shapes = {Line{a, b}}};
}

BodyDef ball(const Vec2& at, double radius) {
    return {.shapes = {Circle{{0, 0}, radius}}, .position = at};
}

BodyDef box(const Vec2& at, double halfWidth, double halfHeight) {
    const Polygon shape{{Vec2(-halfWidth, -halfHeight), Vec2(halfWidth, -halfHeight), Vec2(halfWidth, halfHeight),
                         Vec2(-halfWidth, halfHeight)}};
    return {.shapes = {shape}, .position = at};
}

BodyId add(World& world, const BodyDef& def) {
    return world.addBody(def).value();
}

} // namespace spacetow::test
