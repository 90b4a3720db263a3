#include "core/geometry/convex_parts.h"
#include "core/geometry/mass.h"
#include "tests/bench/engines.h"
#include "tests/bench/stopwatch.h"

#include <chipmunk/chipmunk.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <memory>

namespace spacetow::bench {

namespace {

cpVect toChipmunk(const Vec2& v) {
    return cpv(v.x(), v.y());
}

struct SpaceDeleter {
    void operator()(cpSpace* space) const {
        cpSpaceEachConstraint(
            space,
            [](cpConstraint* constraint, void* data) {
                static_cast<std::vector<cpConstraint*>*>(data)->push_back(constraint);
            },
            &constraints);
        cpSpaceEachShape(
            space, [](cpShape* shape, void* data) { static_cast<std::vector<cpShape*>*>(data)->push_back(shape); },
            &shapes);
        cpSpaceEachBody(
            space, [](cpBody* body, void* data) { static_cast<std::vector<cpBody*>*>(data)->push_back(body); },
            &bodies);
        std::for_each(constraints.begin(), constraints.end(), cpConstraintFree);
        std::for_each(shapes.begin(), shapes.end(), cpShapeFree);
        std::for_each(bodies.begin(), bodies.end(), cpBodyFree);
        cpSpaceFree(space);
    }

    mutable std::vector<cpConstraint*> constraints;
    mutable std::vector<cpShape*> shapes;
    mutable std::vector<cpBody*> bodies;
};

using SpacePointer = std::shared_ptr<cpSpace>;

/// Debian's build greets on the standard output, which is for results; it has nothing else to say there.
SpacePointer quietSpace() {
    std::fflush(stdout);
    const int output = dup(STDOUT_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    SpacePointer space(cpSpaceNew(), SpaceDeleter{});
    std::fflush(stdout);
    dup2(output, STDOUT_FILENO);
    close(nowhere);
    close(output);
    return space;
}

cpShape* chipmunkShape(cpBody* body, const Part& part) {
    if (const auto* circle = std::get_if<Circle>(&part)) {
        return cpCircleShapeNew(body, circle->radius, toChipmunk(circle->center));
    }
    if (const auto* wall = std::get_if<WallPart>(&part)) {
        return cpSegmentShapeNew(body, toChipmunk(wall->a), toChipmunk(wall->b), 0);
    }
    const ConvexPart& convex = std::get<ConvexPart>(part);
    std::array<cpVect, ConvexPart::maxCorners> corners;
    std::transform(convex.corners.begin(), convex.corners.begin() + convex.count, corners.begin(), toChipmunk);
    return cpPolyShapeNewRaw(body, convex.count, corners.data(), 0);
}

cpBody* chipmunkBody(const BodyDef& def) {
    if (def.kind == BodyKind::Static) {
        return cpBodyNewStatic();
    }
    if (def.kind == BodyKind::Kinematic) {
        cpBody* body = cpBodyNewKinematic();
        cpBodySetAngularVelocity(body, def.angularVelocity);
        return body;
    }
    MassProperties own = massOf(def.shapes.front(), def.density);
    if (def.mass) {
        own.inertia *= *def.mass / own.mass;
        own.mass = *def.mass;
    }
    cpBody* body = cpBodyNew(own.mass, own.inertia);
    cpBodySetCenterOfGravity(body, toChipmunk(own.center));
    return body;
}

void build(cpSpace* space, const Scene& scene) {
    std::vector<cpBody*> bodies;
    for (const BodyDef& def : scene.bodies) {
        cpBody* body = cpSpaceAddBody(space, chipmunkBody(def));
        cpBodySetPosition(body, toChipmunk(def.position));
        bodies.push_back(body);
        for (const Shape& shape : def.shapes) {
            for (const Part& part : partsOf(shape)) {
                cpShape* added = cpSpaceAddShape(space, chipmunkShape(body, part));
                cpShapeSetFriction(added, def.friction);
            }
        }
    }
    for (const Joint& joint : scene.joints) {
        const cpVect anchorA = toChipmunk(joint.connector.anchorA);
        const cpVect anchorB = toChipmunk(joint.connector.anchorB);
        cpBody* a = bodies[joint.a];
        cpBody* b = bodies[joint.b];
        const double length = cpvdist(cpBodyLocalToWorld(a, anchorA), cpBodyLocalToWorld(b, anchorB));
        cpConstraint* spring =
            cpDampedSpringNew(a, b, anchorA, anchorB, length, joint.connector.stiffness, joint.connector.damping);
        cpConstraintSetCollideBodies(spring, cpFalse);
        cpSpaceAddConstraint(space, spring);
    }
}

struct Sums {
    Outcome outcome;
    int count = 0;
};

Outcome outcomeOf(cpSpace* space) {
    Sums sums;
    sums.outcome.minY = std::numeric_limits<double>::infinity();
    cpSpaceEachBody(
        space,
        [](cpBody* body, void* data) {
            if (cpBodyGetType(body) == CP_BODY_TYPE_DYNAMIC) {
                auto& all = *static_cast<Sums*>(data);
                ++all.count;
                all.outcome.minY = std::min(all.outcome.minY, cpBodyGetPosition(body).y);
                all.outcome.meanY += cpBodyGetPosition(body).y;
                all.outcome.kinetic += cpBodyKineticEnergy(body) / 2; // theirs is m v² + I ω²
            }
        },
        &sums);
    sums.outcome.meanY /= std::max(sums.count, 1);
    return sums.outcome;
}

} // namespace

Engine chipmunkEngine(const Scene& scene) {
    Engine engine{.name = "chipmunk"};
    const SpacePointer space = quietSpace();
    cpSpaceSetGravity(space.get(), toChipmunk(scene.parameters.gravity));
    engine.buildMs = milliseconds([&] { build(space.get(), scene); });
    engine.update = [space, step = scene.parameters.seconds / scene.referenceSteps, steps = scene.referenceSteps] {
        for (int k = 0; k < steps; ++k) {
            cpSpaceStep(space.get(), step);
        }
    };
    engine.outcome = [space] { return outcomeOf(space.get()); };
    return engine;
}

} // namespace spacetow::bench
