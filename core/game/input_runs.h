#pragma once
// All that came from outside in the updates of a run, one after the other; equal ones are kept once.

#include "core/game/step_input.h"

#include <cstdint>
#include <vector>

namespace spacetow {

/// The same input in a number of updates one after the other.
struct InputRun {
    StepInput input;
    std::int64_t count = 1;

    bool operator==(const InputRun&) const = default;
};

class InputRuns {
  public:
    /// Of one more update, or of several.
    void append(const StepInput& input, std::int64_t count = 1);
    std::int64_t updates() const { return m_updates; }
    const std::vector<InputRun>& runs() const { return m_runs; }
    /// Of the updates after so many.
    InputRuns after(std::int64_t updates) const;
    /// Leaves the first so many updates.
    void cutAt(std::int64_t updates);
    void clear() { *this = InputRuns(); }
    /// The same, with the level given in the first update and none later on.
    InputRuns withLevel(std::shared_ptr<const Level> level) const;

  private:
    std::vector<InputRun> m_runs;
    std::int64_t m_updates = 0;
};

/// Goes through them, one update at a time.
class InputReader {
  public:
    explicit InputReader(InputRuns inputs) : m_inputs(std::move(inputs)) {}

    bool isAtEnd() const { return m_run == m_inputs.runs().size(); }
    /// Of the next update, unless it is at the end.
    const StepInput& next();
    std::int64_t updates() const { return m_inputs.updates(); }
    void restart() { m_run = 0, m_done = 0; }

  private:
    InputRuns m_inputs;
    std::size_t m_run = 0;
    std::int64_t m_done = 0; // updates of the run
};

} // namespace spacetow
