#pragma once
// Position and rotation of a body: maps its local coordinates to the world's.

#include "core/math/rot.h"

namespace spacetow {

struct Transform {
    Vec2 position{0, 0};
    Rot rotation;

    Vec2 toWorld(const Vec2& local) const { return position + rotation * local; }
    Vec2 toLocal(const Vec2& world) const { return rotation.inverse() * (world - position); }
};

} // namespace spacetow
