#pragma once
// Undo and redo belong to a field while something is being typed into it, and to the level as soon as it is entered.

#include <QKeyEvent>

namespace spacetow {

/// Whether the event is a key that undoes or redoes and the field is to leave it to the window; it is then ignored.
inline bool isHistoryOfLevel(QEvent& event, bool isBeingTyped) {
    if (isBeingTyped || (event.type() != QEvent::ShortcutOverride && event.type() != QEvent::KeyPress)) {
        return false;
    }
    auto& key = static_cast<QKeyEvent&>(event);
    if (!key.matches(QKeySequence::Undo) && !key.matches(QKeySequence::Redo)) {
        return false;
    }
    event.ignore();
    return true;
}

} // namespace spacetow
