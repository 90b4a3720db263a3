#include "editor/window/explanations.h"

#include "editor/canvas/force_painter.h"
#include "editor/window/messages.h"

#include <QEvent>

#include <utility>

namespace spacetow {

Explanations::Explanations(Document& document, Canvas& canvas, TagMatrixPanel& matrix)
    : m_canvas(canvas), m_matrix(matrix), m_panel(document, [](const Error& error) { return sentence(error); }),
      m_plots(document), m_start(document) {
    connect(&m_panel, &ExplainPanel::explainedChanged, this, [this] { showForces(); });
    connect(&m_start, &StartSession::changed, this, [this] { showStart(); });
    for (QWidget* panel : std::initializer_list<QWidget*>{&m_panel, &m_plots, &m_profile}) {
        panel->installEventFilter(this);
    }
}

Explanations::~Explanations() {
    for (QWidget* panel : std::initializer_list<QWidget*>{&m_panel, &m_plots, &m_profile}) {
        panel->removeEventFilter(this);
    }
}

bool Explanations::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Show || event->type() == QEvent::Hide) {
        look();
    }
    return QObject::eventFilter(watched, event);
}

void Explanations::look() {
    const bool wanted = !m_runs && (m_panel.isVisible() || m_plots.isVisible() || m_profile.isVisible());
    if (wanted != std::exchange(m_wantsStart, wanted)) {
        if (wanted) {
            m_start.want();
        } else {
            m_start.release();
        }
    }
    showStart();
}

bool Explanations::wantsSession() const {
    return m_panel.isVisible() || m_plots.isVisible() || m_profile.isVisible() || m_matrix.isVisible();
}

/// The display asks more often than there is something new.
void Explanations::showRun(const std::shared_ptr<const Frame>& frame) {
    if (std::exchange(m_frame, frame) == frame) {
        return;
    }
    m_session = frame->session;
    m_panel.showSession(m_session);
    m_plots.showTimeline(*frame->timeline);
    m_plots.showSession(m_session, true);
    m_profile.showSession(m_session, frame->profile);
    m_matrix.showTouches(m_session->tagTouches());
    showForces();
}

void Explanations::setRuns(bool runs) {
    if (std::exchange(m_runs, runs) != runs) {
        m_frame.reset();
        look();
    }
}

void Explanations::showStart() {
    if (m_runs) {
        return;
    }
    m_session = m_wantsStart ? m_start.latest() : nullptr;
    m_panel.showSession(m_session);
    m_plots.showSession(m_session, false);
    m_profile.showSession(m_session, nullptr);
    showForces();
}

void Explanations::showForces() {
    const bool any = m_session && m_panel.isVisible() && m_panel.explained() != 0;
    const std::optional<BodyId> body = any ? m_session->bodyOf(m_panel.explained()) : std::nullopt;
    m_canvas.setForces(body ? forceArrows(m_session->world(), *body) : std::vector<ForceArrow>());
}

} // namespace spacetow
