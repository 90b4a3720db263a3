#include "editor/window/style.h"

#include "editor/canvas/icons.h"
#include "editor/canvas/palette.h"
#include "editor/window/style_draw.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QStyleFactory>

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

struct Size {
    QStyle::PixelMetric metric;
    int pixels;
};
constexpr std::array sizes{
    Size{QStyle::PM_ToolBarIconSize, 20},
    Size{QStyle::PM_ToolBarItemSpacing, 1},
    Size{QStyle::PM_ToolBarItemMargin, 1},
    Size{QStyle::PM_ToolBarFrameWidth, 2},
    Size{QStyle::PM_ToolBarSeparatorExtent, 9},
    Size{QStyle::PM_ToolBarExtensionExtent, 18},
    Size{QStyle::PM_ScrollBarExtent, scrollWidth},
    Size{QStyle::PM_ScrollBarSliderMin, 28},
    Size{QStyle::PM_ScrollView_ScrollBarSpacing, 0},
    Size{QStyle::PM_ScrollView_ScrollBarOverlap, 0},
    Size{QStyle::PM_ButtonShiftHorizontal, 0},
    Size{QStyle::PM_ButtonShiftVertical, 0},
    Size{QStyle::PM_MenuBarVMargin, 0},
    Size{QStyle::PM_MenuBarHMargin, 4},
    Size{QStyle::PM_MenuHMargin, 0},
    Size{QStyle::PM_MenuVMargin, 4},
    Size{QStyle::PM_MenuPanelWidth, 1},
    Size{QStyle::PM_DefaultFrameWidth, 1},
    Size{QStyle::PM_DockWidgetFrameWidth, 0},
    Size{QStyle::PM_DockWidgetSeparatorExtent, 7},
    Size{QStyle::PM_TabBarTabHSpace, 10}, // at least; five panels in one place are then still named in full
    Size{QStyle::PM_DockWidgetTitleMargin, 6},
    Size{QStyle::PM_DockWidgetTitleBarButtonMargin, 3},
    Size{QStyle::PM_SplitterWidth, 5},
    Size{QStyle::PM_IndicatorWidth, 16},
    Size{QStyle::PM_IndicatorHeight, 16},
    Size{QStyle::PM_ExclusiveIndicatorWidth, 16},
    Size{QStyle::PM_ExclusiveIndicatorHeight, 16},
    Size{QStyle::PM_ListViewIconSize, 16},
    Size{QStyle::PM_SmallIconSize, 16},
    Size{QStyle::PM_ButtonIconSize, 16},
    Size{QStyle::PM_TreeViewIndentation, 16},
    Size{QStyle::PM_FocusFrameHMargin, 4}, // beside the words of lists
};

struct StandardIcon {
    QStyle::StandardPixmap which;
    const char* name;
};
constexpr std::array standardIcons{
    StandardIcon{QStyle::SP_ToolBarHorizontalExtensionButton, "more"},
    StandardIcon{QStyle::SP_ToolBarVerticalExtensionButton, "expand"},
    StandardIcon{QStyle::SP_TitleBarCloseButton, "close"},
    StandardIcon{QStyle::SP_DockWidgetCloseButton, "close"},
    StandardIcon{QStyle::SP_LineEditClearButton, "close"},
    StandardIcon{QStyle::SP_TitleBarNormalButton, "float"},
    StandardIcon{QStyle::SP_MessageBoxInformation, "info"},
    StandardIcon{QStyle::SP_MessageBoxWarning, "warning"},
    StandardIcon{QStyle::SP_MessageBoxCritical, "error"},
    StandardIcon{QStyle::SP_MessageBoxQuestion, "question"},
};

constexpr int fieldPadding = 3; // px before the words of a field

} // namespace

bool isOn(const QStyleOption& option, QStyle::StateFlag flag) {
    return (option.state & flag) != 0;
}

QColor accentLine(const QPalette& palette) {
    return shadeOf(palette) == Shade::Dark ? palette.color(QPalette::Active, QPalette::Highlight).lighter(135)
                                           : palette.color(QPalette::Active, QPalette::Highlight);
}

void chevron(QPainter& painter, const QRectF& box, Direction direction, const QColor& color) {
    const double reach = std::clamp(std::min(box.width(), box.height()) * 0.24, 2.0, 4.0);
    const QPointF middle = box.center();
    const auto point = [&](double along, double across) {
        switch (direction) {
        case Direction::Up:
            return middle + QPointF(across, -along);
        case Direction::Down:
            return middle + QPointF(across, along);
        case Direction::Left:
            return middle + QPointF(-along, across);
        case Direction::Right:
            break;
        }
        return middle + QPointF(along, across);
    };
    painter.setPen(QPen(color, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF{point(-reach / 2, -reach), point(reach / 2, 0), point(-reach / 2, reach)});
}

void plate(QPainter& painter, const QRectF& box, const QColor& fill, const QColor& line, double lineWidth) {
    const double inset = lineWidth / 2;
    painter.setPen(QPen(line, lineWidth));
    painter.setBrush(fill);
    painter.drawRoundedRect(box.adjusted(inset, inset, -inset, -inset), controlRadius, controlRadius);
}

void focusRing(QPainter& painter, const QRectF& box, const QPalette& palette) {
    painter.setPen(QPen(accentLine(palette), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box.adjusted(1, 1, -1, -1), controlRadius, controlRadius);
}

Style::Style() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {
    setObjectName(QStringLiteral("spacetow"));
}

void Style::polish(QWidget* widget) {
    QProxyStyle::polish(widget);
    if (qobject_cast<QAbstractItemView*>(widget) != nullptr || qobject_cast<QComboBox*>(widget) != nullptr) {
        widget->setAttribute(Qt::WA_Hover);
    }
}

int Style::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    const auto* found = std::ranges::find(sizes, metric, &Size::metric);
    return found != sizes.end() ? found->pixels : QProxyStyle::pixelMetric(metric, option, widget);
}

int Style::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* data) const {
    switch (hint) {
    case SH_EtchDisabledText:
    case SH_DitherDisabledText:
    case SH_ScrollBar_LeftClickAbsolutePosition:
    case SH_ItemView_ActivateItemOnSingleClick:
    case SH_DialogButtonBox_ButtonsHaveIcons:
    case SH_ScrollView_FrameOnlyAroundContents:
        return 0;
    case SH_Menu_SubMenuPopupDelay:
        return 120; // ms
    case SH_ToolTip_WakeUpDelay:
        return 450; // ms
    case SH_UnderlineShortcut:
        return 1;
    default:
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
}

QSize Style::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                              const QWidget* widget) const {
    QSize wanted = QProxyStyle::sizeFromContents(type, option, size, widget);
    const int row = (option != nullptr ? option->fontMetrics.height() : 16) + 10;
    switch (type) {
    case CT_PushButton:
        return {wanted.width() + 8, std::max(wanted.height(), row + 2)};
    case CT_LineEdit:
        return {wanted.width() + fieldPadding, std::max(wanted.height(), row)};
    case CT_SpinBox:
    case CT_ComboBox:
        return {wanted.width(), std::max(wanted.height(), row)};
    case CT_MenuItem: {
        const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
        if (item != nullptr && item->menuItemType == QStyleOptionMenuItem::Separator) {
            return {wanted.width(), item->text.isEmpty() ? 9 : row};
        }
        return {wanted.width() + 34, row};
    }
    case CT_MenuBarItem:
        return {wanted.width() + 4, row + 2};
    case CT_ToolButton: {
        const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
        const bool arrow = button != nullptr && opensMenu(*button);
        return {wanted.width() + 2 + (arrow ? menuArrowWidth : 0), wanted.height()};
    }
    case CT_ItemViewItem:
        return {wanted.width(), std::max(wanted.height(), row - 3)};
    case CT_TabBarTab:
        return {wanted.width() + 20, row + 2};
    case CT_HeaderSection:
        return {wanted.width(), row};
    default:
        return wanted;
    }
}

QRect Style::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                            const QWidget* widget) const {
    const auto* bar = control == CC_ScrollBar ? qstyleoption_cast<const QStyleOptionSlider*>(option) : nullptr;
    return bar != nullptr ? scrollBarPart(*bar, part, pixelMetric(PM_ScrollBarSliderMin, option, widget))
                          : QProxyStyle::subControlRect(control, option, part, widget);
}

QRect Style::subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const {
    const QRect box = QProxyStyle::subElementRect(element, option, widget);
    if (element != SE_LineEditContents || isInsideField(widget)) {
        return box;
    }
    return visualRect(option->direction, option->rect, box.adjusted(fieldPadding, 0, 0, 0));
}

QIcon Style::standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const {
    const auto* found = std::ranges::find(standardIcons, which, &StandardIcon::which);
    return found != standardIcons.end() ? livingIcon(QString::fromLatin1(found->name))
                                        : QProxyStyle::standardIcon(which, option, widget);
}

} // namespace spacetow
