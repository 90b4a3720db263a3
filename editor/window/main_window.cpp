#include "editor/window/main_window.h"

#include "core/level/bounds.h"
#include "editor/window/messages.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QKeyEvent>
#include <QMimeData>
#include <QPointer>

namespace spacetow {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), m_toolbox(m_document), m_actions(*this), m_column(&m_center),
      m_inspectorDock(tr("Inspector")), m_problemsDock(tr("Problems")), m_nodesDock(tr("Nodes")),
      m_canvas(m_document, m_toolbox), m_inspector(m_document),
      m_problems(m_document, [](const Problem& problem) { return sentence(problem); }), m_nodes(m_document),
      m_arrays(m_document, m_toolbox), m_transform(m_document, m_toolbox),
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
    m_column.addWidget(&m_stack, 1);
    m_stack.addWidget(&m_canvas);
    m_stack.addWidget(&m_play);
    setCentralWidget(&m_center);
    setStatusBar(&m_status);

    m_inspectorDock.setObjectName(QStringLiteral("inspector"));
    m_inspectorDock.setWidget(&m_inspector);
    addDockWidget(Qt::RightDockWidgetArea, &m_inspectorDock);
    m_problemsDock.setObjectName(QStringLiteral("problems"));
    m_problemsDock.setWidget(&m_problems);
    addDockWidget(Qt::RightDockWidgetArea, &m_problemsDock);
    m_nodesDock.setObjectName(QStringLiteral("nodes"));
    m_nodesDock.setWidget(&m_nodes);
    tabifyDockWidget(&m_problemsDock, &m_nodesDock);
    m_nodesDock.hide(); // until it is asked for in View ▸ Panels
    resizeDocks({&m_inspectorDock, &m_problemsDock}, {520, 150}, Qt::Vertical);
    resize(sizeHint());
}

bool MainWindow::open(const QString& path) {
    stopPlaying();
    enterTyping();
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
    m_toolbox.cancel();
    m_problems.check();
    if (m_problems.errors() > 0) {
        m_message.say(
            MessageBar::Tone::Warning,
            tr("The level has %n errors and may not play as it should; see Problems.", nullptr, m_problems.errors()));
    }
    m_play.start(*m_document.current().level);
    m_stack.setCurrentWidget(&m_play);
    m_play.setFocus();
    updateMode();
}

void MainWindow::stopPlaying() {
    m_play.stop();
    if (!isPlaying()) {
        return;
    }
    m_stack.setCurrentWidget(&m_canvas);
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

void MainWindow::setSnap(const SnapSettings& snap) {
    m_toolbox.snap = snap;
    m_files.preferences.setSnap(snap);
    m_status.setSnap(snap);
    m_canvas.update();
}

void MainWindow::setOverlays(const OverlayFlags& overlays) {
    m_overlays = overlays;
    m_canvas.setOverlays(overlays);
    m_play.setOverlays(overlays);
    m_files.preferences.setOverlays(overlays);
}

void MainWindow::enterTyping() {
    const QPointer<QWidget> typing = focusWidget();
    if (typing && (m_inspectorDock.isAncestorOf(typing) || m_problemsDock.isAncestorOf(typing) ||
                   m_nodesDock.isAncestorOf(typing))) {
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
    m_toolbox.cancel();
    if (!m_files.mayLeave()) {
        event->ignore();
        return;
    }
    m_play.stop();
    m_files.preferences.setWindow(saveGeometry(), saveState());
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
    } else {
        QMainWindow::keyPressEvent(event);
    }
}

void MainWindow::updateTitle() {
    setWindowFilePath(m_files.path());
    setWindowTitle(tr("%1[*] - SpaceTow Studio").arg(m_files.name()));
    fillRecent();
}

void MainWindow::updateTool() {
    m_status.setHint(isPlaying() ? tr("Playing a copy of the level · F8: back to the editor · Esc: menu")
                                 : sentence(m_toolbox.hint()));
    if (m_toolbox.current() != m_shownTool) {
        m_shownTool = m_toolbox.current();
        m_actions.refresh();
    }
}

void MainWindow::updateSelection() {
    Aabb box;
    const Edit& shown = m_document.shown();
    if (!shown.selection.empty()) {
        for (const Object& object : shown.level->objects) {
            if (shown.selection.contains(object.key)) {
                box.include(boundsOf(*shown.level, object));
            }
        }
    }
    m_status.setSelection(shown.selection.size(), box);
}

void MainWindow::updateMode() {
    const bool playing = isPlaying();
    m_inspector.setEnabled(!playing);
    m_problems.setEnabled(!playing);
    m_nodes.setEnabled(!playing);
    m_menus.at(MenuId::Recent)->setEnabled(!playing);
    m_actions.refresh();
    updateTool();
}

} // namespace spacetow
