#include "editor/window/reach_view.h"

#include "core/game/reach.h"

#include <algorithm>

namespace spacetow {

ReachView::ReachView(Document& document, Canvas& canvas, LiveRun& run)
    : m_document(document), m_canvas(canvas), m_run(run) {
    m_listener = m_document.changed.connect([this](const Change&) { refresh(); });
    for (const auto signal : {&LiveRun::started, &LiveRun::stopped, &LiveRun::advanced}) {
        connect(&m_run, signal, this, &ReachView::refresh);
    }
    connect(&m_run, &LiveRun::pausedChanged, this, &ReachView::refresh);
}

ReachView::~ReachView() {
    m_document.changed.disconnect(m_listener);
}

void ReachView::setOn(bool on) {
    m_on = on;
    refresh();
}

void ReachView::setSeconds(int seconds) {
    m_seconds = std::clamp(seconds, shortest, longest);
    refresh();
}

void ReachView::finish() {
    while (m_task.isRunning()) {
        m_task.finish();
    }
}

ReachView::Subject ReachView::wanted() {
    m_run.wantSession(this, m_on); // also before the pause, which shows what there is
    if (!m_on) {
        return {};
    }
    if (!m_run.isRunning()) {
        return {m_document.current().level, nullptr, {}, m_seconds};
    }
    if (!m_run.isPaused()) {
        return {};
    }
    const std::shared_ptr<const Frame> frame = m_run.frame();
    return frame->session ? Subject{nullptr, frame->session, frame->now->controls, m_seconds} : Subject{};
}

void ReachView::refresh() {
    const Subject next = wanted();
    if (next == m_subject) {
        return;
    }
    m_subject = next;
    if (m_subject == Subject{}) {
        m_canvas.setReach(nullptr);
    }
    m_isStale = true;
    if (m_task.isRunning()) {
        m_task.requestStop();
    } else {
        begin();
    }
}

void ReachView::begin() {
    m_isStale = false;
    if (m_subject == Subject{}) {
        return;
    }
    m_task.start([this, subject = m_subject](const std::stop_token& stop) -> BackgroundTask::Then {
        auto shown = std::make_shared<ShownReach>();
        const bool hasShip = subject.session || firstOf<ShipObject>(*subject.level) != nullptr;
        if (hasShip) {
            const std::shared_ptr<const Session> session =
                subject.session ? subject.session : std::make_shared<const Session>(subject.level);
            std::vector<double> times;
            for (int second = 1; second <= subject.seconds; ++second) {
                times.push_back(second);
            }
            shown->outlines = reachOutlines(*session, times);
            shown->path = heldPath(*session, subject.held, subject.seconds, stop);
        }
        return [this, shown = std::move(shown)] {
            if (m_isStale) {
                begin();
            } else {
                m_canvas.setReach(shown);
            }
        };
    });
}

} // namespace spacetow
