#include "core/game/step_profile.h"

#include <algorithm>
#include <numeric>

namespace spacetow {

namespace {

double wholeOf(const StepProfile::Stages& stages) {
    return std::accumulate(stages.begin(), stages.end(), 0.0);
}

} // namespace

void StepProfile::note(const Stages& stages) {
    if (m_updates.size() < kept) {
        m_updates.push_back(stages);
    } else {
        m_updates[m_next] = stages;
    }
    m_next = (m_next + 1) % kept;
}

std::vector<StepProfile::Stages> StepProfile::history() const {
    std::vector<Stages> inOrder = m_updates;
    if (inOrder.size() == kept) {
        std::rotate(inOrder.begin(), inOrder.begin() + static_cast<std::ptrdiff_t>(m_next), inOrder.end());
    }
    return inOrder;
}

template <class Sum>
StepProfile::Figures StepProfile::figures(const Sum& sum) const {
    Figures result;
    if (m_updates.empty()) {
        return result;
    }
    for (const Stages& stages : m_updates) {
        const double seconds = sum(stages);
        result.average += seconds;
        result.maximum = std::max(result.maximum, seconds);
    }
    result.average /= static_cast<double>(m_updates.size());
    result.now = sum(m_updates[(m_next + kept - 1) % kept]);
    return result;
}

StepProfile::Figures StepProfile::of(StepStage stage) const {
    return figures([stage](const Stages& stages) { return double{stages[static_cast<std::size_t>(stage)]}; });
}

StepProfile::Figures StepProfile::together() const {
    return figures(wholeOf);
}

void StepWatch::note() {
    constexpr float nanosecond = 1e-9F;
    StepProfile::Stages stages{};
    for (std::size_t i = 0; i < stages.size(); ++i) {
        stages[i] = nanosecond * static_cast<float>(m_times.spent[i]);
    }
    m_times.spent.fill(0);
    m_profile.note(stages);
}

} // namespace spacetow
