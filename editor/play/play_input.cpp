// Keys and mouse of the play view.

#include "editor/play/pause_menu.h"
#include "editor/play/play_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace spacetow {
namespace {

constexpr double minZoom = 0.1, maxZoom = 10;

bool isModifier(int key) {
    return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_AltGr ||
           key == Qt::Key_Meta || key == Qt::Key_CapsLock;
}

bool isFunctionKey(int key) {
    return key >= Qt::Key_F1 && key <= Qt::Key_F35;
}

} // namespace

bool PlayView::event(QEvent* event) {
    // While a game runs its keys are the game's, even where the window has a shortcut on the same letter.
    if (event->type() == QEvent::ShortcutOverride && m_runner) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (!isFunctionKey(key->key()) && m_keys.meaningOf(*key) != PlayKey::None) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void PlayView::keyPressEvent(QKeyEvent* event) {
    const PlayKey meaning = m_keys.meaningOf(*event);
    if (!m_runner) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (event->isAutoRepeat()) {
        return;
    }
    const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    switch (meaning) {
    case PlayKey::Menu:
        openMenu();
        return;
    case PlayKey::Pause:
        setPaused(!m_paused);
        return;
    case PlayKey::Step:
        stepOnce();
        return;
    case PlayKey::Restart:
        restart();
        return;
    case PlayKey::Follow:
        follow();
        update();
        return;
    default:
        break;
    }
    if (m_paused) {
        m_held.press(*event, m_keys); // for the steps that follow, and when the game goes on
    } else if (phase() == Phase::Won && (meaning == PlayKey::Tow || event->key() == Qt::Key_Return)) {
        restart();
    } else if (m_held.press(*event, m_keys)) {
        m_runner->hold(m_held.controls());
    } else if (plain && !isModifier(event->key()) && !isFunctionKey(event->key())) {
        tapIfOver();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void PlayView::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat() && m_runner) {
        m_held.release(*event);
        m_runner->hold(m_held.controls());
    }
}

void PlayView::tapIfOver() {
    if (phase() == Phase::Crashed || phase() == Phase::GameOver) {
        Controls tap = m_held.controls();
        tap.tow = true;
        m_runner->hold(tap);
        m_runner->hold(m_held.controls());
    }
}

void PlayView::letGo() {
    m_held.clear();
    if (m_runner) {
        m_runner->hold({});
    }
}

void PlayView::openMenu() {
    if (m_runner) {
        setPaused(true);
        letGo(); // the releases will go to the menu
        m_menu->openFor(phase());
        update();
    }
}

void PlayView::closeMenu() {
    m_menu->hide();
    setPaused(false);
    setFocus(Qt::OtherFocusReason);
}

void PlayView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    letGo();
    // Going to the menu, or to a menu of the window that will give the focus back, is not going away.
    const bool away = event->reason() != Qt::PopupFocusReason && event->reason() != Qt::OtherFocusReason;
    if (m_runner && away && !m_waiting && !m_menu->isVisible()) {
        openMenu();
    }
}

void PlayView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    if (m_runner && !m_paused) {
        openMenu();
    }
}

void PlayView::mousePressEvent(QMouseEvent* event) {
    if (!m_runner || m_menu->isVisible()) {
        return;
    }
    setFocus(Qt::MouseFocusReason);
    if (event->button() == Qt::LeftButton) {
        tapIfOver();
    } else {
        m_dragging = true;
        m_dragged = event->position();
    }
}

void PlayView::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging && m_runner) {
        const QPointF step = event->position() - m_dragged;
        m_dragged = event->position();
        m_lookedAt = viewport().panned(Vec2(step.x(), step.y())).center;
        update();
    }
}

void PlayView::mouseReleaseEvent(QMouseEvent*) {
    m_dragging = false;
}

void PlayView::wheelEvent(QWheelEvent* event) {
    if (!m_runner || m_menu->isVisible()) {
        return;
    }
    const double notches = event->angleDelta().y() / 120.0;
    const Viewport before = viewport();
    m_zoom = std::clamp(m_zoom * std::pow(1.2, notches), minZoom, maxZoom);
    // A view that follows the ship zooms about the ship, one that was moved about the pointer.
    if (m_lookedAt) {
        const Vec2 pointer(event->position().x(), event->position().y());
        m_lookedAt = before.zoomedAt(pointer, viewport().scale / before.scale).center;
    }
    event->accept();
    update();
}

} // namespace spacetow
