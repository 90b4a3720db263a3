#pragma once
// The camera that follows what matters. Inside a small radius the target moves freely; beyond it the excess shrinks
// exponentially, so that no jump, however far, is overshot, and the path depends on time and not on how it is cut
// into frames. World metres, seconds.

#include "core/math/vec.h"

namespace spacetow {

class Camera {
  public:
    static constexpr double freeRadius = 1.0416667; // m, a sixteenth of the classic view's diagonal
    static constexpr double rate = 5.268;           // 1/s; leaves nine tenths of the excess after 20 ms

    explicit Camera(const Vec2& position = Vec2(0, 0)) : m_position(position) {}

    const Vec2& position() const { return m_position; }
    void snapTo(const Vec2& target);
    /// Moves towards the target for `seconds` ≥ 0. A target that is not finite is ignored.
    void follow(const Vec2& target, double seconds);

  private:
    Vec2 m_position;
};

} // namespace spacetow
