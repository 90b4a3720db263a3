// Between editing and what runs.

#include "editor/window/main_window.h"

#include "core/base/whole_file.h"
#include "core/level/object_geometry.h"
#include "editor/panels/number_text.h"
#include "editor/window/messages.h"

#include <QFileDialog>
#include <QLayout>

#include <algorithm>
#include <utility>

namespace spacetow {

void MainWindow::play() {
    if (!isInGame() && !isStarting(LiveRun::Kind::Game)) {
        stopPlaying();
        m_shipAt.reset();
        enterRun(LiveRun::Kind::Game, nullptr);
    }
}

void MainWindow::simulate() {
    if (!isPlaying() && !isStarting(LiveRun::Kind::Simulation)) {
        stopPlaying();
        m_shipAt.reset();
        enterRun(LiveRun::Kind::Simulation, nullptr);
    }
}

bool MainWindow::isStarting(LiveRun::Kind kind) const {
    return m_run.isStarting() && m_run.isGame() == (kind == LiveRun::Kind::Game);
}

void MainWindow::playFromPointer() {
    if (!isInGame()) {
        const Vec2 pointer = m_canvas.pointerPosition();
        stopPlaying();
        m_shipAt = pointer;
        enterRun(LiveRun::Kind::Game, nullptr);
    }
}

std::shared_ptr<const Level> MainWindow::levelToRun() const {
    const std::shared_ptr<const Level>& level = m_document.current().level;
    const Object* const object = m_shipAt ? firstOf<ShipObject>(*level) : nullptr;
    if (object == nullptr) {
        return level;
    }
    Object ship = *object;
    std::get<ShipObject>(ship.data).position = *m_shipAt;
    auto moved = std::make_shared<Level>(*level);
    moved->objects.replace(level->objects.indexOf(ship.key), std::move(ship));
    return moved;
}

void MainWindow::enterReplay(const Recorded& recorded) {
    stopPlaying();
    m_shipAt.reset();
    enterRun(recorded.replay.kind, &recorded);
}

/// The run knows its edits already; the document is told of them, so that they are changes of the run.
void MainWindow::takeOverEdits() {
    const std::shared_ptr<const Level> edited = std::exchange(m_reopened, nullptr);
    if (edited && *edited != m_document.level()) {
        m_told = edited;
        m_document.commit({"run-edits", 1}, {edited, m_document.selection()});
        m_live.knowLevel(*edited);
    }
}

/// Nobody types or draws any more.
void MainWindow::putDown() {
    enterTyping();
    m_arrays.cancel();
    m_exchange.cancel();
    m_transform.hide();
    m_guideBar.dismiss();
    finishDrawing();
}

/// One edits on until the run is there.
void MainWindow::enterRun(LiveRun::Kind wanted, const Recorded* recorded) {
    m_enteredAnew = isWelcoming();
    leaveWelcome();
    putDown();
    m_open->check.hurry();
    m_recorded = recorded != nullptr;
    m_told = m_document.current().level;
    m_run.wantSession(this, true);
    m_reopened = m_recorded ? recorded->then : nullptr;
    if (m_recorded) {
        m_run.start(levelToRun(), recorded->replay, recorded->then);
    } else {
        m_run.start(levelToRun(), wanted);
    }
}

/// In place of the board.
void MainWindow::showRun() {
    putDown();
    m_errorsUntold = true;
    m_open->runChanges.begin();
    m_smartBefore = std::exchange(m_toolbox.snap.smart, false); // nothing stays where one could snap to it
    m_status.setSnap(m_toolbox.snap);
    tellRun(); // of what was edited meanwhile
    m_framesPerSecond = 0;
    m_inGame = m_run.isGame();
    m_toolbox.drawnSolids = m_inGame ? BodyKind::Static : BodyKind::Dynamic; // in a sandbox things fall
    m_panelsInGame = false;
    m_live.show(*levelToRun(), m_enteredAnew);
    updateTimeline();
    updatePace();
    placePanels();
    m_canvas.setFocus();
    updateTitle();
    updateMode();
    tellErrors();
    takeOverEdits();
}

/// What is in the middle of the canvas stays where it is on the screen, however much room the panels leave.
void MainWindow::placePanels() {
    const bool away = isWelcoming() || arePanelsHidden();
    if (away == m_panels->areAway() && isPlaying() == !m_timeline.isHidden()) {
        return;
    }
    const QPointF middle(m_canvas.width() / 2.0, m_canvas.height() / 2.0);
    const QPointF before = m_canvas.mapToGlobal(middle);
    m_panels->setAway(away);
    m_timeline.setVisible(isPlaying());
    if (!isPlaying() || !m_canvas.isVisible()) {
        return;
    }
    for (QLayout* one : {layout(), static_cast<QLayout*>(&m_column), m_frame.layout()}) {
        one->activate();
    }
    const QPointF moved = m_canvas.mapFromGlobal(before) - QPointF(m_canvas.width() / 2.0, m_canvas.height() / 2.0);
    m_live.shiftView({moved.x(), moved.y()});
}

/// Of the level that is played; once it has been checked, which is not waited for.
void MainWindow::tellErrors() {
    if (!isPlaying() || !m_open->check.isUpToDate() || !std::exchange(m_errorsUntold, false)) {
        return;
    }
    const int errors = m_problems.errors();
    if (errors > 0) {
        m_errorsTold = counted(
            tr("The level has %n errors and may not play as it should; see Problems.", nullptr, errors), errors);
        m_message.say(MessageBar::Tone::Warning, m_errorsTold);
    }
}

void MainWindow::stopPlaying() {
    m_bugCapsule.forgetRun();
    m_flightReader.leave();
    m_run.stop();
    if (!isPlaying()) {
        return;
    }
    m_toolbox.snap.smart = m_toolbox.snap.smart || m_smartBefore;
    m_toolbox.drawnSolids = BodyKind::Static;
    m_status.setSnap(m_toolbox.snap);
    m_status.setPace(QString());
    m_inspector.hideMotion();
    m_live.hide();
    updateWays();
    updateSelection();
    finishWork(); // it belongs to the run
    showBoard();
    m_open->runChanges.end();
}

void MainWindow::listenToRun() {
    connect(&m_run, &LiveRun::pausedChanged, this, [this] {
        m_actions.refresh();
        updateTool();
        updatePace();
        updateWays();
    });
    connect(&m_run, &LiveRun::advanced, this, &MainWindow::updateWays);
    connect(&m_run, &LiveRun::advanced, this, &MainWindow::updateMotion);
    connect(&m_run, &LiveRun::advanced, this, &MainWindow::updateTimeline);
    connect(&m_run, &LiveRun::speedChanged, this, &MainWindow::updatePace);
    connect(&m_timeline, &TimelineBar::speedWanted, this, [this](double speed) { m_run.setSpeed(speed); });
    connect(&m_timeline.scale(), &TimelineScale::sought, this, [this](qint64 update) { m_run.seek(update); });
    connect(&m_run, &LiveRun::advanced, this, &MainWindow::updateExplanations);
    connect(&m_run, &LiveRun::started, this, &MainWindow::updateExplanations);
    connect(&m_run, &LiveRun::started, this, &MainWindow::showRun);
    const auto tellProgress = [this] {
        m_actions.refresh();
        updateTool();
    };
    connect(&m_run, &LiveRun::startingChanged, this, tellProgress);
    m_flightReader.changed = tellProgress;
    m_fileReader.changed = tellProgress;
    connect(&m_run, &LiveRun::stopped, this, [this] { m_explanations.setRuns(false); });
    connect(&m_explanations.panel(), &ExplainPanel::objectWanted, this, &MainWindow::showObject);
    connect(&m_explanations.plots(), &PlotPanel::exportWanted, this, &MainWindow::writePlots);
    m_explanations.whereToWrite = [this](const QString& suggested) {
        return QFileDialog::getSaveFileName(this, tr("Write plots"), suggested, tr("Tables (*.csv)"));
    };
    connect(&m_live, &LiveView::framesCounted, this, [this](double perSecond) {
        m_framesPerSecond = perSecond;
        updatePace();
    });
    whereToSaveFlight = [this](const QString& suggestion) {
        return QFileDialog::getSaveFileName(this, tr("Save flight"), suggestion, tr("Flights (*.replay.json)"));
    };
    connect(&m_run, &LiveRun::phaseChanged, this, &MainWindow::updateTitle);
    connect(&m_run, &LiveRun::paceChanged, this, &MainWindow::updateTool);
    connect(&m_live, &LiveView::finished, this, &MainWindow::stopPlaying);
    connect(&m_live, &LiveView::followingChanged, this, &MainWindow::updateTool);
    connect(&m_run, &LiveRun::failed, this, [this](RunnerFault fault) {
        stopPlaying();
        m_message.say(MessageBar::Tone::Error,
                      fault == RunnerFault::Crowd
                          ? tr("The game was ended: so many bodies lie in the same place that the computer's memory "
                               "would not hold what happens between them. Move them apart, and play again.")
                          : tr("The game was ended: there is not enough memory for this level. Nothing of the level is "
                               "lost."));
    });
}

void MainWindow::updateTimeline() {
    m_bugCapsule.compare();
    if (const auto timeline = m_run.timeline(); timeline && isPlaying()) {
        m_timeline.showState({timeline->first, timeline->last, timeline->shown, timeline->goal, timeline->updateSeconds,
                              timeline->marks, !timeline->ghosts.empty()});
    }
}

void MainWindow::updatePace() {
    if (!isPlaying()) {
        return;
    }
    const double speed = m_run.speed();
    m_timeline.showSpeed(speed);
    const QString times = speedText(speed);
    const bool moves = m_framesPerSecond > 0 && !m_run.isPaused(); // what is held is painted when it changes only
    const QString frames = moves ? tr("%1 fps").arg(qRound(m_framesPerSecond)) : QString();
    m_status.setPace(speed == 1 ? frames : frames.isEmpty() ? times : times + QStringLiteral(" · ") + frames);
}

/// As often as one can read it.
void MainWindow::updateMotion() {
    constexpr qint64 interval = 100; // ms
    if (!isPlaying() || (m_sinceMotion.isValid() && m_sinceMotion.elapsed() < interval && !m_run.isPaused())) {
        return;
    }
    m_sinceMotion.start();
    updateTool(); // what the mouse holds
    updateSelection();
    const std::vector<Key>& keys = m_document.selection().keys();
    const Object* const object = keys.size() == 1 ? m_document.level().objects.find(keys.front()) : nullptr;
    if (object == nullptr || !poseOf(*object)) {
        showTension(object);
        return;
    }
    const BodyPicture* const body = m_live.picture().find(
        [&](const BodyPicture& one) { return one.look->key == object->key && one.look->role != BodyRole::Debris; });
    m_inspector.showMotion(body != nullptr ? std::optional(Motion{body->pose, body->velocity, body->angularVelocity})
                                           : std::nullopt);
}

/// Of a connector; of everything else there is nothing to say.
void MainWindow::showTension(const Object* object) {
    const std::shared_ptr<const Session> session = m_run.session();
    const bool connects = object != nullptr && std::holds_alternative<ConnectorObject>(object->data);
    if (!connects || !session) {
        m_inspector.hideMotion();
    } else if (const std::optional<ConnectorId> id = session->connectorOf(object->key)) {
        const ConnectorState state = session->world().connector(*id);
        m_inspector.showTension((state.anchorB - state.anchorA).norm(), state.length, state.tension);
    } else {
        m_inspector.showMotion({});
    }
}

/// Times are taken for what can be seen only.
void MainWindow::updateExplanations() {
    m_explanations.setRuns(m_run.isRunning());
    m_run.wantSession(&m_explanations, m_explanations.wantsSession());
    m_run.wantProfile(m_explanations.wantsProfile());
    const std::shared_ptr<const Frame> frame = m_run.frame();
    if (frame != nullptr && frame->session != nullptr) {
        m_explanations.showRun(frame);
    }
}

void MainWindow::writePlots(const QByteArray& csv) {
    const QString path = m_explanations.whereToWrite(m_exchange.suggestion() + QStringLiteral(".csv"));
    if (path.isEmpty()) {
        return;
    }
    const std::optional<Error> error = writeFileOrStream(path.toStdString(), csv.toStdString());
    m_message.say(error ? MessageBar::Tone::Error : MessageBar::Tone::Info,
                  error ? sentence(*error) : tr("The plots are in “%1”.").arg(path));
}

} // namespace spacetow
