#include "editor/window/message_bar.h"

#include "editor/canvas/icons.h"
#include "editor/canvas/palette.h"

#include <QEvent>
#include <QPainter>

namespace spacetow {

namespace {

struct Dress {
    QColor plate;
    QColor ink;
    const char* icon;
};

Dress dressFor(MessageBar::Tone tone, Shade shade) {
    const bool dark = shade == Shade::Dark;
    switch (tone) {
    case MessageBar::Tone::Info:
        return dark ? Dress{QColor(30, 58, 92), QColor(206, 228, 255), "info"}
                    : Dress{QColor(221, 235, 251), QColor(20, 50, 84), "info"};
    case MessageBar::Tone::Warning:
        return dark ? Dress{QColor(82, 62, 18), QColor(255, 226, 160), "warning"}
                    : Dress{QColor(255, 239, 200), QColor(84, 54, 0), "warning"};
    case MessageBar::Tone::Error:
        break;
    }
    return dark ? Dress{QColor(96, 34, 30), QColor(255, 218, 212), "error"}
                : Dress{QColor(253, 224, 220), QColor(106, 18, 12), "error"};
}

} // namespace

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), m_row(this) {
    m_text.setWordWrap(true);
    m_text.setTextFormat(Qt::PlainText);
    m_text.setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close.setAutoRaise(true);
    m_close.setToolTip(tr("Close this message"));
    m_close.setAccessibleName(tr("Close"));
    connect(&m_close, &QToolButton::clicked, this, &MessageBar::dismiss);
    m_row.setContentsMargins(10, 6, 6, 6);
    m_row.setSpacing(8);
    m_row.addWidget(&m_icon, 0, Qt::AlignTop);
    m_row.addWidget(&m_text, 1);
    m_row.addWidget(&m_close, 0, Qt::AlignTop);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    hide();
}

void MessageBar::say(Tone tone, const QString& text) {
    m_tone = tone;
    m_text.setText(text);
    dress();
    show();
}

void MessageBar::dismiss() {
    hide();
    m_text.clear();
}

void MessageBar::dress() {
    const Dress dress = dressFor(m_tone, shadeOf(palette()));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, dress.ink);
    m_text.setPalette(colors);
    m_icon.setPixmap(icon(QString::fromLatin1(dress.icon), dress.ink).pixmap(18, 18));
    m_close.setIcon(icon(QStringLiteral("close"), dress.ink));
    update();
}

void MessageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), dressFor(m_tone, shadeOf(palette())).plate);
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        dress();
    }
    QWidget::changeEvent(event);
}

} // namespace spacetow
