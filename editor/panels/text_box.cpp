#include "editor/panels/text_box.h"

#include "editor/panels/history_keys.h"

namespace spacetow {

TextBox::TextBox(QWidget* parent) : QPlainTextEdit(parent) {
    setTabChangesFocus(true);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

void TextBox::setValue(const QString& text) {
    if (!(hasFocus() && document()->isModified()) && text != toPlainText()) {
        setPlainText(text);
        document()->setModified(false);
    }
}

QSize TextBox::sizeHint() const {
    constexpr int lines = 4;
    const int around = 2 * (frameWidth() + static_cast<int>(document()->documentMargin()));
    return {160, lines * fontMetrics().lineSpacing() + around};
}

bool TextBox::event(QEvent* event) {
    return isHistoryOfLevel(*event, document()->isModified()) ? false : QPlainTextEdit::event(event);
}

void TextBox::focusOutEvent(QFocusEvent* event) {
    QPlainTextEdit::focusOutEvent(event);
    if (document()->isModified() && event->reason() != Qt::PopupFocusReason) {
        document()->clearUndoRedoStacks();
        document()->setModified(false);
        Q_EMIT entered(toPlainText());
    }
}

} // namespace spacetow
