#include "editor/panels/tag_chip.h"

#include "editor/panels/names.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace spacetow {

namespace {

constexpr int side = 8;        // px beside the text
constexpr int dot = 10;        // px
constexpr int gapAfterDot = 6; // px between dot and text
constexpr int widest = 220;    // px

/// Black or white, whichever is read better on the colour.
QColor inkOn(const QColor& color) {
    const double light = 0.2126 * color.redF() + 0.7152 * color.greenF() + 0.0722 * color.blueF();
    return light > 0.45 ? QColor(16, 20, 28) : QColor(255, 255, 255);
}

} // namespace

TagChip::TagChip(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
}

void TagChip::setTag(const QString& name, const QColor& color) {
    m_color = color;
    if (name != m_name) {
        m_name = name;
        setText(menuSafe(name));
        setAccessibleName(name);
        updateGeometry();
    }
    update();
}

void TagChip::setState(State state) {
    m_state = state;
    update();
}

void TagChip::setExcepting(bool excepting) {
    m_excepting = excepting;
    update();
}

QSize TagChip::sizeHint() const {
    const int words = fontMetrics().horizontalAdvance(m_name);
    return {std::min(widest, words + 2 * side + dot + gapAfterDot), fontMetrics().height() + 8};
}

void TagChip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    QPainterPath plate;
    plate.addRoundedRect(box, 5, 5);
    const QColor ground = palette().color(underMouse() && isEnabled() ? QPalette::Midlight : QPalette::Button);
    const QColor color = isEnabled() ? m_color : palette().color(QPalette::Mid);
    painter.fillPath(plate, m_state == State::On ? color : ground);
    const QColor ink = m_state == State::On
                           ? inkOn(color)
                           : palette().color(isEnabled() ? QPalette::Normal : QPalette::Disabled, QPalette::ButtonText);
    painter.setPen(
        QPen(hasFocus() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Mid), hasFocus() ? 2 : 1));
    painter.drawPath(plate);

    const QRectF mark(box.left() + side, box.center().y() - dot / 2.0, dot, dot);
    painter.setPen(QPen(m_state == State::On ? ink : color, 1.6));
    painter.setBrush(m_state == State::Off ? Qt::NoBrush : QBrush(m_state == State::On ? ink : color));
    if (isCrossedOut()) {
        const QRectF cross = mark.adjusted(1.5, 1.5, -1.5, -1.5);
        painter.drawLine(cross.topLeft(), cross.bottomRight());
        painter.drawLine(cross.topRight(), cross.bottomLeft());
        QFont font = painter.font();
        font.setStrikeOut(true);
        painter.setFont(font);
    } else if (m_state == State::Mixed) {
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(mark);
        painter.setBrush(color);
        painter.drawChord(mark, 90 * 16, 180 * 16);
    } else {
        painter.drawEllipse(mark);
    }
    painter.setPen(ink);
    const QRectF words = box.adjusted(side + dot + gapAfterDot, 0, -side + 2, 0);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(m_name, Qt::ElideRight, static_cast<int>(words.width()) + 1));
}

void TagChip::mouseDoubleClickEvent(QMouseEvent* event) {
    // The first click has switched the tag; this takes it back.
    QAbstractButton::mousePressEvent(event);
    click();
    Q_EMIT editWanted();
}

void TagChip::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F2) {
        Q_EMIT editWanted();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        click();
    } else {
        QAbstractButton::keyPressEvent(event);
    }
}

} // namespace spacetow
