#pragma once
// What it takes to watch a run, to turn it back and to change it: figures of the sandbox.

#include "core/game/step_input.h"
#include "core/level/level.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace spacetow::bench {

struct SandboxFigure {
    std::string name;
    int n; // what it counts depends on the figure: updates, bodies, samples
    double value;
    std::string unit;
    double bar = 0; // that it should not exceed, or not be less than; 0 for figures without one
    bool isAtLeast = false;
};

using ReportFigure = std::function<void(const SandboxFigure&)>;

/// Who measures, and how.
struct Meter {
    ReportFigure report;
    bool cpu = false; // time of the processor in this thread, instead of the clock on the wall

    /// In milliseconds.
    double time(const std::function<void()>& work) const;
};

/// Balls that fall into a trough, by formula; 4 iterations an update.
Level ballPit(int balls);
/// The first level of the campaign.
std::shared_ptr<const Level> firstLevel();
/// What somebody without a plan holds in so many updates.
std::vector<StepInput> randomInputs(int updates, std::uint64_t seed);

void measureRuns(const Meter& meter);
void measureTime(const Meter& meter);
void measureReach(const Meter& meter);
/// These need a QApplication.
void measureWindow(const Meter& meter);
void measureEdits(const Meter& meter);

} // namespace spacetow::bench
