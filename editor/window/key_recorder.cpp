#include "editor/window/key_recorder.h"

#include "editor/canvas/key_place.h"

#include <QKeyEvent>

namespace spacetow {

namespace {

bool leadsOut(const QKeyEvent& stroke) {
    return (stroke.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier &&
           (stroke.key() == Qt::Key_Tab || stroke.key() == Qt::Key_Backtab || stroke.key() == Qt::Key_Escape);
}

} // namespace

QKeySequence keyOfStroke(const QKeyEvent& stroke) {
    int key = stroke.key();
    switch (key) {
    case 0:
    case Qt::Key_unknown:
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_AltGr:
    case Qt::Key_Meta:
    case Qt::Key_Super_L:
    case Qt::Key_Super_R:
    case Qt::Key_Hyper_L:
    case Qt::Key_Hyper_R:
    case Qt::Key_CapsLock:
    case Qt::Key_NumLock:
    case Qt::Key_ScrollLock:
        return {};
    default:
        break;
    }
    Qt::KeyboardModifiers modifiers = stroke.modifiers() & ~Qt::GroupSwitchModifier;
    if (key >= 0x80 && key < Qt::Key_Escape) {
        key = latinKey(stroke); // a letter that other keyboards do not have
    }
    // Shift is in the character already, as in "!", but not in a letter.
    const bool isSign = key < 0x80 && key > Qt::Key_Space && !(key >= Qt::Key_A && key <= Qt::Key_Z);
    if (isSign && modifiers.testFlag(Qt::ShiftModifier) && !modifiers.testFlag(Qt::KeypadModifier)) {
        modifiers &= ~Qt::ShiftModifier;
    }
    return QKeySequence(QKeyCombination(modifiers, static_cast<Qt::Key>(key)));
}

KeyRecorder::KeyRecorder(QWidget* parent) : QLineEdit(parent) {
    setReadOnly(true);
    setPlaceholderText(tr("Press a key"));
    setAccessibleName(tr("New key"));
    setAttribute(Qt::WA_InputMethodEnabled, false);
}

void KeyRecorder::forget() {
    m_key = QKeySequence();
    clear();
}

/// What is a shortcut elsewhere is a key like any other here. Tab and Escape lead out again.
bool KeyRecorder::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && !leadsOut(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    return QLineEdit::event(event);
}

void KeyRecorder::keyPressEvent(QKeyEvent* event) {
    if (leadsOut(*event)) {
        event->ignore();
        return;
    }
    event->accept();
    const QKeySequence key = keyOfStroke(*event);
    if (!key.isEmpty() && !event->isAutoRepeat()) {
        m_key = key;
        setText(key.toString(QKeySequence::NativeText));
        Q_EMIT recorded(key);
    }
}

void KeyRecorder::contextMenuEvent(QContextMenuEvent* event) {
    event->accept(); // there is nothing to copy or paste
}

} // namespace spacetow
