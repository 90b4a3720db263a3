#include "core/geometry/convex_parts.h"
#include "tests/bench/engines.h"
#include "tests/bench/stopwatch.h"

#include <box2d/box2d.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace spacetow::bench {

namespace {

b2Vec2 toBox2d(const Vec2& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y())};
}

void addPart(b2Body* body, b2FixtureDef fixture, const Part& part) {
    b2CircleShape circle;
    b2EdgeShape edge;
    b2PolygonShape polygon;
    if (const auto* c = std::get_if<Circle>(&part)) {
        circle.m_p = toBox2d(c->center);
        circle.m_radius = static_cast<float>(c->radius);
        fixture.shape = &circle;
    } else if (const auto* wall = std::get_if<WallPart>(&part)) {
        edge.SetTwoSided(toBox2d(wall->a), toBox2d(wall->b));
        fixture.shape = &edge;
    } else {
        const ConvexPart& convex = std::get<ConvexPart>(part);
        b2Vec2 corners[ConvexPart::maxCorners];
        for (int i = 0; i < convex.count; ++i) {
            corners[i] = toBox2d(convex.corners[static_cast<std::size_t>(i)]);
        }
        polygon.Set(corners, convex.count);
        fixture.shape = &polygon;
    }
    body->CreateFixture(&fixture);
}

b2Body* addBody(b2World& world, const BodyDef& def) {
    b2BodyDef body;
    body.type = def.kind == BodyKind::Static      ? b2_staticBody
                : def.kind == BodyKind::Kinematic ? b2_kinematicBody
                                                  : b2_dynamicBody;
    body.position = toBox2d(def.position);
    body.angularVelocity = static_cast<float>(def.angularVelocity);
    body.allowSleep = false;
    b2Body* result = world.CreateBody(&body);
    b2FixtureDef fixture;
    fixture.density = static_cast<float>(def.density);
    fixture.friction = static_cast<float>(def.friction);
    for (const Shape& shape : def.shapes) {
        for (const Part& part : partsOf(shape)) {
            addPart(result, fixture, part);
        }
    }
    if (def.mass) {
        b2MassData data;
        result->GetMassData(&data);
        const float factor = static_cast<float>(*def.mass) / data.mass;
        data.mass *= factor;
        data.I *= factor;
        result->SetMassData(&data);
    }
    return result;
}

void build(b2World& world, const Scene& scene) {
    std::vector<b2Body*> bodies;
    for (const BodyDef& def : scene.bodies) {
        bodies.push_back(addBody(world, def));
    }
    for (const Joint& joint : scene.joints) {
        b2Body* a = bodies[joint.a];
        b2Body* b = bodies[joint.b];
        b2DistanceJointDef def;
        def.Initialize(a, b, a->GetWorldPoint(toBox2d(joint.connector.anchorA)),
                       b->GetWorldPoint(toBox2d(joint.connector.anchorB)));
        def.minLength = 0;
        def.maxLength = b2_maxFloat;
        def.stiffness = static_cast<float>(joint.connector.stiffness);
        def.damping = static_cast<float>(joint.connector.damping);
        world.CreateJoint(&def);
    }
}

Outcome outcomeOf(const b2World& world) {
    Outcome outcome;
    int count = 0;
    outcome.minY = std::numeric_limits<double>::infinity();
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (body->GetType() == b2_dynamicBody) {
            ++count;
            const double y = body->GetPosition().y;
            const double spin = body->GetAngularVelocity();
            outcome.minY = std::min(outcome.minY, y);
            outcome.meanY += y;
            outcome.kinetic += 0.5 * body->GetMass() * body->GetLinearVelocity().LengthSquared() +
                               0.5 * body->GetInertia() * spin * spin;
        }
    }
    outcome.meanY /= std::max(count, 1);
    return outcome;
}

} // namespace

Engine box2dEngine(const Scene& scene) {
    constexpr int velocityIterations = 8; // as its manual suggests
    constexpr int positionIterations = 3;
    Engine engine{.name = "box2d"};
    const auto world = std::make_shared<b2World>(toBox2d(scene.parameters.gravity));
    world->SetAllowSleeping(false);
    engine.buildMs = milliseconds([&] { build(*world, scene); });
    const auto step = static_cast<float>(scene.parameters.seconds / scene.referenceSteps);
    engine.update = [world, step, steps = scene.referenceSteps] {
        for (int k = 0; k < steps; ++k) {
            world->Step(step, velocityIterations, positionIterations);
        }
    };
    engine.outcome = [world] { return outcomeOf(*world); };
    return engine;
}

} // namespace spacetow::bench
