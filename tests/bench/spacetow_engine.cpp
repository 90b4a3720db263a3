#include "tests/bench/engines.h"
#include "tests/bench/stopwatch.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace spacetow::bench {

namespace {

Outcome outcomeOf(const World& world) {
    Outcome outcome;
    int count = 0;
    outcome.minY = std::numeric_limits<double>::infinity();
    for (const BodyId id : world.bodies()) {
        const BodyState body = world.body(id);
        if (body.kind == BodyKind::Dynamic) {
            ++count;
            outcome.minY = std::min(outcome.minY, body.pose.position.y());
            outcome.meanY += body.pose.position.y();
            outcome.kinetic += 0.5 * body.mass * body.velocity.squaredNorm() +
                               0.5 * body.inertia * body.angularVelocity * body.angularVelocity;
        }
    }
    outcome.meanY /= std::max(count, 1);
    outcome.hash = world.hash();
    return outcome;
}

} // namespace

Engine spacetowEngine(const Scene& scene) {
    Engine engine{.name = "spacetow"};
    const auto world = std::make_shared<World>();
    engine.buildMs = milliseconds([&] { *world = worldOf(scene); });
    engine.update = [world] { world->update(); };
    engine.outcome = [world] { return outcomeOf(*world); };
    return engine;
}

} // namespace spacetow::bench
