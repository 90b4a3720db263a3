#include "editor/window/main_window.h"

#include "core/level/bounds.h"
#include "editor/window/messages.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QKeyEvent>
#include <QMimeData>
#include <QPointer>
#include <QScreen>

namespace spacetow {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), m_wardrobe(Preferences().appearance()), m_toolbox(m_document), m_actions(*this),
      m_column(&m_center), m_frame(m_document, m_toolbox), m_canvas(m_frame.canvas()),
      m_inspector(m_document, [](const Error& error) { return sentence(error); }), m_tagMatrix(m_document),
      m_collisions(m_document, m_canvas),
      m_problems(m_document, [](const Problem& problem) { return sentence(problem); }), m_nodes(m_document),
      m_outliner(m_document, m_toolbox),
      m_history(m_document, m_toolbox, [](const Label& label) { return sentence(label); }),
      m_levelPanel(m_document, [](const Error& error) { return sentence(error); }), m_differences(m_document, m_canvas),
      m_arrays(m_document, m_toolbox), m_transform(m_document, m_toolbox), m_guideBar(m_document),
      m_files(m_document, dialogQuestions(this),
              [this](MessageBar::Tone tone, const QString& text) { m_message.say(tone, text); }) {
    setAcceptDrops(true);
    layOut();
    makeMenus();
    makeToolBars();
    restore();
    listen();
    listenToPanels();
    updateTitle();
    updateOrigin();
    updateSelection();
    updateMode();
    m_canvas.setFocus();
}

MainWindow::~MainWindow() {
    m_play.stop();
    hide(); // what is being typed is entered while all that listens still lives
    for (QWidget* widget : std::initializer_list<QWidget*>{&m_canvas, &m_play, &m_problems, &m_status}) {
        widget->blockSignals(true);
    }
}

void MainWindow::layOut() {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(0);
    m_column.addWidget(&m_message);
    m_column.addWidget(&m_arrays);
    m_column.addWidget(&m_transform);
    m_column.addWidget(&m_guideBar);
    m_column.addWidget(&m_stack, 1);
    m_stack.addWidget(&m_frame);
    m_stack.addWidget(&m_play);
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
    if (const QScreen* monitor = screen()) {
        resize(firstSize(monitor->availableGeometry().size()));
    }
}

QSize MainWindow::firstSize(const QSize& available) {
    constexpr QSize wanted(1280, 800);
    constexpr QSize frame(16, 48); // what the desktop puts round a window, at most
    return wanted.boundedTo(available - frame);
}

bool MainWindow::open(const QString& path) {
    stopPlaying();
    enterTyping();
    finishDrawing();
    m_message.dismiss();
    return m_files.open(path);
}

void MainWindow::openExample() {
    const QStringList levels =
        QDir(QStringLiteral(":/levels")).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name);
    if (!levels.isEmpty()) {
        m_files.openExample(QStringLiteral(":/levels/") + levels.front());
    }
}

void MainWindow::play() {
    if (isPlaying()) {
        return;
    }
    enterTyping();
    m_arrays.cancel();
    m_transform.hide();
    m_guideBar.dismiss();
    finishDrawing();
    m_problems.check();
    if (m_problems.errors() > 0) {
        m_message.say(
            MessageBar::Tone::Warning,
            tr("The level has %n errors and may not play as it should; see Problems.", nullptr, m_problems.errors()));
    }
    m_play.start(*m_document.current().level);
    m_panels->setAway(true);
    m_stack.setCurrentWidget(&m_play);
    m_play.setFocus();
    updateMode();
}

void MainWindow::stopPlaying() {
    m_play.stop();
    if (!isPlaying()) {
        return;
    }
    m_stack.setCurrentWidget(&m_frame);
    m_panels->setAway(m_panelsHidden);
    m_canvas.setFocus();
    updateMode();
}

void MainWindow::takeTool(ToolId tool) {
    m_toolbox.choose(tool);
    m_canvas.setFocus();
}

void MainWindow::takeNextOf(std::span<const ToolId> tools) {
    m_toolbox.chooseAmong(tools);
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
    m_wardrobe.setAppearance(appearance);
    m_actions.refresh();
}

void MainWindow::setRulersVisible(bool visible) {
    m_frame.setRulersVisible(visible);
    m_files.preferences.setRulers(visible);
}

void MainWindow::setSnap(const SnapSettings& snap) {
    m_toolbox.snap = snap;
    m_files.preferences.setSnap(snap);
    m_status.setSnap(snap);
    m_actions.refresh();
    m_canvas.update();
}

void MainWindow::setPanelsHidden(bool hidden) {
    m_panelsHidden = hidden;
    m_panels->setAway(hidden || isPlaying());
}

void MainWindow::setOverlays(const OverlayFlags& overlays) {
    m_overlays = overlays;
    m_canvas.setOverlays(overlays);
    m_play.setOverlays(overlays);
    m_files.preferences.setOverlays(overlays);
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
    } else {
        m_document.select(Selection());
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    enterTyping();
    m_arrays.cancel();
    m_canvas.loseMouse();
    finishDrawing();
    if (!m_files.mayLeave()) {
        event->ignore();
        return;
    }
    m_play.stop();
    m_files.preferences.setWindow(saveGeometry(), m_panels->arrangement());
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.front().isLocalFile()) {
        event->acceptProposedAction();
        open(urls.front().toLocalFile());
    }
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        m_actions.tint(palette());
        m_problems.tint();
        m_differences.tint();
    }
    QMainWindow::changeEvent(event);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (!event->spontaneous()) {
        m_canvas.fitLevel();
    }
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && !isPlaying()) {
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

void MainWindow::updateTitle() {
    setWindowFilePath(m_files.path());
    QString name = m_files.name();
    name.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]")); // once, it would be the mark of a changed file
    setWindowTitle(tr("%1[*] - SpaceTow Studio").arg(name));
    fillRecent();
}

/// What the history begins with.
void MainWindow::updateOrigin() {
    m_history.setOrigin(m_files.path().isEmpty() ? tr("New level") : tr("Opened %1").arg(m_files.name()));
}

void MainWindow::updateTool() {
    m_status.setHint(isPlaying() ? tr("Playing a copy of the level · F8: back to the editor · Esc: menu")
                                 : sentence(m_toolbox.hint()) + snapHint());
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

void MainWindow::updateSelection() {
    const Edit& shown = m_document.shown();
    const Aabb box = boundsOf(*shown.level, shown.selection.keys());
    m_status.setSelection(shown.selection.size(), box);
    m_frame.setExtent(box);
}

void MainWindow::updateMode() {
    const bool playing = isPlaying();
    m_inspector.setEnabled(!playing);
    m_tagMatrix.setEnabled(!playing);
    m_problems.setEnabled(!playing);
    m_nodes.setEnabled(!playing);
    m_outliner.setEnabled(!playing);
    m_history.setEnabled(!playing);
    m_levelPanel.setEnabled(!playing);
    m_differences.setEnabled(!playing);
    m_menus.at(MenuId::Recent)->setEnabled(!playing);
    m_actions.refresh();
    updateTool();
}

} // namespace spacetow
