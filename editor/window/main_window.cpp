#include "editor/window/main_window.h"

#include "core/level/bounds.h"
#include "editor/window/keys_dialog.h"
#include "editor/window/messages.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QKeyEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>

namespace spacetow {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), m_toolbox(m_document), m_actions(*this), m_column(&m_center),
      m_inspectorDock(tr("Inspector")), m_problemsDock(tr("Problems")), m_recent(tr("Open &Recent")),
      m_canvas(m_document, m_toolbox), m_inspector(m_document),
      m_problems(m_document, [](const Problem& problem) { return sentence(problem); }),
      m_files(m_document, dialogQuestions(this),
              [this](MessageBar::Tone tone, const QString& text) { m_message.say(tone, text); }) {
    setAcceptDrops(true);
    layOut();
    makeMenus();
    makeToolBars();
    listen();
    connectFiles();
    connectEdits();
    connectTools();
    connectView();
    connectPlay();
    restoreGeometry(m_files.preferences.geometry());
    restoreState(m_files.preferences.windowState());
    updateTitle();
    updateHistory();
    updateTool();
    updateSelection();
    updateSituation();
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
    m_toolbox.cancel();
    m_problems.check();
    if (m_problems.errors() > 0) {
        m_message.say(
            MessageBar::Tone::Warning,
            tr("The level has %n errors and may not play as it should; see Problems.", nullptr, m_problems.errors()));
    }
    m_play.setOverlays(overlays());
    m_play.start(*m_document.current().level);
    m_stack.setCurrentWidget(&m_play);
    m_play.setFocus();
    updateSituation();
}

void MainWindow::stopPlaying() {
    m_play.stop();
    if (!isPlaying()) {
        return;
    }
    m_stack.setCurrentWidget(&m_canvas);
    m_canvas.setFocus();
    updateSituation();
}

void MainWindow::finish(const std::optional<FinishedEdit>& finished) {
    m_toolbox.finish(finished);
}

void MainWindow::enterTyping() {
    const QPointer<QWidget> typing = focusWidget();
    if (typing && (m_inspectorDock.isAncestorOf(typing) || m_problemsDock.isAncestorOf(typing))) {
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

void MainWindow::showAbout() {
    QMessageBox box(this);
    box.setWindowTitle(tr("About SpaceTow Studio"));
    box.setIconPixmap(windowIcon().pixmap(72, 72));
    box.setTextFormat(Qt::PlainText);
    box.setText(tr("SpaceTow Studio %1").arg(QCoreApplication::applicationVersion()));
    box.setInformativeText(tr("Draw levels and fly them: a level editor and physics sandbox.\n\n"
                              "Free software under the MIT license. Made with Qt %1 and Eigen.")
                               .arg(QString::fromLatin1(qVersion())));
    box.addButton(tr("&Close"), QMessageBox::RejectRole);
    box.exec();
}

void MainWindow::updateHistory() {
    const auto name = [](const QString& verb, bool can, const auto& label) {
        return can ? QStringLiteral("%1: %2").arg(verb, sentence(label())) : verb;
    };
    m_actions[Act::Undo].setText(
        name(tr("&Undo"), m_document.canUndo(), [this]() -> const Label& { return m_document.undoLabel(); }));
    m_actions[Act::Redo].setText(
        name(tr("&Redo"), m_document.canRedo(), [this]() -> const Label& { return m_document.redoLabel(); }));
    m_actions[Act::Undo].setEnabled(!isPlaying() && m_document.canUndo());
    m_actions[Act::Redo].setEnabled(!isPlaying() && m_document.canRedo());
    setWindowModified(m_document.isModified());
}

void MainWindow::updateTitle() {
    setWindowFilePath(m_files.path());
    setWindowTitle(tr("%1[*] - SpaceTow Studio").arg(m_files.name()));
    fillRecent();
}

void MainWindow::updateTool() {
    const auto act = [this] {
        switch (m_toolbox.current()) {
        case ToolId::Select:
            return Act::ToolSelect;
        case ToolId::Edge:
            return Act::ToolEdge;
        case ToolId::Line:
            return Act::ToolLine;
        case ToolId::Polygon:
            return Act::ToolPolygon;
        case ToolId::Circle:
            return Act::ToolCircle;
        case ToolId::Place:
            break;
        }
        return m_toolbox.placeKind() == PlaceKind::Ship      ? Act::PlaceShip
               : m_toolbox.placeKind() == PlaceKind::Payload ? Act::PlacePayload
                                                             : Act::PlaceFinish;
    }();
    m_actions[act].setChecked(true);
    m_status.setHint(isPlaying() ? tr("Playing a copy of the level · F8: back to the editor · Esc: menu")
                                 : sentence(m_toolbox.hint()));
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

void MainWindow::updateSituation() {
    const bool playing = isPlaying();
    m_actions.setSituation(playing, !m_document.selection().empty());
    m_inspector.setEnabled(!playing);
    m_problems.setEnabled(!playing);
    m_recent.setEnabled(!playing);
    updateHistory();
    updateTool();
}

} // namespace spacetow
