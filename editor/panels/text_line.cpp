#include "editor/panels/text_line.h"

#include "editor/panels/history_keys.h"

namespace spacetow {

TextLine::TextLine(QWidget* parent) : QLineEdit(parent) {
    connect(this, &QLineEdit::returnPressed, this, &TextLine::commit);
}

void TextLine::setValue(const QString& text) {
    m_value = text;
    if (!(hasFocus() && isModified())) {
        revert();
    }
}

void TextLine::revert() {
    if (isModified() || m_value != text()) {
        setText(m_value);
    }
    setModified(false);
}

void TextLine::commit() {
    if (isModified()) {
        m_value = text();
        setText(m_value); // forgets how it was typed
        setModified(false);
        Q_EMIT entered(m_value);
    }
}

bool TextLine::event(QEvent* event) {
    return isHistoryOfLevel(*event, isModified()) ? false : QLineEdit::event(event);
}

void TextLine::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && isModified()) {
        revert();
        selectAll();
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void TextLine::focusOutEvent(QFocusEvent* event) {
    if (event->reason() != Qt::PopupFocusReason) {
        commit();
    }
    QLineEdit::focusOutEvent(event);
}

} // namespace spacetow
