// Between editing and playing.

#include "editor/window/main_window.h"

#include <utility>

namespace spacetow {

void MainWindow::play() {
    if (!isPlaying()) {
        enterGame(nullptr);
    }
}

void MainWindow::playReplay(const Replay& recorded) {
    stopPlaying();
    enterGame(&recorded);
}

void MainWindow::enterGame(const Replay* recorded) {
    leaveWelcome();
    enterTyping();
    m_arrays.cancel();
    m_exchange.cancel();
    m_transform.hide();
    m_guideBar.dismiss();
    finishDrawing();
    m_errorsUntold = true;
    m_open->check.hurry();
    m_recorded = recorded != nullptr;
    if (m_recorded) {
        m_play.start(*m_document.current().level, *recorded);
    } else {
        m_play.start(*m_document.current().level);
    }
    m_panels->setAway(true);
    m_stack.setCurrentWidget(&m_play);
    m_play.setFocus();
    updateTitle();
    updateMode();
    tellErrors();
}

/// Of the level that is played; once it has been checked, which is not waited for.
void MainWindow::tellErrors() {
    if (!isPlaying() || !m_open->check.isUpToDate() || !std::exchange(m_errorsUntold, false)) {
        return;
    }
    if (m_problems.errors() > 0) {
        m_message.say(
            MessageBar::Tone::Warning,
            tr("The level has %n errors and may not play as it should; see Problems.", nullptr, m_problems.errors()));
    }
}

void MainWindow::stopPlaying() {
    m_play.stop();
    if (!isPlaying()) {
        return;
    }
    showBoard();
}

} // namespace spacetow
