#include "editor/canvas/start_session.h"

namespace spacetow {

StartSession::StartSession(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    m_listener = m_document.changed.connect([this](const Change&) { refresh(); });
}

StartSession::~StartSession() {
    m_document.changed.disconnect(m_listener);
}

void StartSession::want() {
    ++m_wanted;
    refresh();
}

void StartSession::release() {
    --m_wanted;
}

/// One at a time: what changes meanwhile is made when that is done.
void StartSession::refresh() {
    const std::shared_ptr<const Level> level = m_document.shown().level;
    if (m_wanted <= 0 || m_task.isRunning() || m_made == level) {
        return;
    }
    m_task.start([this, level](const std::stop_token&) -> BackgroundTask::Then {
        auto session = std::make_shared<const Session>(*level);
        return [this, level, session] {
            m_latest = session;
            m_made = level;
            Q_EMIT changed();
            refresh();
        };
    });
}

void StartSession::finish() {
    refresh();
    while (m_task.isRunning()) {
        m_task.finish();
        refresh();
    }
}

} // namespace spacetow
