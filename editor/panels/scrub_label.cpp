#include "editor/panels/scrub_label.h"

#include "editor/panels/number_field.h"

#include <QApplication>
#include <QMouseEvent>

namespace spacetow {

ScrubLabel::ScrubLabel(const QString& text, NumberField& field, QWidget* parent)
    : QLabel(text, parent), m_field(field) {
    setTextFormat(Qt::PlainText);
    setCursor(Qt::SizeHorCursor);
    setBuddy(&field);
    setStatusTip(tr("Drag: change the number · Shift: a tenth as fast · Ctrl: in whole steps · Escape: take it back"));
}

bool ScrubLabel::event(QEvent* event) {
    const bool isLost = event->type() == QEvent::Hide || event->type() == QEvent::EnabledChange ||
                        event->type() == QEvent::WindowDeactivate;
    if (isLost && m_pressed) {
        m_pressed = false;
        m_field.endScrub(false);
    }
    return QLabel::event(event);
}

void ScrubLabel::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        m_pressed = true;
        m_began = false;
        m_pressedAt = qRound(event->globalPosition().x());
        m_field.setFocus(Qt::MouseFocusReason); // what is typed elsewhere is entered, and Escape comes to the field
        event->accept();
    }
}

void ScrubLabel::mouseMoveEvent(QMouseEvent* event) {
    const int pixels = qRound(event->globalPosition().x()) - m_pressedAt;
    if (!m_pressed) {
        return;
    }
    if (!m_began && std::abs(pixels) >= QApplication::startDragDistance()) {
        m_began = true;
        m_field.beginScrub();
        m_pressedAt += pixels; // from here on, so that nothing jumps
    } else if (m_field.isScrubbing()) {
        m_field.scrub(pixels, event->modifiers());
    }
}

void ScrubLabel::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_pressed) {
        return;
    }
    m_pressed = false;
    if (m_field.isScrubbing()) {
        m_field.endScrub(true);
    } else if (!m_began) {
        m_field.selectAll();
    }
}

} // namespace spacetow
