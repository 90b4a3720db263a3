// Turning a run back: a minute of it, kept, looked at anywhere, and simulated again after an edit.
#include "core/base/random.h"
#include "core/game/course.h"
#include "core/level/edits.h"
#include "tests/bench/sandbox_figures.h"
#include "tests/bench/stopwatch.h"

namespace spacetow::bench {

namespace {

constexpr int keptUpdates = 3000; // a minute
constexpr int looks = 200;
constexpr double megabyte = 1 << 20;

struct KeptRun {
    explicit KeptRun(std::shared_ptr<const Level> level, const std::vector<StepInput>& inputs)
        : session(std::move(level)), timeline(session) {
        for (const StepInput& input : inputs) {
            session.step(input);
            timeline.add(input, session);
        }
    }
    std::int64_t somewhere(Random& random) const {
        const auto length = static_cast<std::uint64_t>(timeline.last() - timeline.first());
        return timeline.first() + static_cast<std::int64_t>(random.below(length + 1));
    }

    Session session;
    Timeline timeline;
};

void measureScrubbing(KeptRun& run, const std::string& name, const Meter& meter) {
    Random random(1);
    std::vector<double> times;
    for (int i = 0; i < looks; ++i) {
        const std::int64_t update = run.somewhere(random);
        times.push_back(meter.time([&] { run.timeline.at(update); }));
    }
    meter.report({"scrub.median." + name, looks, quantile(times, 0.5), "ms"});
    meter.report({"scrub.longest." + name, looks, quantile(times, 1), "ms", 150});
}

/// One update after the other, as a key that is held does it: with what is prepared between two of them.
void measureSteppingBack(KeptRun& run, const std::string& name, const Meter& meter) {
    Random random(2);
    std::vector<double> times;
    std::int64_t update = run.timeline.last();
    for (int i = 0; i < looks; ++i) {
        if (i % 40 == 0) {
            update = std::max(run.somewhere(random), run.timeline.first() + 40);
            run.timeline.at(update);
        }
        while (!run.timeline.prepareBackFrom(update, 20)) {
        }
        times.push_back(meter.time([&] { run.timeline.at(--update); }));
    }
    meter.report({"step-back.median." + name, looks, quantile(times, 0.5), "ms"});
    meter.report({"step-back.longest." + name, looks, quantile(times, 1), "ms", 50});
}

void measureKept(KeptRun& run, const std::string& name, double bar, const Meter& meter) {
    meter.report({"kept-minute." + name, keptUpdates, static_cast<double>(run.timeline.bytes()) / megabyte, "MB", bar});
    measureScrubbing(run, name, meter);
    measureSteppingBack(run, name, meter);
}

/// The level is changed while standing at its start; all of the minute comes again.
void measureResimulation(const std::vector<StepInput>& inputs, const Meter& meter) {
    Course course(firstLevel(), 1);
    for (const StepInput& input : inputs) {
        course.goOn(input);
    }
    Level edited = course.session().level();
    edited.gravity.y() -= 0.01;
    const auto level = std::make_shared<const Level>(std::move(edited));
    const double taken = meter.time([&] {
        course.seek(course.timeline().first());
        course.setLevel(level);
        while (course.isSimulating()) {
            course.simulate(100);
        }
    });
    meter.report({"resimulate.level-1", static_cast<int>(course.timeline().last()), taken, "ms", 1000});
}

} // namespace

void measureTime(const Meter& meter) {
    const std::vector<StepInput> inputs = randomInputs(keptUpdates, 1);
    KeptRun flight(firstLevel(), inputs);
    measureKept(flight, "level-1", 64, meter);
    measureResimulation(inputs, meter);
    constexpr int balls = 2000;
    KeptRun pit(std::make_shared<const Level>(ballPit(balls)), std::vector<StepInput>(keptUpdates));
    measureKept(pit, "balls", 512, meter);
}

} // namespace spacetow::bench
