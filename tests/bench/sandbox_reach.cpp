// Where the ship can be: what that takes, and whether it holds.
#include "core/game/reach.h"
#include "tests/bench/sandbox_figures.h"
#include "tests/bench/stopwatch.h"
#include "tests/support/reach_runs.h"

namespace spacetow::bench {

namespace {

constexpr int looks = 50;
constexpr double frameTime = 16;                   // ms
const std::vector<double> furthest{1, 2, 3, 4, 5}; // s, as far as the window looks ahead

void measureFan(const Session& session, const std::string& name, const Meter& meter) {
    std::vector<double> fans, paths;
    for (int i = 0; i < looks; ++i) {
        fans.push_back(meter.time([&] { reachOutlines(session, furthest); }));
        paths.push_back(meter.time([&] { heldPath(session, {.thrust = true}, 2); }));
    }
    meter.report({"reach.fan.longest." + name, looks, quantile(fans, 1), "ms", frameTime});
    meter.report({"reach.path.median." + name, looks, quantile(paths, 0.5), "ms"});
}

} // namespace

void measureReach(const Meter& meter) {
    measureFan(Session(firstLevel()), "level-1", meter);
    measureFan(test::onTheRope(), "on-the-rope", meter);
    constexpr int runs = 10'000;
    int within = 0;
    for (int run = 0; run < runs; ++run) {
        within += test::endsWithinItsReach(static_cast<std::uint64_t>(run) + 1) ? 1 : 0;
    }
    meter.report({"reach.within", runs, 100.0 * within / runs, "%", 99, true});
}

} // namespace spacetow::bench
