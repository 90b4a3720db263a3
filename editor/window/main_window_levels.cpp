// Which level the window shows: how one comes in, what stands in place of one, and how it leaves.
#include "editor/exchange/capsule_text.h"
#include "editor/window/application.h"
#include "editor/window/dropped_files.h"
#include "editor/window/main_window.h"
#include "editor/window/welcome_page.h"

#include <QDir>
#include <QDragEnterEvent>
#include <QMimeData>

#include <algorithm>

namespace spacetow {

bool MainWindow::open(const FileToOpen& file) {
    stopPlaying();
    enterTyping();
    finishDrawing();
    m_message.dismiss();
    if (kindOfFile(file) == FileKind::Foreign) {
        importFile(file.path);
        return true;
    }
    return file.path.startsWith(QStringLiteral(":/")) ? openShipped(file.path) : m_files.open(file);
}

void MainWindow::importFile(const QString& path) {
    stopPlaying();
    enterTyping();
    finishDrawing();
    m_message.dismiss();
    leaveWelcome();
    m_exchange.importFile(path);
}

void MainWindow::openFiles(const QStringList& paths) {
    m_fileReader.read(paths, [this](const std::vector<FileToOpen>& files) {
        if (!files.empty()) {
            openAll(files);
        }
    });
}

void MainWindow::openAll(const std::vector<FileToOpen>& files) {
    enterTyping();
    finishDrawing();
    m_message.dismiss();
    if (m_application != nullptr) {
        m_application->openAll(files, *this);
    } else if (!files.empty()) {
        open(files.front());
    }
}

MainWindow* MainWindow::openAside(const QString& path) {
    if (m_application != nullptr) {
        return m_application->open(path, *this);
    }
    return open(path) ? this : nullptr;
}

void MainWindow::startNew() {
    enterTyping();
    finishDrawing();
    m_message.dismiss();
    if (m_application != nullptr) {
        m_application->startNew(*this);
    } else {
        m_files.startNew();
    }
}

void MainWindow::openExample() {
    const QStringList levels =
        QDir(QStringLiteral(":/levels")).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name);
    if (!levels.isEmpty()) {
        m_files.openExample(QStringLiteral(":/levels/") + levels.front());
    }
}

bool MainWindow::openShipped(const QString& resource) {
    if (!m_files.openExample(resource)) {
        return false;
    }
    const Level& level = *m_document.current().level;
    if (firstOf<ShipObject>(level) == nullptr && !level.description.empty()) {
        const QString words = QString::fromStdString(level.description);
        m_message.say(MessageBar::Tone::Info, words, {{tr("Simulate"), [this, words] {
                                                           m_message.say(MessageBar::Tone::Info, words);
                                                           isPlaying() ? m_run.restart() : simulate();
                                                       }}});
    }
    return true;
}

WelcomePage& MainWindow::welcome() {
    if (!m_welcome) {
        m_welcome = std::make_unique<WelcomePage>();
        m_stack.addWidget(m_welcome.get());
        connect(m_welcome.get(), &WelcomePage::newWanted, this, &MainWindow::startNew);
        connect(m_welcome.get(), &WelcomePage::openWanted, &m_actions[Act::Open], &QAction::trigger);
        connect(m_welcome.get(), &WelcomePage::fileWanted, this, [this](const QString& path) { openFiles({path}); });
        connect(m_welcome.get(), &WelcomePage::exampleWanted, this,
                [this](const QString& resource) { openShipped(resource); });
    }
    return *m_welcome;
}

bool MainWindow::isWelcoming() const {
    return m_welcome && m_stack.currentWidget() == m_welcome.get();
}

void MainWindow::showWelcome() {
    if (isWelcoming() || !m_open->isUntouched()) {
        return;
    }
    stopPlaying();
    m_message.dismiss();
    m_files.startOver();
    welcome().refresh();
    m_panels->setAway(true);
    m_stack.setCurrentWidget(m_welcome.get());
    m_welcome->setFocus();
    updateTitle();
    updateMode();
}

/// From the welcome page or a game.
void MainWindow::showBoard() {
    m_stack.setCurrentWidget(&m_frame);
    placePanels();
    m_canvas.setFocus();
    updateTitle();
    updateMode();
}

void MainWindow::leaveWelcome() {
    if (!isWelcoming()) {
        return;
    }
    showBoard();
}

void MainWindow::finishWork() {
    enterTyping();
    m_arrays.cancel();
    m_exchange.cancel();
    m_canvas.loseMouse();
    finishDrawing();
}

bool MainWindow::mayClose() {
    finishWork();
    return m_open->views().size() > 1 || m_files.mayLeave();
}

void MainWindow::closeUnasked() {
    m_mayClose = true;
    close();
}

void MainWindow::comeForward() {
    setWindowState(windowState() & ~Qt::WindowMinimized);
    show();
    raise();
    activateWindow();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (std::ranges::any_of(urls, &QUrl::isLocalFile) || holdsCapsule(event->mimeData()->text().toStdString())) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            paths << url.toLocalFile();
        }
    }
    if (!paths.isEmpty()) {
        event->acceptProposedAction();
        openDropped(paths, *this);
    } else if (std::string text = event->mimeData()->text().toStdString(); holdsCapsule(text)) {
        event->acceptProposedAction();
        m_bugCapsule.open(std::move(text));
    }
}

} // namespace spacetow
