// What the window listens to, and what it remembers from the last run.
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLayout>

namespace spacetow {

void MainWindow::listen() {
    m_documentListener = m_document.changed.connect([this](const Change& change) {
        if (change.before.level != change.after.level) {
            leaveWelcome();
        }
        if (change.before.level->tags != change.after.level->tags) {
            updateLegend();
        }
        updateSelection();
        updateTool();
        m_sinceMotion.invalidate();
        updateMotion();
        const Selection& before = change.before.selection;
        const Selection& after = change.after.selection;
        if (before.keys() != after.keys() || before.nodes().size() != after.nodes().size()) {
            m_actions.refresh();
        }
    });
    m_historyListener = m_document.historyChanged.connect([this] {
        setWindowModified(m_document.isModified());
        m_actions.refresh();
    });
    m_toolbox.changed.connect([this] { updateTool(); });
    m_fileListener = m_files.changed.connect([this] {
        updateTitle();
        m_flights.setFile(m_files.path());
        Q_EMIT fileChanged();
    });
    m_openedListener = m_files.opened.connect([this] {
        stopPlaying();
        leaveWelcome();
        updateOrigin();
        m_toolbox.cancel();
        m_exchange.cancel();
        m_guideBar.dismiss();
        m_canvas.showAnew();
    });
}

void MainWindow::listenToPanels() {
    m_flights.setFile(m_files.path());
    connect(&m_flights, &FlightsPanel::flightWanted, this, [this](const Replay& replay, qint64 update) {
        playReplay(replay);
        m_run.seek(update);
    });
    connect(&m_flights, &FlightsPanel::placeWanted, this, [this](double x, double y) {
        const Vec2 place(x, y);
        m_canvas.showPlace({&place, 1});
    });
    m_exchange.questions = exchangeDialogs(this);
    m_exchange.suggestion = [this] {
        const QFileInfo file(m_files.path().isEmpty() ? QDir::home().filePath(m_files.name()) : m_files.path());
        return file.dir().filePath(file.completeBaseName());
    };
    m_canvas.setSnapNames([this](const SnapAnswer& snap) { return snapName(*m_document.current().level, snap); });
    connect(&m_canvas, &Canvas::pointed, &m_status, &StatusLine::setPointer);
    connect(&m_canvas, &Canvas::pointerLeft, &m_status, &StatusLine::clearPointer);
    connect(&m_canvas, &Canvas::pointerLeft, this, [this] { m_toolbox.leave(); });
    connect(&m_canvas, &Canvas::viewChanged, this,
            [this] { m_status.setZoom(m_canvas.view().scale / Viewport().scale); });
    connect(&m_canvas, &Canvas::guideOpened, this, &MainWindow::openGuide);
    connect(&m_guideBar, &GuideBar::dismissed, &m_canvas, qOverload<>(&Canvas::setFocus));
    connect(&m_canvas, &Canvas::menuWanted, this, &MainWindow::openMenuAt);
    connect(&m_canvas, &Canvas::menuKeyPressed, this, &MainWindow::openMenuAtSelection);
    connect(&m_transform, &TransformBar::closed, &m_canvas, [this] { m_canvas.setFocus(); });
    connect(&m_arrays, &ArrayBar::closed, &m_canvas, [this] { m_canvas.setFocus(); });
    connect(&m_inspector, &Inspector::sectionsFolded, this,
            [this] { m_files.preferences.setFoldedSections(m_inspector.foldedSections()); });
    connect(&m_outliner, &OutlinerPanel::menuWanted, this, &MainWindow::openOutlinerMenuAt);
    connect(&m_outliner, &OutlinerPanel::viewWanted, &m_canvas, &Canvas::centerSelection);
    connect(&m_outliner, &OutlinerPanel::said, this,
            [this](const QString& text) { m_message.say(MessageBar::Tone::Info, text); });
    m_outliner.addButtons({&m_actions[Act::NewLayer], &m_actions[Act::Group], &m_actions[Act::Ungroup],
                           &m_actions[Act::Forward], &m_actions[Act::Backward], &m_actions[Act::Delete]});
    connect(&m_differences, &DifferencePanel::levelWanted, &m_actions[Act::Compare], &QAction::trigger);
    connect(&m_problems, &ProblemsPanel::said, this,
            [this](const QString& text) { m_message.say(MessageBar::Tone::Info, text); });
    connect(&m_problems, &ProblemsPanel::objectWanted, this, &MainWindow::showObject);
    connect(&m_inspector, &Inspector::objectWanted, this, &MainWindow::showObject);
    connect(&m_problems, &ProblemsPanel::cured, this, &MainWindow::showCured);
    connect(&m_problems, &ProblemsPanel::placeWanted, this,
            [this](const std::vector<Vec2>& place) { m_canvas.showPlace(place); });
    connect(&m_problems, &ProblemsPanel::problemsChanged, this, [this] {
        m_status.setProblems(m_problems.errors(), m_problems.warnings());
        if (m_problems.errors() == 0 && !m_errorsTold.isEmpty() && m_message.text() == m_errorsTold) {
            m_message.dismiss(); // what it says has been cured
        }
    });
    connect(&m_problems, &ProblemsPanel::marksChanged, this, &MainWindow::updateProblems);
    connect(&m_open->check, &LevelCheck::checked, this, &MainWindow::tellErrors);
    updateProblems();
    m_status.setProblems(m_problems.errors(), m_problems.warnings());
    connect(&m_status, &StatusLine::problemsClicked, this, [this] {
        QDockWidget& dock = m_panels->dock(QStringLiteral("problems"));
        dock.show();
        dock.raise();
        m_actions[Act::NextProblem].trigger();
    });
    connect(&m_status, &StatusLine::zoomChosen, this,
            [this](double zoom) { m_canvas.zoomTo(zoom * Viewport().scale); });
    connect(&m_status, &StatusLine::left, this, [this] { m_canvas.setFocus(); });
    connect(&m_status, &StatusLine::stepChosen, this, [this](double step) {
        SnapSettings snap = m_toolbox.snap;
        snap.step = step;
        setSnap(snap);
    });
    connect(&m_status, &StatusLine::divisionChosen, this, [this](int parts) {
        SnapSettings snap = m_toolbox.snap;
        snap.division = parts;
        setSnap(snap);
    });
    listenToRun();
}

void MainWindow::updateProblems() {
    m_canvas.setProblems(m_problems.marks(), m_problems.current());
    m_actions.refresh();
}

void MainWindow::restore() {
    setGridVisible(m_files.preferences.grid());
    setGuidesVisible(m_files.preferences.guides());
    setRulersVisible(m_files.preferences.rulers());
    setSnap(m_files.preferences.snap());
    m_legendShown = m_files.preferences.isLegendShown();
    setOverlayPalette(m_files.preferences.overlayPalette());
    setOverlays(m_files.preferences.overlays());
    listenToLegend();
    updateKeys();
    m_inspector.foldSections(m_files.preferences.foldedSections());
    restoreGeometry(m_files.preferences.geometry());
    restoreState(m_files.preferences.windowState());
    layout()->invalidate(); // it holds to what the panels asked for before they were tabs
    layout()->activate();
    restoreGeometry(m_files.preferences.geometry()); // which it had outgrown by that
}

} // namespace spacetow
