#include "editor/window/main_window.h"

#include "core/level/bounds.h"
#include "editor/window/messages.h"
#include "editor/window/screen_room.h"
#include "editor/window/state_folder.h"
#include "editor/window/welcome_page.h"

#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QLayout>
#include <QLocale>
#include <QPointer>
#include <QScreen>

#include <utility>

namespace spacetow {

MainWindow::MainWindow(std::shared_ptr<OpenLevel> level, Application* application)
    : m_wardrobe(wardrobe()), m_application(application),
      m_open(level ? std::move(level) : std::make_shared<OpenLevel>()), m_document(m_open->document),
      m_files(m_open->files), m_toolbox(m_document), m_actions(*this), m_column(&m_center),
      m_frame(m_document, m_toolbox), m_canvas(m_frame.canvas()), m_live(m_document, m_toolbox, m_canvas, m_run),
      m_inspector(m_document, [](const Error& error) { return sentence(error); }), m_tagMatrix(m_document),
      m_collisions(m_document, m_canvas), m_reach(m_document, m_canvas, m_run),
      m_problems(
          m_open->check, [](const Problem& problem) { return sentence(problem); },
          [](const Label& label) { return sentence(label); }),
      m_nodes(m_document), m_outliner(m_document, m_toolbox),
      m_history(m_document, m_toolbox, [](const Label& label) { return sentence(label); }),
      m_levelPanel(m_document, [](const Error& error) { return sentence(error); }),
      m_flights(m_document, [](const Error& error) { return sentence(error); }), m_differences(m_document, m_canvas),
      m_runChanges(m_open->runChanges, m_document, m_canvas), m_explanations(m_document, m_canvas, m_tagMatrix),
      m_minimap(m_document, m_canvas),
      m_recoveryBar(journalFolder(), [this](const JournalEntry& entry) { return restoreWork(entry); }),
      m_arrays(m_document, m_toolbox), m_transform(m_document, m_toolbox), m_guideBar(m_document),
      m_exchange(m_document, m_toolbox, m_canvas,
                 [this](MessageBar::Tone tone, const QString& text) { m_message.say(tone, text); }),
      m_bugCapsule(*this), m_flightFile(*this), m_flightReader(*this), m_fileReader(m_message), m_legend(m_canvas) {
    setAcceptDrops(true);
    layOut();
    makeMenus();
    makeToolBars();
    restore();
    listen();
    listenToPanels();
    listenToDisk();
    listenToRunChanges();
    m_view = m_open->add(*this);
    setWindowModified(m_document.isModified());
    updateTitle();
    updateOrigin();
    updateSelection();
    updateMode();
    if (const QScreen* monitor = screen(); monitor != nullptr && m_files.preferences.geometry().isEmpty()) {
        layout()->invalidate(); // it holds to what the panels asked for before they were tabs
        layout()->activate();
        resize(firstSize(monitor->availableGeometry().size()));
        m_panels->widenInspector();
    }
    m_canvas.setFocus();
}

MainWindow::~MainWindow() {
    m_run.stop();
    m_live.hide();
    hide(); // what is being typed is entered while all that listens still lives
    m_document.changed.disconnect(m_documentListener);
    m_document.changed.disconnect(m_runListener);
    m_document.historyChanged.disconnect(m_historyListener);
    m_files.changed.disconnect(m_fileListener);
    m_files.opened.disconnect(m_openedListener);
    m_open->disk.noticed.disconnect(m_noticeListener);
    m_open->remove(*this);
    for (QObject* widget : std::initializer_list<QObject*>{&m_canvas, &m_run, &m_live, &m_problems, &m_status,
                                                           &m_explanations.panel(), &m_explanations.plots()}) {
        widget->blockSignals(true);
    }
}

void MainWindow::layOut() {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(0);
    m_column.addWidget(&m_recoveryBar);
    m_column.addWidget(&m_diskBar);
    m_column.addWidget(&m_message);
    m_column.addWidget(&m_arrays);
    m_column.addWidget(&m_transform);
    m_column.addWidget(&m_guideBar);
    m_column.addWidget(&m_exchange.importBar());
    m_column.addWidget(&m_exchange.exportBar());
    m_column.addWidget(&m_stack, 1);
    m_column.addWidget(&m_timeline);
    m_timeline.hide();
    m_stack.addWidget(&m_frame);
    setCentralWidget(&m_center);
    setStatusBar(&m_status);

    setDockOptions(QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks); // at once, without sliding about
    const auto words = [](const Error& error) { return sentence(error); };
    m_nodes.setWords(words);
    m_arrays.setWords(words);
    m_transform.setWords(words);
    m_guideBar.setWords(words);
    m_tagMatrix.setAction(m_actions[Act::ShowCollisions]);
    m_panels.emplace(*this);
    m_actions.know(m_panels->actions());
    m_finder.emplace(*this);
}

QSize MainWindow::firstSize(const QSize& available) {
    return withinScreen({1280, 800}, available);
}

void MainWindow::takeTool(ToolId tool) {
    m_toolbox.choose(tool);
    m_canvas.setFocus();
}

void MainWindow::takePlaceTool() {
    m_toolbox.choosePlaceTool();
    m_canvas.setFocus();
}

void MainWindow::setGridVisible(bool visible) {
    m_canvas.setGridVisible(visible);
    m_files.preferences.setGrid(visible);
}

void MainWindow::setGuidesVisible(bool visible) {
    m_canvas.setGuidesVisible(visible);
    m_files.preferences.setGuides(visible);
    if (!visible) {
        m_guideBar.dismiss();
    }
}

void MainWindow::openGuide(std::size_t index) {
    setGuidesVisible(true);
    m_guideBar.open(index);
    m_actions.refresh();
}

void MainWindow::setAppearance(Appearance appearance) {
    m_files.preferences.setAppearance(appearance);
    m_wardrobe->setAppearance(appearance);
    m_actions.refresh();
}

void MainWindow::setRulersVisible(bool visible) {
    m_frame.setRulersVisible(visible);
    m_files.preferences.setRulers(visible);
}

void MainWindow::setSnap(const SnapSettings& snap) {
    m_toolbox.snap = snap;
    SnapSettings kept = snap;
    kept.smart = snap.smart || (isPlaying() && m_smartBefore); // which rests while something runs
    m_files.preferences.setSnap(kept);
    m_status.setSnap(snap);
    m_actions.refresh();
    m_canvas.update();
}

void MainWindow::updateKeys() {
    const KeyBindings bindings = m_files.preferences.keyBindings();
    m_actions.setKeys(bindings);
    m_panels->setKeys(bindings);
    m_live.setKeys(playKeysOf(bindings));
    m_canvas.setBeginning(firstSteps());
    updateTool(); // the hint names some of them
}

/// Who looks at an empty level does not know where to begin.
QString MainWindow::firstSteps() const {
    const auto key = [this](ActionId id) {
        const QString keys = m_actions[id].shortcut().toString(QKeySequence::NativeText);
        return keys.isEmpty() ? m_actions[id].iconText() : keys;
    };
    return tr("Here begins a new level.\n"
              "%1: draw the walls of a cave, anticlockwise\n"
              "%2: place ship, payload and finish\n"
              "%3: play\n"
              "%4, %5: draw boxes and balls\n"
              "%6: simulate\n"
              "%7: find everything else")
        .arg(key(wallTool), key(Act::PlaceNext), key(Act::Play), key(solidTools[0]), key(solidTools[1]),
             key(Act::Simulate), key(Act::CommandPalette));
}

void MainWindow::setPanelsHidden(bool hidden) {
    (isInGame() ? m_panelsInGame : m_panelsHidden) = isInGame() ? !hidden : hidden;
    placePanels();
    updateMode();
}

void MainWindow::finishDrawing() {
    if (m_toolbox.isBusy() && !m_toolbox.isDragging()) {
        m_canvas.toolKey(ToolKey::Enter);
    }
    m_toolbox.cancel();
}

void MainWindow::enterTyping() {
    const QPointer<QWidget> typing = focusWidget();
    if (typing &&
        (m_panels->holding(typing) != nullptr || m_transform.isAncestorOf(typing) || m_guideBar.isAncestorOf(typing))) {
        typing->clearFocus(); // fields enter their text when they lose the focus
        if (typing && typing->isVisible()) {
            typing->setFocus();
        }
    }
}

void MainWindow::showObject(Key key) {
    if (m_document.level().objects.find(key) != nullptr) {
        m_document.select(Selection({key}));
        m_canvas.centerSelection();
        const Aabb box = boundsOf(m_document.level(), m_document.selection().keys());
        const double size = box.isEmpty() ? 0 : box.size().maxCoeff() * m_canvas.view().scale;
        constexpr double least = 24; // px, of what can be made out
        if (!box.isEmpty() && (size < least || size > std::min(m_canvas.width(), m_canvas.height()))) {
            m_canvas.frameSelection();
        }
    } else {
        m_document.select(Selection());
    }
}

/// What was seen stays in sight, unless that is somewhere else.
void MainWindow::showCured(Key key) {
    const Aabb box = boundsOf(m_document.level(), std::vector<Key>{key});
    if (!box.isEmpty() && !box.overlaps(m_canvas.view().visible())) {
        showObject(key);
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_mayClose && !mayClose()) {
        event->ignore();
        return;
    }
    stopPlaying();
    if (m_open->views().size() <= 1) {
        m_open->recovery.close();
    }
    m_files.preferences.setWindow(saveGeometry(), m_panels->arrangement());
    event->accept();
    Q_EMIT closing();
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        updateLegend();
        m_actions.tint(palette());
        m_actions.refresh();
    } else if (event->type() == QEvent::ActivationChange && isActiveWindow()) {
        m_open->bringToFront(*this);
        m_actions.refresh(); // of what is possible, some depends on other windows
    }
    QMainWindow::changeEvent(event);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (!event->spontaneous() && !isPlaying()) {
        m_canvas.fitLevel();
    }
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && !isInGame() && !isWelcoming()) {
        m_canvas.setFocus(); // out of the panels
    } else if (!actByPlace(*event)) {
        QMainWindow::keyPressEvent(event);
    }
}

bool MainWindow::actByPlace(const QKeyEvent& stroke) {
    const std::optional<QKeyCombination> key = m_actions.keyByPlace(stroke);
    if (!key) {
        return false;
    }
    // Who is being typed into has copy, undo and the like of his own, and comes first, as with any key.
    QWidget* const typing = focusWidget();
    QKeyEvent offer(QEvent::ShortcutOverride, key->key(), key->keyboardModifiers());
    offer.ignore();
    if (typing != nullptr && QApplication::sendEvent(typing, &offer) && offer.isAccepted()) {
        QKeyEvent press(QEvent::KeyPress, key->key(), key->keyboardModifiers());
        QApplication::sendEvent(typing, &press);
    } else {
        m_actions.withKey(*key)->trigger();
    }
    return true;
}

QString MainWindow::name() const {
    const QString name = isWelcoming() ? tr("Welcome") : m_files.name();
    return m_open->views().size() > 1 ? QStringLiteral("%1: %2").arg(name).arg(m_view) : name;
}

/// How the game stands, for the task bar and for who does not see the picture.
QString MainWindow::playedPhase() const {
    if (!m_inGame) {
        return tr("simulating");
    }
    switch (m_run.phase()) {
    case Phase::Won:
        return tr("won");
    case Phase::Crashed:
        return tr("crashed");
    case Phase::GameOver:
        return tr("game over");
    case Phase::AwaitingInput:
        return tr("ready");
    default:
        return tr("playing");
    }
}

void MainWindow::updateTitle() {
    setWindowFilePath(m_files.path());
    QString shownName = name();
    shownName.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]")); // once, it would be the mark of a changed file
    setWindowTitle(isPlaying() ? tr("%1[*] (%2) - SpaceTow Studio").arg(shownName, playedPhase())
                               : tr("%1[*] - SpaceTow Studio").arg(shownName));
    fillRecent();
}

/// What the history begins with.
void MainWindow::updateOrigin() {
    m_history.setOrigin(m_files.path().isEmpty() ? tr("New level") : tr("Opened %1").arg(m_files.name()));
}

void MainWindow::updateTool() {
    const bool byTool = !isPlaying() || m_live.showsTool() || m_toolbox.isDragging();
    const bool byRun = isGettingReady() || (isPlaying() && (m_run.behind() > 0 || !byTool));
    m_status.setHint(byRun           ? runHint()
                     : isWelcoming() ? tr("No level is open · arrows, Tab and Enter choose one")
                                     : sentence(m_toolbox.hint()) + lockedHint() + snapHint() + solidHint());
    if (m_toolbox.current() != m_shownTool || m_toolbox.isBusy() != m_shownBusy) {
        m_shownTool = m_toolbox.current();
        m_shownBusy = m_toolbox.isBusy();
        m_actions.refresh();
    }
}

/// What else the status bar says while a point snaps to something.
QString MainWindow::snapHint() const {
    const std::optional<SnapAnswer> snap = m_toolbox.snapAnswer();
    const bool worth = snap && snap->kind != SnapKind::Grid;
    return worth ? QStringLiteral(" · ") + tr("snaps to: %1").arg(snapName(*m_document.current().level, *snap))
                 : QString();
}

/// Which key unlocks what the hint says is locked.
QString MainWindow::lockedHint() const {
    const std::string code = m_toolbox.hint().code;
    const QString key = m_actions[Act::UnlockAll].shortcut().toString(QKeySequence::NativeText);
    return (code == "select.locked" || code == "select.all-locked") && !key.isEmpty()
               ? QStringLiteral(" · ") + tr("%1: unlock all").arg(key)
               : QString();
}

/// Of what runs, where it is now.
Aabb MainWindow::boundsOfSelection() {
    const Edit& shown = m_document.shown();
    const std::vector<Key>& keys = shown.selection.keys();
    return isPlaying() && !keys.empty() ? boundsOf(m_live.posedShown(keys), keys) : boundsOf(*shown.level, keys);
}

void MainWindow::updateSelection() {
    const std::vector<Key>& keys = m_document.shown().selection.keys();
    const Aabb box = boundsOfSelection();
    m_run.setFocus(keys.size() == 1 ? keys.front() : 0);
    m_status.setSelection(m_document.shown().selection.size(), box);
    m_frame.setExtent(box);
}

void MainWindow::updateMode() {
    const bool editing = !isWelcoming();
    for (QWidget* panel :
         std::initializer_list<QWidget*>{&m_inspector, &m_tagMatrix, &m_problems, &m_nodes, &m_outliner, &m_history,
                                         &m_levelPanel, &m_flights, &m_differences, &m_runChanges}) {
        panel->setEnabled(editing);
    }
    for (QAction* action : m_panels->actions()) {
        action->setEnabled(editing); // there is nothing that they could show
    }
    m_menus.at(MenuId::Recent)->setEnabled(!isPlaying());
    m_menus.at(MenuId::Backups)->setEnabled(editing && !isPlaying());
    m_status.setBoardShown(editing && !isInGame());
    updateLegend(); // and the actions
    updateTool();
}

} // namespace spacetow
