// What the window does about files that others change, and about work that was left unsaved.
#include "core/level/bounds.h"
#include "editor/window/application.h"
#include "editor/window/main_window.h"

#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>

namespace spacetow {

void MainWindow::listenToDisk() {
    m_noticeListener = m_open->disk.noticed.connect([this] { showNotice(); });
    connect(&m_diskBar, &MessageBar::dismissed, this, [this] { m_open->disk.dismiss(); });
    connect(&m_recoveryBar, &RecoveryBar::closed, this, [this] { m_canvas.setFocus(); });
    m_recoveryBar.setShow(
        [this](const JournalEntry& entry, const std::shared_ptr<const Level>& found) { showRecovered(entry, found); });
    showNotice();
}

void MainWindow::showNotice() {
    const std::optional<DiskChanges::Notice>& notice = m_open->disk.notice();
    if (notice) {
        m_diskBar.say(notice->tone, notice->text, notice->choices);
    } else {
        m_diskBar.dismiss();
    }
}

void MainWindow::offerRecovery(bool asked) {
    if (asked) {
        connect(
            &m_recoveryBar, &RecoveryBar::nothingFound, this,
            [this] { m_message.say(MessageBar::Tone::Info, tr("Nothing was left unsaved.")); },
            static_cast<Qt::ConnectionType>(Qt::SingleShotConnection));
    }
    m_recoveryBar.look(asked);
}

void MainWindow::compareWith(std::shared_ptr<const Level> other, const QString& name) {
    if (other == nullptr) {
        m_differences.end();
        return;
    }
    m_differences.compareWith(std::move(other), name);
    if (auto* const dock = findChild<QDockWidget*>(QStringLiteral("differences"))) {
        dock->show();
        dock->raise();
    }
}

/// Beside its file, in the window that has it or is free for it; what never had one, beside an empty level.
void MainWindow::showRecovered(const JournalEntry& entry, const std::shared_ptr<const Level>& found) {
    const QString path = QString::fromStdString(entry.path);
    const bool hasFile = !path.isEmpty() && QFileInfo::exists(path);
    MainWindow* const room = hasFile ? openAside(path) : m_open->isUntouched() ? this : nullptr;
    if (room != nullptr) {
        room->stopPlaying();
        room->leaveWelcome();
        room->compareWith(found, tr("what was not saved of %1").arg(QString::fromStdString(entry.name)));
        if (const Aabb box = boundsOf(*found); !hasFile && !box.isEmpty()) {
            room->m_canvas.setView(room->m_canvas.view().showing(box));
        }
    }
}

void MainWindow::keepForNextTime() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* const window = qobject_cast<MainWindow*>(widget)) {
            window->enterTyping();
            window->finishDrawing();
            window->m_open->recovery.flush();
            window->m_files.preferences.setWindow(window->saveGeometry(), window->m_panels->arrangement());
        }
    }
}

bool MainWindow::restoreWork(const JournalEntry& entry) {
    MainWindow& room =
        m_application != nullptr ? m_application->roomToRestore(QString::fromStdString(entry.path), *this) : *this;
    room.stopPlaying();
    room.enterTyping();
    room.finishDrawing();
    room.m_message.dismiss();
    const bool restored = room.m_files.mayLeave() && room.m_files.restore(entry) && room.m_open->recovery.flush();
    room.comeForward();
    return restored;
}

} // namespace spacetow
