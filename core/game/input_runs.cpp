#include "core/game/input_runs.h"

#include "core/base/contract.h"

#include <algorithm>

namespace spacetow {

void InputRuns::append(const StepInput& input, std::int64_t count) {
    if (count < 1) {
        return;
    }
    if (!m_runs.empty() && m_runs.back().input == input) {
        m_runs.back().count += count;
    } else {
        m_runs.push_back({input, count});
    }
    m_updates += count;
}

InputRuns InputRuns::after(std::int64_t updates) const {
    InputRuns later;
    std::int64_t from = 0;
    for (const InputRun& run : m_runs) {
        later.append(run.input, run.count - std::max<std::int64_t>(0, updates - from));
        from += run.count;
    }
    return later;
}

void InputRuns::cutAt(std::int64_t updates) {
    while (m_updates > std::max<std::int64_t>(0, updates)) {
        const std::int64_t cut = std::min(m_runs.back().count, m_updates - updates);
        m_runs.back().count -= cut;
        m_updates -= cut;
        if (m_runs.back().count == 0) {
            m_runs.pop_back();
        }
    }
}

InputRuns InputRuns::withLevel(std::shared_ptr<const Level> level) const {
    InputRuns changed;
    for (const InputRun& run : m_runs) {
        StepInput input{run.input.controls, run.input.grab, {}};
        const bool first = changed.m_runs.empty();
        if (first) {
            input.level = level;
            changed.append(input);
            input.level = nullptr;
        }
        changed.append(input, run.count - (first ? 1 : 0));
    }
    return changed;
}

const StepInput& InputReader::next() {
    EXPECTS(!isAtEnd());
    const InputRun& run = m_inputs.runs()[m_run];
    if (++m_done == run.count) {
        ++m_run;
        m_done = 0;
    }
    return run.input;
}

} // namespace spacetow
