// Edits of a level that runs, what the run leaves behind, and what the status bar says of it.
#include "editor/window/main_window.h"

#include <QDockWidget>
#include <QLocale>

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

/// In the words of the transport: where the run stands while it is held.
QString MainWindow::heldHint() const {
    const auto key = [this](Act act) { return m_actions[act].shortcut().toString(QKeySequence::NativeText); };
    if (const auto timeline = m_run.timeline(); timeline && timeline->iteration > 0) {
        return tr("Held within an update, after iteration %1 of %2 · %3: next iteration · %4: go on from here")
            .arg(timeline->iteration)
            .arg(timeline->iterations)
            .arg(key(Act::StepIteration), key(Act::Pause));
    }
    return isInGame() ? tr("Held · %1: go on from here · %2: next frame · %3: previous frame · %4: back to the editor")
                            .arg(key(Act::Pause), key(Act::Step), key(Act::StepBack), key(Act::Stop))
                      : tr("Simulation held · click: select · drag: move · %1: go on from here · %2: next frame · "
                           "%3: back to the editor")
                            .arg(key(Act::Pause), key(Act::Step), key(Act::Stop));
}

/// Bodies that are drawn beside a simulation are no part of a cave.
QString MainWindow::solidHint() const {
    return drawsSolids(m_toolbox.current()) && m_toolbox.drawnSolids == BodyKind::Dynamic
               ? tr(" · it will move; walls and lines stand still")
               : QString();
}

/// What keys and mouse do to what runs.
QString MainWindow::runHint() const {
    const auto key = [this](Act act) { return m_actions[act].shortcut().toString(QKeySequence::NativeText); };
    if (m_fileReader.isReading()) {
        return tr("Reading %1: %2 s so far · %3: leave it")
            .arg(m_fileReader.subject(), QLocale().toString(m_fileReader.readingFor(), 'f', 1), key(Act::Stop));
    }
    if (isGettingReady()) {
        const double seconds = m_run.isStarting() ? m_run.startingFor() : m_flightReader.readingFor();
        return tr("Getting ready to run: %1 s so far · %2: leave it")
            .arg(QLocale().toString(seconds, 'f', 1), key(Act::Stop));
    }
    if (m_run.behind() > 0) {
        return tr("Too much for this computer: %1 s behind real time · %2: back to the editor")
            .arg(QLocale().toString(m_run.behind(), 'f', 1), key(Act::Stop));
    }
    if (m_live.hand().grab()) {
        return tr("Pulling · move: pull further · let the button go: throw");
    }
    if (const auto timeline = m_run.timeline(); timeline && timeline->goal > timeline->last) {
        const auto seconds = [&](std::int64_t updates) {
            return QLocale().toString(static_cast<double>(updates) * timeline->updateSeconds, 'f', 1);
        };
        return tr("Simulating the run: %1 of %2 s so far · %3: leave it")
            .arg(seconds(timeline->last), seconds(timeline->goal), key(Act::Stop));
    }
    if (m_run.isWatching() && !m_run.isPaused()) {
        return isInGame() ? tr("Playing a recorded flight · who steers takes over · %1: back to the editor")
                                .arg(key(Act::Stop))
                          : tr("Playing a recorded simulation · %1: back to the editor").arg(key(Act::Stop));
    }
    if (m_run.isPaused()) {
        return heldHint();
    }
    if (isInGame()) {
        const QString follow = m_run.keys().shown(PlayKey::Follow);
        const QString view = m_live.isFollowing() || follow.isEmpty()
                                 ? QString()
                                 : tr("%1: follow the ship again").arg(follow) + QStringLiteral(" · ");
        return view + tr("Playing · drag a body: pull it · wheel, right drag: move the view · %1 held: back in time · "
                         "%2: back to the editor · Esc: menu")
                          .arg(m_run.keys().shown(PlayKey::Rewind), key(Act::Stop));
    }
    return tr("Simulation running · click: select · drag: pull a body, move what stands still · %1: "
              "hold · %2: back to the editor")
        .arg(key(Act::Pause), key(Act::Stop));
}

} // namespace spacetow
