#include "core/game/session_lender.h"

#include <utility>

namespace spacetow {

std::shared_ptr<const Session> SessionLender::copyOf(const Session& session) {
    auto copy = std::make_unique<const Session>(session);
    {
        const std::lock_guard lock(m_returned->mutex);
        m_returned->sessions.reserve(m_returned->lent + 1); // so that giving it back cannot fail
        ++m_returned->lent;
    }
    return {copy.release(), [returned = m_returned](const Session* session) {
                const std::lock_guard lock(returned->mutex);
                returned->sessions.emplace_back(session);
            }};
}

void SessionLender::collect() {
    std::vector<std::unique_ptr<const Session>> sessions;
    {
        const std::lock_guard lock(m_returned->mutex);
        if (m_returned->sessions.empty()) {
            return;
        }
        const std::size_t stillLent = m_returned->lent - m_returned->sessions.size();
        sessions.reserve(stillLent); // before anything has changed, as it may fail
        sessions.swap(m_returned->sessions);
        m_returned->lent = stillLent;
    }
}

} // namespace spacetow
