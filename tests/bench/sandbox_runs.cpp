// Simulating, without a window.
#include "core/base/random.h"
#include "core/game/session.h"
#include "core/level/file.h"
#include "tests/bench/sandbox_figures.h"
#include "tests/bench/stopwatch.h"
#include "tests/support/folders.h"

namespace spacetow::bench {

namespace {

constexpr int minute = 3000; // updates
constexpr int pitBalls = 2000;

void stepAll(Session& session, const std::vector<StepInput>& inputs) {
    for (const StepInput& input : inputs) {
        session.step(input);
    }
}

/// What a frame has of a run beside its picture.
void measureCopies(const Session& session, const Meter& meter) {
    constexpr int copies = 100;
    std::vector<double> times, pictures;
    for (int i = 0; i < copies; ++i) {
        times.push_back(meter.time([&] { const Session copy(session); }));
        pictures.push_back(meter.time([&] { session.snapshot(); }));
    }
    meter.report({"session-copy.balls", pitBalls, quantile(times, 0.5), "ms"});
    meter.report({"snapshot.balls", pitBalls, quantile(pictures, 0.5), "ms"});
}

/// Updates in a second, in each of so many seconds from the start; the least counts.
void measurePit(const Meter& meter) {
    Session session(ballPit(pitBalls));
    constexpr int seconds = 10;
    const int each = static_cast<int>(1 / session.updateSeconds());
    double least = 1e9;
    double sum = 0;
    for (int second = 0; second < seconds; ++second) {
        const double taken = meter.time([&] { stepAll(session, std::vector<StepInput>(std::size_t(each))); });
        least = std::min(least, 1e3 * each / taken);
        sum += taken;
    }
    meter.report({"circles.updates", pitBalls, 1e3 * each * seconds / sum, "1/s", double(each), true});
    meter.report({"circles.updates.least", pitBalls, least, "1/s", double(each), true});
    measureCopies(session, meter);
}

} // namespace

double Meter::time(const std::function<void()>& work) const {
    return cpu ? processorMilliseconds(work) : milliseconds(work);
}

Level ballPit(int balls) {
    Level level;
    level.name = "Ball pit";
    level.gravity = {0, -9.81};
    level.iterations = 4;
    constexpr int perRow = 50;
    constexpr double radius = 0.1;
    constexpr double half = 0.5 * perRow * 2.2 * radius;
    const double top = 3 + 2.2 * radius * (balls / perRow + 1);
    BodyObject trough;
    trough.shapes = {EdgeChain{{{-half, top}, {-half, 0}, {half, 0}, {half, top}}}};
    level.objects.append({1, "trough", trough, {}});
    for (int i = 0; i < balls; ++i) {
        const int row = i / perRow;
        BodyObject ball{.kind = BodyKind::Dynamic, .shapes = {Circle{{0, 0}, radius}}};
        ball.position = {-half + 2.2 * radius * (i % perRow + 0.5) + 0.01 * (row % 2), 1 + 2.2 * radius * row};
        level.objects.append({static_cast<Key>(i + 2), {}, std::move(ball), {}});
    }
    return level;
}

std::shared_ptr<const Level> firstLevel() {
    const auto path = (test::sourceFolder() + QStringLiteral("/levels/01_first_haul.json")).toStdString();
    const Result<LevelFile> file = readLevel(path);
    EXPECTS(file && file.value().level);
    return std::make_shared<const Level>(*file.value().level);
}

std::vector<StepInput> randomInputs(int updates, std::uint64_t seed) {
    Random random(seed);
    std::vector<StepInput> inputs;
    Controls held;
    for (int i = 0; i < updates; ++i) {
        if (random.below(10) == 0) {
            held = controlsFromBits(static_cast<std::uint8_t>(random.below(16)));
        }
        inputs.emplace_back().controls = held;
    }
    return inputs;
}

void measureRuns(const Meter& meter) {
    measurePit(meter);
    const std::vector<StepInput> inputs = randomInputs(minute, 1);
    Session flight(*firstLevel());
    meter.report({"simulate.level-1", minute, meter.time([&] { stepAll(flight, inputs); }), "ms", 1000});
}

} // namespace spacetow::bench
