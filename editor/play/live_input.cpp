// Keys and mouse of a run.

#include "editor/canvas/key_place.h"
#include "editor/play/live_view.h"
#include "editor/play/pause_menu.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace spacetow {
namespace {

bool isModifierKey(int key) {
    return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_AltGr ||
           key == Qt::Key_Meta || key == Qt::Key_CapsLock;
}

bool isFunctionKey(int key) {
    return key >= Qt::Key_F1 && key <= Qt::Key_F35;
}

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up;
}

} // namespace

bool LiveView::take(QEvent& event) {
    if (!m_run.isRunning()) {
        return false;
    }
    switch (event.type()) {
    case QEvent::ShortcutOverride: {
        // While a game runs its keys are the game's, even where the window has a shortcut on the same letter.
        auto& key = static_cast<QKeyEvent&>(event);
        const bool taken =
            (m_run.isGame() && !isFunctionKey(key.key()) && m_run.keys().meaningOf(key) != PlayKey::None) ||
            (!m_run.isGame() && isTransportKey(key));
        if (taken) {
            key.accept();
        }
        return taken;
    }
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
        return takeKey(static_cast<QKeyEvent&>(event));
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::Wheel:
        return takeMouse(event);
    case QEvent::Leave:
        m_hand.leave();
        break;
    case QEvent::UngrabMouse:
    case QEvent::WindowDeactivate:
        m_hand.loseMouse();
        break;
    case QEvent::FocusOut:
        focusLeft(static_cast<QFocusEvent&>(event).reason());
        break;
    case QEvent::Hide:
        m_hand.loseMouse();
        if (m_run.isGame() && !m_run.isPaused()) {
            openMenu();
        }
        break;
    case QEvent::Show:
        if (!m_menu->isVisible()) {
            m_canvas.setFocus(Qt::OtherFocusReason); // a hidden widget could not take it when the run was started
        }
        break;
    case QEvent::Resize:
        if (m_framing != Framing::Free && m_following) {
            frame();
            m_firstScale = m_canvas.view().scale;
        }
        if (m_menu->isVisible()) {
            m_menu->placeIn(m_canvas.size());
        }
        break;
    default:
        break;
    }
    return false;
}

bool LiveView::takeKey(QKeyEvent& event) {
    if (event.type() == QEvent::KeyRelease && m_rewindKey != 0 && keyNumber(event) == m_rewindKey) {
        if (!event.isAutoRepeat()) {
            m_rewindKey = 0;
            m_run.setRewinding(false);
        }
        return true;
    }
    if (event.type() == QEvent::KeyRelease && !event.isAutoRepeat()) {
        m_run.release(event);
        return m_run.isGame();
    }
    return m_run.isGame() ? takeGameKey(event) : takeSimulationKey(event);
}

bool LiveView::takeGameKey(QKeyEvent& event) {
    const PlayKey meaning = m_run.keys().meaningOf(event);
    if (takeTransport(meaning, event) || event.isAutoRepeat() || takeCommand(meaning)) {
        return true;
    }
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    const Phase phase = m_run.phase();
    if (!m_run.isPaused() && phase == Phase::Won && (meaning == PlayKey::Tow || event.key() == Qt::Key_Return)) {
        m_run.restart();
    } else if (m_run.press(event) || m_run.isPaused()) {
        return true;
    } else if (plain && !isModifierKey(event.key()) && !isFunctionKey(event.key())) {
        m_run.tapIfOver();
    } else {
        event.ignore(); // for the window
    }
    return true;
}

/// What works beside the tools of the editor, too.
bool LiveView::takeTransport(PlayKey meaning, const QKeyEvent& event) {
    switch (meaning) {
    case PlayKey::Slower:
    case PlayKey::Faster:
        m_run.changeSpeed(meaning == PlayKey::Faster);
        return true;
    case PlayKey::FrameBack:
        m_run.stepBack();
        return true;
    case PlayKey::FrameForward:
        m_run.stepOnce();
        return true;
    case PlayKey::Rewind:
        if (!event.isAutoRepeat()) {
            m_rewindKey = keyNumber(event);
            m_run.setRewinding(true);
        }
        return true;
    default:
        return false;
    }
}

/// While nothing is half drawn, whose keys these are then.
bool LiveView::isTransportKey(const QKeyEvent& event) const {
    const PlayKey meaning = m_run.keys().meaningOf(event);
    if (m_toolbox.current() == ToolId::Nodes && (meaning == PlayKey::FrameBack || meaning == PlayKey::FrameForward)) {
        return false; // they go from node to node
    }
    return !m_toolbox.isBusy() && !m_toolbox.measures() && event.modifiers() == Qt::NoModifier &&
           (meaning == PlayKey::Slower || meaning == PlayKey::Faster || meaning == PlayKey::FrameBack ||
            meaning == PlayKey::FrameForward || meaning == PlayKey::Rewind);
}

bool LiveView::takeCommand(PlayKey meaning) {
    switch (meaning) {
    case PlayKey::Menu:
        openMenu();
        return true;
    case PlayKey::Pause:
        m_run.setPaused(!m_run.isPaused());
        return true;
    case PlayKey::Step:
        m_run.stepOnce();
        return true;
    case PlayKey::Restart:
        m_run.restart();
        return true;
    case PlayKey::Follow:
        follow();
        return true;
    default:
        return false;
    }
}

/// The editor keeps its keys; arrows steer a ship as long as there is nothing that they would move.
bool LiveView::takeSimulationKey(QKeyEvent& event) {
    if (isTransportKey(event)) {
        return takeTransport(m_run.keys().meaningOf(event), event);
    }
    if (!isArrow(event.key()) || event.modifiers().testFlag(Qt::ControlModifier) || !isSteering()) {
        return false;
    }
    if (!event.isAutoRepeat()) {
        m_run.press(event);
    }
    return true;
}

bool LiveView::isSteering() const {
    return m_run.phase() != Phase::Sandbox && m_document.selection().empty();
}

bool LiveView::takeMouse(QEvent& event) {
    if (m_menu->isVisible()) {
        return true;
    }
    if (event.type() == QEvent::Wheel) {
        return false;
    }
    auto& mouse = static_cast<QMouseEvent&>(event);
    const Pointer pointer = m_canvas.pointerAt(mouse.position(), mouse.modifiers());
    if (event.type() == QEvent::MouseMove) {
        if (m_hand.isPressed() && !mouse.buttons().testFlag(Qt::LeftButton)) {
            m_hand.loseMouse(); // the release went to somebody else
        }
        if (m_hand.isPressed() || (!isGame() && !showsTool())) {
            m_hand.move(pointer);
            m_canvas.update();
        }
        return false; // the canvas tells where the pointer is
    }
    if (mouse.button() != Qt::LeftButton) {
        return false;
    }
    if (event.type() == QEvent::MouseButtonRelease) {
        const bool mine = m_hand.isPressed();
        m_hand.release(pointer);
        return mine;
    }
    return takePress(pointer);
}

bool LiveView::takePress(const Pointer& pointer) {
    if (showsTool() || m_canvas.isPanning()) {
        return false;
    }
    m_canvas.setFocus(Qt::MouseFocusReason);
    const bool over = m_run.phase() == Phase::Crashed || m_run.phase() == Phase::GameOver;
    if (isGame() && over) {
        m_run.tapIfOver();
    } else {
        m_hand.press(pointer);
    }
    return true;
}

void LiveView::openMenu() {
    if (m_run.isRunning()) {
        m_run.setPaused(true);
        m_run.letGo(); // the releases will go to the menu
        m_menu->openFor(m_run.phase());
        m_canvas.update();
    }
}

void LiveView::closeMenu() {
    m_menu->hide();
    m_run.setPaused(false);
    m_canvas.setFocus(Qt::OtherFocusReason);
}

void LiveView::focusLeft(Qt::FocusReason reason) {
    m_hand.loseMouse();
    m_rewindKey = 0;
    m_run.setRewinding(false);
    m_run.letGo();
    // Going to the menu, or to a menu of the window that will give the focus back, is not going away.
    const bool away = reason != Qt::PopupFocusReason && reason != Qt::OtherFocusReason;
    if (!m_run.isGame() || !away || m_run.isWaiting() || m_menu->isVisible()) {
        return;
    }
    if (reason == Qt::ActiveWindowFocusReason) {
        openMenu();
    } else {
        m_run.setPaused(true); // for a panel, beside which the scene stays in sight
    }
}

} // namespace spacetow
