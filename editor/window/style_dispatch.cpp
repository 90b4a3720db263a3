// Which function draws what; the toolkit's own style draws the rest.
#include "editor/window/style.h"
#include "editor/window/style_draw.h"

#include <QAbstractSpinBox>
#include <QComboBox>

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

using Draw = bool (*)(const QStyleOption& option, QPainter& painter);

bool drawNothing(const QStyleOption&, QPainter&) {
    return true;
}

template <Direction direction>
bool drawArrow(const QStyleOption& option, QPainter& painter) {
    const Brushwork brushwork(painter);
    const bool enabled = isOn(option, QStyle::State_Enabled);
    chevron(painter, option.rect, direction,
            option.palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText));
    return true;
}

bool drawFocus(const QStyleOption& option, QPainter& painter) {
    if (isOn(option, QStyle::State_KeyboardFocusChange)) {
        const Brushwork brushwork(painter);
        focusRing(painter, option.rect, option.palette);
    }
    return true;
}

bool fillWindow(const QStyleOption& option, QPainter& painter) {
    painter.fillRect(option.rect, option.palette.color(QPalette::Window));
    return true;
}

/// Draws only when the option is of the kind that the function takes.
template <auto draw, class Option>
bool drawAs(const QStyleOption& option, QPainter& painter) {
    const auto* wanted = qstyleoption_cast<const Option*>(&option);
    return wanted != nullptr && draw(*wanted, painter);
}

struct Primitive {
    QStyle::PrimitiveElement element;
    Draw draw;
};
constexpr std::array primitives{
    Primitive{QStyle::PE_PanelButtonCommand, drawButtonPanel},
    Primitive{QStyle::PE_PanelButtonTool, drawToolButtonPanel},
    Primitive{QStyle::PE_FrameDefaultButton, drawNothing},
    Primitive{QStyle::PE_FrameStatusBarItem, drawNothing},
    Primitive{QStyle::PE_FrameTabBarBase, drawNothing},
    Primitive{QStyle::PE_FrameDockWidget, drawNothing},
    Primitive{QStyle::PE_FrameLineEdit, drawNothing}, // its panel has it
    Primitive{QStyle::PE_IndicatorDockWidgetResizeHandle, drawDockGrip},
    Primitive{QStyle::PE_FrameFocusRect, drawFocus},
    Primitive{QStyle::PE_IndicatorCheckBox, drawTick},
    Primitive{QStyle::PE_IndicatorItemViewItemCheck, drawTick},
    Primitive{QStyle::PE_IndicatorRadioButton, drawRadio},
    Primitive{QStyle::PE_IndicatorArrowDown, drawArrow<Direction::Down>},
    Primitive{QStyle::PE_IndicatorButtonDropDown, drawArrow<Direction::Down>},
    Primitive{QStyle::PE_IndicatorArrowUp, drawArrow<Direction::Up>},
    Primitive{QStyle::PE_IndicatorArrowLeft, drawArrow<Direction::Left>},
    Primitive{QStyle::PE_IndicatorArrowRight, drawArrow<Direction::Right>},
    Primitive{QStyle::PE_IndicatorBranch, drawBranch},
    Primitive{QStyle::PE_Frame, drawFrame},
    Primitive{QStyle::PE_FrameMenu, drawMenuPanel},
    Primitive{QStyle::PE_PanelMenu, drawMenuPanel},
    Primitive{QStyle::PE_PanelTipLabel, drawTip},
    Primitive{QStyle::PE_PanelItemViewItem, drawAs<drawItemPanel, QStyleOptionViewItem>},
    Primitive{QStyle::PE_IndicatorToolBarSeparator, drawBarSeparator},
    Primitive{QStyle::PE_PanelStatusBar, drawStatusBar},
    Primitive{QStyle::PE_PanelMenuBar, drawNothing},
};

struct Control {
    QStyle::ControlElement element;
    Draw draw;
};
constexpr std::array controls{
    Control{QStyle::CE_MenuItem, drawAs<drawMenuItem, QStyleOptionMenuItem>},
    Control{QStyle::CE_MenuBarItem, drawAs<drawMenuBarItem, QStyleOptionMenuItem>},
    Control{QStyle::CE_MenuBarEmptyArea, fillWindow},
    Control{QStyle::CE_TabBarTabShape, drawAs<drawTab, QStyleOptionTab>},
    Control{QStyle::CE_HeaderSection, drawHeaderSection},
    Control{QStyle::CE_HeaderEmptyArea, drawHeaderSection},
    Control{QStyle::CE_ToolBar, drawAs<drawToolBar, QStyleOptionToolBar>},
    Control{QStyle::CE_ProgressBarGroove, drawNothing}, // its contents have it
    Control{QStyle::CE_ProgressBarContents, drawAs<drawProgress, QStyleOptionProgressBar>},
    Control{QStyle::CE_RubberBand, drawRubberBand},
    Control{QStyle::CE_Splitter, drawNothing},
};

bool drawLinePanel(const QStyleOption& option, QPainter& painter, const QWidget* widget) {
    const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(&option);
    if (isInsideField(widget)) {
        return true;
    }
    if (frame != nullptr && frame->lineWidth == 0) {
        painter.fillRect(option.rect, option.palette.color(QPalette::Base));
        return true;
    }
    return drawFieldPanel(option, painter);
}

} // namespace

bool isInsideField(const QWidget* widget) {
    const QWidget* const parent = widget != nullptr ? widget->parentWidget() : nullptr;
    return qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
           qobject_cast<const QComboBox*>(parent) != nullptr;
}

void Style::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                          const QWidget* widget) const {
    const auto* found = std::ranges::find(primitives, element, &Primitive::element);
    const bool done = element == PE_PanelLineEdit ? drawLinePanel(*option, *painter, widget)
                                                  : found != primitives.end() && found->draw(*option, *painter);
    if (!done) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void Style::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                        const QWidget* widget) const {
    if (element == CE_DockWidgetTitle) {
        if (const auto* title = qstyleoption_cast<const QStyleOptionDockWidget*>(option)) {
            drawDockTitle(*this, *title, *painter, widget);
            return;
        }
    }
    const auto* button = element == CE_PushButtonLabel ? qstyleoption_cast<const QStyleOptionButton*>(option) : nullptr;
    if (button != nullptr && (button->features & QStyleOptionButton::DefaultButton) != 0 &&
        isOn(*button, State_Enabled)) {
        QStyleOptionButton label = *button; // on the accent
        label.palette.setColor(QPalette::ButtonText, label.palette.color(QPalette::HighlightedText));
        QProxyStyle::drawControl(element, &label, painter, widget);
        return;
    }
    const auto* found = std::ranges::find(controls, element, &Control::element);
    if (found == controls.end() || !found->draw(*option, *painter)) {
        QProxyStyle::drawControl(element, option, painter, widget);
    }
}

void Style::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                               const QWidget* widget) const {
    if (const auto* combo = qstyleoption_cast<const QStyleOptionComboBox*>(option); combo && control == CC_ComboBox) {
        drawComboBox(*this, *combo, *painter, widget);
    } else if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
               spin && control == CC_SpinBox) {
        drawSpinBox(*this, *spin, *painter, widget);
    } else if (const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option); bar && control == CC_ScrollBar) {
        drawScrollBar(*this, *bar, *painter, widget);
    } else if (const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
               slider && control == CC_Slider) {
        drawSlider(*this, *slider, *painter, widget);
    } else if (const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
               button && control == CC_ToolButton && opensMenu(*button)) {
        drawMenuButton(*this, *button, *painter, widget);
    } else {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
    }
}

} // namespace spacetow
