#include "editor/window/message_bar.h"

#include "editor/canvas/icons.h"

#include <QEvent>
#include <QPainter>

namespace spacetow {

BarDress barDress(MessageBar::Tone tone, Shade shade) {
    const bool dark = shade == Shade::Dark;
    switch (tone) {
    case MessageBar::Tone::Info:
        return dark ? BarDress{QColor(30, 58, 92), QColor(206, 228, 255), "info"}
                    : BarDress{QColor(221, 235, 251), QColor(20, 50, 84), "info"};
    case MessageBar::Tone::Warning:
        return dark ? BarDress{QColor(82, 62, 18), QColor(255, 226, 160), "warning"}
                    : BarDress{QColor(255, 239, 200), QColor(84, 54, 0), "warning"};
    case MessageBar::Tone::Error:
        break;
    }
    return dark ? BarDress{QColor(96, 34, 30), QColor(255, 218, 212), "error"}
                : BarDress{QColor(253, 224, 220), QColor(106, 18, 12), "error"};
}

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), m_row(this), m_content(QBoxLayout::LeftToRight) {
    m_text.setWordWrap(true);
    m_text.setTextFormat(Qt::PlainText);
    m_text.setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close.setAutoRaise(true);
    m_close.setToolTip(tr("Close this message"));
    m_close.setAccessibleName(tr("Close"));
    connect(&m_close, &QToolButton::clicked, this, [this] {
        dismiss();
        Q_EMIT dismissed();
    });
    m_content.setSpacing(8);
    m_content.addWidget(&m_text, 1);
    m_content.addLayout(&m_choices);
    m_choices.setSpacing(6);
    m_choices.addStretch(1);
    m_row.setContentsMargins(10, 6, 6, 6);
    m_row.setSpacing(8);
    m_row.addWidget(&m_icon, 0, Qt::AlignTop);
    m_row.addLayout(&m_content, 1);
    m_row.addWidget(&m_close, 0, Qt::AlignTop);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    hide();
}

void MessageBar::say(Tone tone, const QString& text, const std::vector<Choice>& choices) {
    m_tone = tone;
    m_text.setText(text);
    for (QToolButton* button : m_buttons) {
        button->hide();
        button->deleteLater(); // it may be the one that was clicked
    }
    m_buttons.clear();
    for (const Choice& choice : choices) {
        auto* const button = new QToolButton(this);
        button->setText(choice.text);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setFocusPolicy(Qt::StrongFocus);
        connect(button, &QToolButton::clicked, this, [run = choice.run] { run(); });
        m_choices.addWidget(button);
        button->show();
        m_buttons.push_back(button);
    }
    arrange();
    dress();
    show();
}

void MessageBar::dismiss() {
    hide();
    m_text.clear();
}

/// Buttons stand below a text that they would leave no room for.
void MessageBar::arrange() {
    constexpr int textWidth = 320; // px
    const bool beside = m_buttons.empty() || m_choices.sizeHint().width() + textWidth < width();
    m_content.setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void MessageBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void MessageBar::dress() {
    const BarDress dress = barDress(m_tone, shadeOf(palette()));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, dress.ink);
    m_text.setPalette(colors);
    m_icon.setPixmap(icon(QString::fromLatin1(dress.icon), dress.ink).pixmap(18, 18));
    m_close.setIcon(icon(QStringLiteral("close"), dress.ink));
    update();
}

void MessageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), barDress(m_tone, shadeOf(palette())).plate);
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        dress();
    }
    QWidget::changeEvent(event);
}

} // namespace spacetow
