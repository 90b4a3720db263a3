#pragma once
// Keys that move about in lists and trees, though they do something else on the canvas.

#include <QKeyEvent>

namespace spacetow {

/// Whether the key is to go to the list that has the focus, and not to an action of the window.
inline bool isForLists(const QKeyEvent& key) {
    if ((key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier) {
        return false;
    }
    switch (key.key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return true;
    default:
        return false;
    }
}

/// Claims such a key for a list, before an action of the window takes it; whether the event was about one.
inline bool keepsListKey(QEvent& event) {
    if (event.type() != QEvent::ShortcutOverride || !isForLists(static_cast<const QKeyEvent&>(event))) {
        return false;
    }
    event.accept();
    return true;
}

} // namespace spacetow
