#include "core/game/grab.h"

#include <cmath>
#include <numbers>

namespace spacetow {
namespace {

Vec2 withinLength(const Vec2& v, double longest) {
    const double length = std::sqrt(v.squaredNorm());
    return length > longest ? Vec2(v * (longest / length)) : v;
}

/// K⁻¹ v; K is symmetric and at least γ in every direction.
Vec2 solved(double xx, double xy, double yy, const Vec2& v) {
    const double determinant = xx * yy - xy * xy;
    return {(yy * v.x() - xy * v.y()) / determinant, (xx * v.y() - xy * v.x()) / determinant};
}

/// Where the spring is fixed to the body: in m and m/s, lever from the centre of mass, stretch from the target.
struct Anchor {
    Vec2 lever;
    Vec2 velocity;
    Vec2 stretch;
};

/// m/s²; h is one update, in s.
Vec2 springAcceleration(const BodyState& state, const Anchor& anchor, double h) {
    const Vec2& lever = anchor.lever;
    constexpr double omega = 2 * std::numbers::pi * grab::frequency;
    const double softness = 1 / (h * (2 * grab::dampingRatio * omega + h * omega * omega));
    const double linear = (state.positionFrozen ? 0 : 1) + softness;
    const double turning = state.rotationFrozen ? 0 : state.mass / state.inertia;
    const double xx = linear + turning * lever.y() * lever.y();
    const double xy = -turning * lever.x() * lever.y();
    const double yy = linear + turning * lever.x() * lever.x();
    const Vec2 wanted = anchor.velocity + h * omega * omega * softness * anchor.stretch;
    return solved(xx, xy, yy, wanted) / -h;
}

} // namespace

std::optional<GrabForce> pull(World& world, BodyId body, const Grab& grab) {
    if (!world.contains(body) || !isFinite(grab.anchor) || !isFinite(grab.target)) {
        return {};
    }
    const BodyState state = world.body(body);
    const bool movable = !(state.positionFrozen && state.rotationFrozen);
    if (state.kind != BodyKind::Dynamic || !state.active || !movable) {
        return {};
    }
    const double h = world.parameters().seconds;
    const Vec2 anchor = state.pose.toWorld(grab.anchor);
    const Vec2 lever = anchor - state.massCenter;
    const Vec2 gravity = state.positionFrozen ? Vec2(0, 0) : world.parameters().gravity;
    const Vec2 turning(-state.angularVelocity * lever.y(), state.angularVelocity * lever.x());
    const Vec2 velocity = state.velocity + turning + h * gravity;
    const Vec2 stretch = withinLength(anchor - grab.target, grab::longest);
    const double strongest = grab::strength + std::sqrt(state.velocity.squaredNorm()) / (4 * h);
    const Vec2 acceleration = withinLength(springAcceleration(state, {lever, velocity, stretch}, h), strongest);
    const Vec2 force = state.mass * acceleration;
    const double torque = -state.inertia * state.angularVelocity * grab::turnDamping / (1 + h * grab::turnDamping);
    if (!isFinite(force) || !std::isfinite(torque) || !world.applyForceAt(body, force, anchor)) {
        return {};
    }
    world.applyTorque(body, torque);
    return GrabForce{body, anchor, grab.target, force};
}

} // namespace spacetow
