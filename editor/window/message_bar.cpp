#include "editor/window/message_bar.h"

#include "editor/canvas/icons.h"

#include <QEvent>
#include <QPainter>

namespace spacetow {

namespace {

struct Dress {
    QColor plate;
    QColor ink;
    const char* icon;
};

Dress dressFor(MessageBar::Tone tone) {
    switch (tone) {
    case MessageBar::Tone::Info:
        return {QColor(214, 232, 250), QColor(20, 50, 84), "info"};
    case MessageBar::Tone::Warning:
        return {QColor(255, 233, 178), QColor(84, 54, 0), "warning"};
    case MessageBar::Tone::Error:
        break;
    }
    return {QColor(252, 212, 206), QColor(106, 18, 12), "error"};
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
    const Dress dress = dressFor(m_tone);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, dress.ink);
    m_text.setPalette(colors);
    m_icon.setPixmap(icon(QString::fromLatin1(dress.icon), dress.ink).pixmap(18, 18));
    m_close.setIcon(icon(QStringLiteral("close"), dress.ink));
    update();
}

void MessageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), dressFor(m_tone).plate);
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        update();
    }
    QWidget::changeEvent(event);
}

} // namespace spacetow
