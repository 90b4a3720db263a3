#include "editor/canvas/background_task.h"

#include "core/base/contract.h"

#include <new>
#include <stdexcept>
#include <utility>

namespace spacetow {

BackgroundTask::~BackgroundTask() {
    m_thread = {}; // asks it to stop and waits
}

void BackgroundTask::start(Work work) {
    EXPECTS(!isRunning());
    m_thread = std::jthread([this, doWork = std::move(work)](const std::stop_token& stop) {
        Then then = [] {};
        try {
            then = doWork(stop);
        } catch (const std::bad_alloc&) { // there is no result, but there still is a program
        } catch (const std::length_error&) {
        }
        {
            const std::lock_guard lock(m_mutex);
            m_then = std::move(then);
        }
        QMetaObject::invokeMethod(
            this, [this] { conclude(); }, Qt::QueuedConnection);
    });
}

void BackgroundTask::finish() {
    if (isRunning()) {
        m_thread.join();
        conclude();
    }
}

void BackgroundTask::conclude() {
    Then then;
    {
        const std::lock_guard lock(m_mutex);
        then = std::exchange(m_then, nullptr);
    }
    if (!then) {
        return; // finish() was quicker than the event loop
    }
    if (m_thread.joinable()) {
        m_thread.join();
    }
    m_thread = {};
    then();
}

} // namespace spacetow
