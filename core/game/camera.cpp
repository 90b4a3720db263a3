#include "core/game/camera.h"

#include "core/math/trig.h"

namespace spacetow {

void Camera::snapTo(const Vec2& target) {
    if (isFinite(target)) {
        m_position = target;
    }
}

void Camera::follow(const Vec2& target, double seconds) {
    const Vec2 gap = target - m_position;
    const double distance = std::hypot(gap.x(), gap.y());
    if (!std::isfinite(distance) || distance <= freeRadius) {
        return;
    }
    const double left = freeRadius + (distance - freeRadius) * expExact(-rate * seconds);
    m_position = target - gap * (left / distance);
}

} // namespace spacetow
