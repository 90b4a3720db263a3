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

template <class T>
T Runner::answered(std::function<T()> ask) {
    auto promise = std::make_shared<std::promise<T>>();
    std::future<T> answer = promise->get_future();
    command([ask = std::move(ask), promise = std::move(promise)] { promise->set_value(ask()); });
    try {
        return answer.get();
    } catch (const std::future_error&) { // nobody is there to answer
        return {};
    }
}

Replay Runner::recording() {
    return answered<Replay>([this] { return m_course->recording(); });
}

std::shared_ptr<const Level> Runner::startLevel() {
    return answered<std::shared_ptr<const Level>>([this] { return m_course->startLevel(); });
}

} // namespace spacetow
