#include "core/game/ship.h"

#include "core/game/rules.h"

namespace spacetow {

Polygon shipHull() {
    // An arrowhead 0.4 m long and wide with a notch in its stern, moved so that its centroid is the origin.
    const double rise = 0.1 / 3;
    return {{{0, 0.2 + rise}, {-0.2, -0.2 + rise}, {0, -0.1 + rise}, {0.2, -0.2 + rise}}};
}

Vec2 shipNotch() {
    return shipHull().vertices[2];
}

BodyDef shipBody(const Vec2& position, double angle, const Rules& rules) {
    BodyDef def;
    def.shapes = {shipHull()};
    def.position = position;
    def.angle = angle;
    def.mass = rules.shipMass;
    def.restitution = rules.shipRestitution;
    def.linearDamping = rules.shipLinearDamping;
    def.angularDamping = rules.shipAngularDamping;
    def.filter = spacetow::rules::shipFilter;
    def.reportsTouches = true;
    return def;
}

void steer(World& world, BodyId ship, const Controls& controls, const Rules& rules) {
    const BodyState state = world.body(ship);
    if (controls.left != controls.right) {
        const double side = controls.left ? 1 : -1;
        world.applyTorque(ship, side * rules.steering * state.inertia);
    }
    if (controls.thrust) {
        const Vec2 push = rules.thrust * state.pose.rotation.up();
        world.applyForce(ship, push);
    }
}

} // namespace spacetow
