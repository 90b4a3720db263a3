// Runner: what its frames are to have beside pictures.

#include "core/game/runner.h"

namespace spacetow {

namespace {

/// ns since whenever.
std::int64_t clockNanoseconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

} // namespace

void Runner::wantSession(bool wanted) {
    command([this, wanted] {
        m_withSession = wanted;
        showAgain();
    });
}

void Runner::wantProfile(bool wanted) {
    command([this, wanted] {
        if (wanted != m_watch.has_value()) {
            m_watch = wanted ? std::optional<StepWatch>(clockNanoseconds) : std::nullopt;
            post(m_last);
        }
    });
}

} // namespace spacetow
