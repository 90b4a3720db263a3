#pragma once
// A body that is held by the mouse: a damped spring from a point of the body to where the pointer is.
//
// It is the soft constraint of Box2D's mouse joint, as a force that is constant during an update. With h the length of
// the update, m the mass, ω and ζ the spring's angular frequency and damping ratio, r the lever of the anchor, C its
// way from the target and v its velocity as gravity will have changed it:
//   γ = 1 / (h (2 ζ ω + h ω²))          softness, per mass
//   K = 1 + γ + (m / I) [r⊥ r⊥ᵀ]        what an impulse at the anchor changes there, per mass
//   F = −(m / h) K⁻¹ (v + h ω² γ C)     the implicit step of the spring, which is stable for any mass and lever
// Beside it the rotation is damped, as a body that hangs from a point would swing for long.

#include "core/level/object_list.h"
#include "core/math/vec.h"
#include "core/physics/world/world.h"

#include <optional>

namespace spacetow {

struct Grab {
    Key object = 0;
    Vec2 anchor{0, 0}; // local to the body, m
    Vec2 target{0, 0}; // world, m

    bool operator==(const Grab&) const = default;
};

namespace grab {
constexpr double frequency = 5;      // Hz
constexpr double dampingRatio = 0.7; // of critical damping
constexpr double turnDamping = 5;    // 1/s
constexpr double longest = 100;      // m: a target that is further away pulls no harder
constexpr double strength = 10'000;  // m/s²: the force on a body at rest is at most this times its mass
} // namespace grab

/// What a grab did in an update.
struct GrabForce {
    BodyId body;
    Vec2 anchor{0, 0}; // world, before the update
    Vec2 target{0, 0};
    Vec2 force{0, 0}; // N
};

/// Applies the spring to the next update. Nothing happens, and nothing is returned, to a body that no force moves, or
/// when a number is not finite. A body that is faster than the force could stop soon is braked by up to a quarter of
/// its speed in an update.
std::optional<GrabForce> pull(World& world, BodyId body, const Grab& grab);

} // namespace spacetow
