#include "core/game/payload.h"

#include "core/game/rules.h"
#include "core/game/ship.h"

namespace spacetow {

BodyDef payloadBody(const PayloadObject& object) {
    BodyDef def;
    def.shapes = {Circle{Vec2(0, 0), object.radius}};
    def.position = object.position;
    def.mass = object.mass;
    def.restitution = object.restitution;
    def.linearDamping = object.linearDamping;
    def.filter = rules::payloadFilter;
    def.positionFrozen = true;
    def.rotationFrozen = true;
    def.reportsTouches = true;
    return def;
}

ConnectorDef towRope(BodyId ship, BodyId payload, const RopeRules& rope) {
    ConnectorDef def;
    def.a = ship;
    def.b = payload;
    def.anchorA = shipNotch();
    def.stiffness = rope.stiffness;
    def.damping = rope.damping;
    def.truncation.rule = rope.truncation;
    def.truncation.limit = rope.limit;
    def.truncation.proportion = rope.proportion;
    return def;
}

BodyDef finishBody(const FinishObject& object) {
    BodyDef def;
    def.kind = BodyKind::Static;
    const Vec2 span = object.b - object.a;
    def.shapes = {Line{Vec2(0, 0), span}};
    def.position = object.a;
    def.filter = rules::finishFilter;
    def.tangible = false;
    return def;
}

} // namespace spacetow
