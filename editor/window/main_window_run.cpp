// Edits of a level that runs, and what the run leaves behind.
#include "editor/window/main_window.h"

#include <QDockWidget>

namespace spacetow {

void MainWindow::listenToRunChanges() {
    m_runListener = m_document.changed.connect([this](const Change&) { tellRun(); });
    connect(&m_runChanges, &RunChangesPanel::wanted, this, [this] {
        QDockWidget& dock = m_panels->dock(QStringLiteral("runChanges"));
        dock.show();
        dock.raise();
    });
    connect(&m_runChanges, &RunChangesPanel::settled, this, [this] {
        m_panels->dock(QStringLiteral("runChanges")).hide();
        m_canvas.setFocus();
    });
}

/// What was committed; a gesture that is going on is none of the run's business.
void MainWindow::tellRun() {
    const std::shared_ptr<const Level>& level = m_document.current().level;
    if (!m_run.isRunning() || level == m_told) {
        return;
    }
    m_told = level;
    m_run.setLevel(levelToRun());
    m_live.knowLevel(*level);
}

} // namespace spacetow
