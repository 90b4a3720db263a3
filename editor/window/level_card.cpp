#include "editor/window/level_card.h"

#include "editor/canvas/icons.h"
#include "editor/canvas/theme.h"
#include "editor/panels/names.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace spacetow {

namespace {

constexpr int cardMargin = 8; // pixels around picture and words
constexpr int radius = 6;

QFont placeFont(const QFont& font) {
    QFont small = font;
    small.setPointSizeF(0.9 * font.pointSizeF());
    return small;
}

QFont nameFont(const QFont& font) {
    QFont bold = font;
    bold.setBold(true);
    return bold;
}

} // namespace

LevelCard::LevelCard(const QString& path, const QString& name, const QString& place, QWidget* parent)
    : QAbstractButton(parent), m_path(path), m_place(place) {
    setText(menuSafe(name)); // no letter of it is a key
    setAccessibleName(name);
    setAccessibleDescription(place);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setToolTip(plainToolTip(path.startsWith(QLatin1Char(':')) ? name : path));
}

void LevelCard::setPicture(const QPixmap& picture) {
    m_picture = picture;
    update();
}

void LevelCard::setUnreadable(bool unreadable) {
    m_unreadable = unreadable;
    update();
}

QSize LevelCard::sizeHint() const {
    const int words = QFontMetrics(nameFont(font())).height() + QFontMetrics(placeFont(font())).height();
    return {pictureSize.width() + 2 * cardMargin, pictureSize.height() + 3 * cardMargin + words};
}

void LevelCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor window = palette().color(QPalette::Window);
    const QColor ink = palette().color(QPalette::WindowText);
    const QRectF plate = QRectF(rect()).adjusted(1, 1, -1, -1);
    painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight), 2) : QPen(mixed(window, ink, 0.18), 1));
    painter.setBrush(mixed(window, ink, isDown() ? 0.14 : underMouse() ? 0.09 : 0.03));
    painter.drawRoundedRect(plate, radius, radius);

    const QRect frame(QPoint(cardMargin, cardMargin), pictureSize);
    QPainterPath corners;
    corners.addRoundedRect(frame, radius - 2, radius - 2);
    painter.setPen(Qt::NoPen);
    painter.fillPath(corners, editingTheme(shadeOf(palette())).background);
    if (!m_picture.isNull()) {
        painter.setClipPath(corners);
        painter.drawPixmap(frame, m_picture);
        painter.setClipping(false);
    } else if (m_unreadable) {
        const QSize size(32, 32);
        const QPoint middle = frame.center() - QPoint(size.width() / 2, size.height() / 2);
        painter.drawPixmap(middle,
                           spacetow::icon(QStringLiteral("warning"), palette()).pixmap(size, devicePixelRatioF()));
    }

    QRect words(cardMargin, frame.bottom() + cardMargin, pictureSize.width(), 0);
    const auto write = [&](const QFont& font, const QColor& color, const QString& text, Qt::TextElideMode elide) {
        const QFontMetrics metrics(font);
        words.setHeight(metrics.height());
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                         metrics.elidedText(text, elide, words.width()));
        words.translate(0, metrics.height());
    };
    write(nameFont(font()), ink, accessibleName(), Qt::ElideRight);
    write(placeFont(font()), mixed(window, ink, 0.75), m_place, Qt::ElideMiddle);
}

void LevelCard::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        click();
    } else {
        event->ignore(); // arrows are the grid's
        if (event->key() == Qt::Key_Space) {
            QAbstractButton::keyPressEvent(event);
        }
    }
}

bool LevelCard::event(QEvent* event) {
    if (event->type() == QEvent::HoverEnter || event->type() == QEvent::HoverLeave) {
        update();
    }
    return QAbstractButton::event(event);
}

} // namespace spacetow
