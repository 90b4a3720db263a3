// Buttons, ticks and fields.
#include "editor/canvas/palette.h"
#include "editor/window/style_draw.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr double tickSize = 15;   // px
constexpr double handleSize = 14; // px, of a slider
constexpr double grooveWidth = 4; // px

bool isDefault(const QStyleOption& option) {
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
    return button != nullptr && (button->features & QStyleOptionButton::DefaultButton) != 0;
}

bool isFlat(const QStyleOption& option) {
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
    return button != nullptr && (button->features & QStyleOptionButton::Flat) != 0;
}

QColor pressedFill(const QPalette& palette) {
    return mixed(palette.color(QPalette::Button), palette.color(QPalette::Mid), 0.7);
}

/// The colours of what is being pointed at, pressed or switched on.
QColor buttonFill(const QStyleOption& option) {
    const QPalette& colors = option.palette;
    if (isDefault(option) && isOn(option, QStyle::State_Enabled)) {
        const QColor accent = colors.color(QPalette::Highlight);
        return isOn(option, QStyle::State_Sunken)      ? accent.darker(118)
               : isOn(option, QStyle::State_MouseOver) ? accent.lighter(108)
                                                       : accent;
    }
    if (isOn(option, QStyle::State_Sunken)) {
        return pressedFill(colors);
    }
    if (isOn(option, QStyle::State_On)) {
        return mixed(colors.color(QPalette::Button), colors.color(QPalette::Highlight), 0.28);
    }
    const bool pointed = isOn(option, QStyle::State_MouseOver) && isOn(option, QStyle::State_Enabled);
    return colors.color(pointed ? QPalette::Midlight : QPalette::Button);
}

QRectF tickBox(const QRect& rect) {
    const double side = std::min({tickSize, double(rect.width()), double(rect.height())});
    return {rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2, side, side};
}

struct TickColors {
    QColor fill, line, mark;
};

TickColors tickColors(const QStyleOption& option) {
    const QPalette& colors = option.palette;
    const bool set = isOn(option, QStyle::State_On) || isOn(option, QStyle::State_NoChange);
    if (!isOn(option, QStyle::State_Enabled)) {
        return {colors.color(QPalette::Window), colors.color(QPalette::Mid),
                colors.color(QPalette::Disabled, QPalette::Text)};
    }
    if (set) {
        const QColor accent = colors.color(QPalette::Highlight);
        return {accent, accent, colors.color(QPalette::HighlightedText)};
    }
    const bool pointed = isOn(option, QStyle::State_MouseOver);
    return {colors.color(QPalette::Base), pointed ? accentLine(colors) : colors.color(QPalette::Dark), {}};
}

} // namespace

bool drawButtonPanel(const QStyleOption& option, QPainter& painter) {
    const bool quiet = isFlat(option) && !isOn(option, QStyle::State_MouseOver) &&
                       !isOn(option, QStyle::State_Sunken) && !isOn(option, QStyle::State_On);
    const Brushwork brushwork(painter);
    const QColor fill = buttonFill(option);
    if (!quiet) {
        const bool accented = isDefault(option) && isOn(option, QStyle::State_Enabled);
        plate(painter, option.rect, fill, accented ? fill : option.palette.color(QPalette::Mid));
    }
    return true;
}

bool drawToolButtonPanel(const QStyleOption& option, QPainter& painter) {
    const QPalette& colors = option.palette;
    const bool pressed = isOn(option, QStyle::State_Sunken);
    const bool pointed = isOn(option, QStyle::State_MouseOver) && isOn(option, QStyle::State_Enabled);
    const bool raised = isOn(option, QStyle::State_Raised) && !isOn(option, QStyle::State_AutoRaise);
    const Brushwork brushwork(painter);
    const QRectF box = QRectF(option.rect).adjusted(1, 1, -1, -1);
    if (isOn(option, QStyle::State_On)) {
        const bool enabled = isOn(option, QStyle::State_Enabled);
        const QColor accent = colors.color(QPalette::Active, QPalette::Highlight);
        const QColor fill = mixed(colors.color(QPalette::Window), accent, !enabled ? 0.12 : pointed ? 0.42 : 0.32);
        plate(painter, box, fill, enabled ? accentLine(colors) : colors.color(QPalette::Mid));
    } else if (pressed || pointed) {
        const QColor fill = pressed ? pressedFill(colors) : colors.color(QPalette::Midlight);
        plate(painter, box, fill, pressed ? colors.color(QPalette::Mid) : fill);
    } else if (raised) {
        plate(painter, box, colors.color(QPalette::Button), colors.color(QPalette::Mid));
    }
    return true;
}

bool opensMenu(const QStyleOptionToolButton& option) {
    return (option.features & QStyleOptionToolButton::HasMenu) != 0 &&
           (option.features & QStyleOptionToolButton::MenuButtonPopup) == 0 &&
           option.toolButtonStyle != Qt::ToolButtonIconOnly && !option.text.isEmpty();
}

bool drawMenuButton(const QProxyStyle& style, const QStyleOptionToolButton& option, QPainter& painter,
                    const QWidget* widget) {
    drawToolButtonPanel(option, painter);
    const QRect arrow(option.rect.right() - menuArrowWidth, option.rect.top(), menuArrowWidth, option.rect.height());
    QStyleOptionToolButton words = option;
    words.rect = QStyle::visualRect(option.direction, option.rect, option.rect.adjusted(4, 0, -menuArrowWidth, 0));
    style.drawControl(QStyle::CE_ToolButtonLabel, &words, &painter, widget);
    const Brushwork brushwork(painter);
    const bool enabled = isOn(option, QStyle::State_Enabled);
    chevron(painter, QStyle::visualRect(option.direction, option.rect, arrow), Direction::Down,
            option.palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText));
    return true;
}

bool drawFieldPanel(const QStyleOption& option, QPainter& painter) {
    const QPalette& colors = option.palette;
    const bool focused = isOn(option, QStyle::State_HasFocus) && isOn(option, QStyle::State_Enabled);
    const bool pointed = isOn(option, QStyle::State_MouseOver) && isOn(option, QStyle::State_Enabled);
    const Brushwork brushwork(painter);
    const QColor line = focused   ? accentLine(colors)
                        : pointed ? colors.color(QPalette::Dark)
                                  : colors.color(QPalette::Mid);
    plate(painter, option.rect, colors.color(QPalette::Base), line, focused ? 1.6 : 1);
    return true;
}

bool drawTick(const QStyleOption& option, QPainter& painter) {
    const Brushwork brushwork(painter);
    const QRectF box = tickBox(option.rect);
    const TickColors colors = tickColors(option);
    plate(painter, box, colors.fill, colors.line);
    painter.setPen(QPen(colors.mark, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (isOn(option, QStyle::State_NoChange)) {
        painter.drawLine(box.center() - QPointF(3.5, 0), box.center() + QPointF(3.5, 0));
    } else if (isOn(option, QStyle::State_On)) {
        const QPointF middle = box.center();
        painter.drawPolyline(
            QPolygonF{middle + QPointF(-3.6, 0.2), middle + QPointF(-1, 2.9), middle + QPointF(3.8, -2.8)});
    }
    return true;
}

bool drawRadio(const QStyleOption& option, QPainter& painter) {
    const Brushwork brushwork(painter);
    const QRectF box = tickBox(option.rect);
    const TickColors colors = tickColors(option);
    painter.setPen(QPen(colors.line, 1));
    painter.setBrush(colors.fill);
    painter.drawEllipse(box.adjusted(0.5, 0.5, -0.5, -0.5));
    if (isOn(option, QStyle::State_On)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors.mark);
        painter.drawEllipse(box.center(), 3, 3);
    }
    return true;
}

bool drawComboBox(const QProxyStyle& style, const QStyleOptionComboBox& option, QPainter& painter,
                  const QWidget* widget) {
    const Brushwork brushwork(painter);
    if (option.editable) {
        drawFieldPanel(option, painter);
    } else {
        QStyleOption button = option;
        button.state &= ~QStyle::State_On; // an open list is shown by the list
        plate(painter, option.rect, buttonFill(button), option.palette.color(QPalette::Mid));
        if (isOn(option, QStyle::State_HasFocus) && isOn(option, QStyle::State_KeyboardFocusChange)) {
            focusRing(painter, option.rect, option.palette);
        }
    }
    const QRect arrow = style.subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxArrow, widget);
    chevron(painter, arrow, Direction::Down, option.palette.color(QPalette::ButtonText));
    return true;
}

bool drawSpinBox(const QProxyStyle& style, const QStyleOptionSpinBox& option, QPainter& painter,
                 const QWidget* widget) {
    const Brushwork brushwork(painter);
    if (option.frame) {
        drawFieldPanel(option, painter);
    }
    if (option.buttonSymbols == QAbstractSpinBox::NoButtons) {
        return true;
    }
    const auto arrow = [&](QStyle::SubControl part, QStyle::SubControl on, Direction direction, bool enabled) {
        const QRect box = style.subControlRect(QStyle::CC_SpinBox, &option, part, widget);
        const bool active = (option.activeSubControls & on) != 0 && enabled;
        if (active && (isOn(option, QStyle::State_MouseOver) || isOn(option, QStyle::State_Sunken))) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(
                option.palette.color(isOn(option, QStyle::State_Sunken) ? QPalette::Mid : QPalette::Midlight));
            painter.drawRoundedRect(QRectF(box).adjusted(0, 1, -1, -0.5), 2, 2);
        }
        chevron(painter, box, direction,
                option.palette.color(enabled ? QPalette::Normal : QPalette::Disabled, QPalette::ButtonText));
    };
    const bool enabled = isOn(option, QStyle::State_Enabled);
    arrow(QStyle::SC_SpinBoxUp, QStyle::SC_SpinBoxUp, Direction::Up,
          enabled && (option.stepEnabled & QAbstractSpinBox::StepUpEnabled) != 0);
    arrow(QStyle::SC_SpinBoxDown, QStyle::SC_SpinBoxDown, Direction::Down,
          enabled && (option.stepEnabled & QAbstractSpinBox::StepDownEnabled) != 0);
    return true;
}

bool drawSlider(const QProxyStyle& style, const QStyleOptionSlider& option, QPainter& painter, const QWidget* widget) {
    const Brushwork brushwork(painter);
    const bool flat = option.orientation == Qt::Horizontal;
    const QPointF middle =
        QRectF(style.subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, widget)).center();
    const QRectF all = option.rect;
    QRectF groove = flat ? QRectF(all.left() + 2, all.center().y() - grooveWidth / 2, all.width() - 4, grooveWidth)
                         : QRectF(all.center().x() - grooveWidth / 2, all.top() + 2, grooveWidth, all.height() - 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(option.palette.color(QPalette::Mid));
    painter.drawRoundedRect(groove, grooveWidth / 2, grooveWidth / 2);
    (flat ? groove.setRight(middle.x()) : groove.setTop(middle.y()));
    painter.setBrush(option.palette.color(QPalette::Highlight));
    painter.drawRoundedRect(groove, grooveWidth / 2, grooveWidth / 2);
    painter.setPen(
        QPen(isOn(option, QStyle::State_HasFocus) ? accentLine(option.palette) : option.palette.color(QPalette::Dark),
             isOn(option, QStyle::State_HasFocus) ? 2 : 1));
    painter.setBrush(buttonFill(option));
    painter.drawEllipse(middle, handleSize / 2, handleSize / 2);
    return true;
}

} // namespace spacetow
