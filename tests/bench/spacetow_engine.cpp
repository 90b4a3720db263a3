#include "tests/bench/engines.h"
#include "tests/bench/stopwatch.h"

#include <algorithm>
#include <limits>

namespace spacetow::bench {

namespace {

void describe(Run& run, const World& world) {
    int count = 0;
    run.minY = std::numeric_limits<double>::infinity();
    for (const BodyId id : world.bodies()) {
        const BodyState body = world.body(id);
        if (body.kind == BodyKind::Dynamic) {
            ++count;
            run.minY = std::min(run.minY, body.pose.position.y());
            run.meanY += body.pose.position.y();
            run.kinetic += 0.5 * body.mass * body.velocity.squaredNorm() +
                           0.5 * body.inertia * body.angularVelocity * body.angularVelocity;
        }
    }
    run.meanY /= std::max(count, 1);
    run.hash = world.hash();
}

} // namespace

Run runSpacetow(const Scene& scene, int updates) {
    Run run;
    World world;
    run.buildMs = milliseconds([&] { world = worldOf(scene); });
    for (int i = 0; i < updates; ++i) {
        run.updateMs.push_back(milliseconds([&] { world.update(); }));
    }
    describe(run, world);
    return run;
}

} // namespace spacetow::bench
