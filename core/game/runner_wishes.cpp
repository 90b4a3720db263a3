// Runner: what its frames are to have beside pictures, and what it is asked for.

#include "core/game/runner.h"

#include <future>

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

void Runner::setFocus(Key object) {
    command([this, object] {
        m_course->setFocus(object);
        showAgain();
    });
}

std::function<Recording()> Runner::askRecording() {
    auto promise = std::make_shared<std::promise<Recording>>();
    const std::shared_future<Recording> answer = promise->get_future().share();
    {
        const std::lock_guard lock(m_mutex);
        m_asked = true;
    }
    command([this, promise = std::move(promise)] {
        promise->set_value({m_course->recording(), m_course->startLevel(), m_course->updates()});
    });
    return [answer]() -> Recording {
        try {
            return answer.get();
        } catch (const std::future_error&) { // nobody was there to answer
            return {};
        }
    };
}

} // namespace spacetow
