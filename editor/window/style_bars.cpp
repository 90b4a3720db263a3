// Menus, tool bars, titles, tabs and headers.
#include "editor/canvas/palette.h"
#include "editor/window/style_draw.h"

namespace spacetow {

namespace {

constexpr int menuMark = 30;    // px on the left, for a tick or an icon
constexpr int menuIcon = 18;    // px
constexpr int menuMargin = 8;   // px on the right
constexpr int menuArrow = 14;   // px
constexpr int titleMargin = 10; // px

void drawMenuSeparator(const QStyleOptionMenuItem& option, QPainter& painter) {
    const int middle = option.rect.center().y();
    int left = option.rect.left() + menuMargin;
    if (!option.text.isEmpty()) {
        QFont bold = option.font;
        bold.setBold(true);
        painter.setFont(bold);
        painter.setPen(option.palette.color(QPalette::PlaceholderText));
        const QRect words = option.rect.adjusted(menuMargin, 0, -menuMargin, 0);
        painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, option.text);
        left += QFontMetrics(bold).horizontalAdvance(option.text) + menuMargin;
    }
    painter.setPen(option.palette.color(QPalette::Mid));
    painter.drawLine(left, middle, option.rect.right() - menuMargin, middle);
}

void drawMenuMark(const QStyleOptionMenuItem& option, QPainter& painter, const QColor& ink) {
    const QRect column = QStyle::visualRect(option.direction, option.rect,
                                            {option.rect.left(), option.rect.top(), menuMark, option.rect.height()});
    if (!option.icon.isNull()) {
        const bool enabled = isOn(option, QStyle::State_Enabled);
        const QIcon::Mode mode = !enabled                               ? QIcon::Disabled
                                 : isOn(option, QStyle::State_Selected) ? QIcon::Selected
                                                                        : QIcon::Normal;
        if (option.checked) {
            plate(painter, QRectF(column).adjusted(3, 2, -3, -2),
                  mixed(option.palette.color(QPalette::Base), option.palette.color(QPalette::Highlight), 0.32),
                  accentLine(option.palette));
        }
        QRect box(0, 0, menuIcon, menuIcon);
        box.moveCenter(column.center());
        option.icon.paint(&painter, box, Qt::AlignCenter, mode);
        return;
    }
    if (!option.checked) {
        return;
    }
    const QPointF middle = QRectF(column).center();
    if (option.checkType == QStyleOptionMenuItem::Exclusive) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawEllipse(middle, 3.2, 3.2);
    } else {
        painter.setPen(QPen(ink, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(QPolygonF{middle + QPointF(-4, 0), middle + QPointF(-1, 3), middle + QPointF(4.5, -3.2)});
    }
}

} // namespace

bool drawMenuItem(const QStyleOptionMenuItem& option, QPainter& painter) {
    const Brushwork brushwork(painter);
    if (option.menuItemType == QStyleOptionMenuItem::Separator) {
        drawMenuSeparator(option, painter);
        return true;
    }
    const bool enabled = isOn(option, QStyle::State_Enabled);
    const bool selected = isOn(option, QStyle::State_Selected) && enabled;
    if (selected) {
        const QColor accent = option.palette.color(QPalette::Active, QPalette::Highlight);
        plate(painter, QRectF(option.rect).adjusted(3, 0, -3, 0), accent, accent);
    }
    const QColor ink = option.palette.color(enabled ? QPalette::Active : QPalette::Disabled,
                                            selected ? QPalette::HighlightedText : QPalette::Text);
    drawMenuMark(option, painter, ink);

    const QRect words = option.rect.adjusted(menuMark + 4, 0, -menuMargin - menuArrow, 0);
    const qsizetype tab = option.text.indexOf(QLatin1Char('\t'));
    const auto write = [&](const QString& text, Qt::Alignment side, int mnemonics) {
        const Qt::Alignment toward = QStyle::visualAlignment(option.direction, side);
        painter.drawText(QStyle::visualRect(option.direction, option.rect, words),
                         static_cast<int>(toward | Qt::AlignVCenter) | mnemonics | Qt::TextSingleLine, text);
    };
    QFont font = option.font;
    font.setBold(option.menuItemType == QStyleOptionMenuItem::DefaultItem);
    painter.setFont(font);
    painter.setPen(ink);
    write(tab < 0 ? option.text : option.text.left(tab), Qt::AlignLeft, Qt::TextShowMnemonic);
    if (tab >= 0) {
        painter.setPen(selected || !enabled ? ink : option.palette.color(QPalette::PlaceholderText));
        write(option.text.mid(tab + 1), Qt::AlignRight, Qt::TextHideMnemonic);
    }
    if (option.menuItemType == QStyleOptionMenuItem::SubMenu) {
        const QRect arrow(option.rect.right() - menuMargin - menuArrow + 2, option.rect.top(), menuArrow,
                          option.rect.height());
        const bool rightward = option.direction == Qt::LeftToRight;
        chevron(painter, QStyle::visualRect(option.direction, option.rect, arrow),
                rightward ? Direction::Right : Direction::Left, ink);
    }
    return true;
}

bool drawMenuBarItem(const QStyleOptionMenuItem& option, QPainter& painter) {
    const Brushwork brushwork(painter);
    painter.fillRect(option.rect, option.palette.color(QPalette::Window));
    const bool enabled = isOn(option, QStyle::State_Enabled);
    if (isOn(option, QStyle::State_Selected) && enabled) {
        const QColor fill =
            option.palette.color(isOn(option, QStyle::State_Sunken) ? QPalette::Mid : QPalette::Midlight);
        plate(painter, QRectF(option.rect).adjusted(1, 2, -1, -2), fill, fill);
    }
    painter.setPen(option.palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    painter.drawText(option.rect, Qt::AlignCenter | Qt::TextShowMnemonic | Qt::TextSingleLine, option.text);
    return true;
}

bool drawDockTitle(const QProxyStyle& style, const QStyleOptionDockWidget& option, QPainter& painter,
                   const QWidget* widget) {
    const Brushwork brushwork(painter);
    painter.fillRect(option.rect, option.palette.color(QPalette::Window));
    painter.setPen(option.palette.color(QPalette::Mid));
    painter.drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    const QRect words =
        style.subElementRect(QStyle::SE_DockWidgetTitleBarText, &option, widget).adjusted(titleMargin - 6, 0, 0, 0);
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    painter.setPen(option.palette.color(QPalette::WindowText));
    const QString title = QFontMetrics(font).elidedText(option.title, Qt::ElideRight, words.width());
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine | Qt::TextHideMnemonic, title);
    return true;
}

bool drawTab(const QStyleOptionTab& option, QPainter& painter) {
    const bool selected = isOn(option, QStyle::State_Selected);
    const bool pointed = isOn(option, QStyle::State_MouseOver) && isOn(option, QStyle::State_Enabled);
    const Brushwork brushwork(painter);
    if (selected || pointed) {
        painter.fillRect(option.rect, option.palette.color(selected ? QPalette::Window : QPalette::Midlight));
    }
    if (!selected) {
        return true;
    }
    const QColor accent = accentLine(option.palette);
    const QRect box = option.rect;
    switch (option.shape) {
    case QTabBar::RoundedSouth:
    case QTabBar::TriangularSouth: // docks: the mark is on the side of the panel
        painter.fillRect(QRect(box.left(), box.top(), box.width(), 2), accent);
        break;
    case QTabBar::RoundedWest:
    case QTabBar::TriangularWest:
        painter.fillRect(QRect(box.right() - 1, box.top(), 2, box.height()), accent);
        break;
    case QTabBar::RoundedEast:
    case QTabBar::TriangularEast:
        painter.fillRect(QRect(box.left(), box.top(), 2, box.height()), accent);
        break;
    default:
        painter.fillRect(QRect(box.left(), box.bottom() - 1, box.width(), 2), accent);
        break;
    }
    return true;
}

bool drawHeaderSection(const QStyleOption& option, QPainter& painter) {
    const QPalette& colors = option.palette;
    const bool pointed = isOn(option, QStyle::State_MouseOver) && isOn(option, QStyle::State_Enabled);
    painter.fillRect(option.rect, colors.color(pointed ? QPalette::Midlight : QPalette::Window));
    painter.save();
    painter.setPen(colors.color(QPalette::Mid));
    painter.drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    painter.drawLine(option.rect.topRight() + QPoint(0, 4), option.rect.bottomRight() - QPoint(0, 4));
    painter.restore();
    return true;
}

bool drawToolBar(const QStyleOptionToolBar& option, QPainter& painter) {
    painter.fillRect(option.rect, option.palette.color(QPalette::Window));
    painter.save();
    painter.setPen(option.palette.color(QPalette::Mid));
    const QRect box = option.rect;
    if (option.toolBarArea == Qt::LeftToolBarArea) {
        painter.drawLine(box.topRight(), box.bottomRight());
    } else if (option.toolBarArea == Qt::RightToolBarArea) {
        painter.drawLine(box.topLeft(), box.bottomLeft());
    } else if (option.toolBarArea == Qt::BottomToolBarArea) {
        painter.drawLine(box.topLeft(), box.topRight());
    } else {
        painter.drawLine(box.bottomLeft(), box.bottomRight());
    }
    painter.restore();
    return true;
}

bool drawStatusBar(const QStyleOption& option, QPainter& painter) {
    painter.fillRect(option.rect, option.palette.color(QPalette::Window));
    painter.save();
    painter.setPen(option.palette.color(QPalette::Mid));
    painter.drawLine(option.rect.topLeft(), option.rect.topRight());
    painter.restore();
    return true;
}

bool drawBarSeparator(const QStyleOption& option, QPainter& painter) {
    painter.save();
    painter.setPen(option.palette.color(QPalette::Mid));
    const QPoint middle = option.rect.center();
    constexpr int inset = 6; // px
    if (isOn(option, QStyle::State_Horizontal)) {
        painter.drawLine(middle.x(), option.rect.top() + inset, middle.x(), option.rect.bottom() - inset);
    } else {
        painter.drawLine(option.rect.left() + inset, middle.y(), option.rect.right() - inset, middle.y());
    }
    painter.restore();
    return true;
}

/// Dots in the middle of the bar between two panels, by which one sees that it can be dragged.
bool drawDockGrip(const QStyleOption& option, QPainter& painter) {
    const Brushwork brushwork(painter);
    const bool isHot = isOn(option, QStyle::State_MouseOver) && isOn(option, QStyle::State_Enabled);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isHot ? accentLine(option.palette) : option.palette.color(QPalette::PlaceholderText));
    const QRectF bar(option.rect);
    const QPointF way = bar.width() > bar.height() ? QPointF(6, 0) : QPointF(0, 6); // px
    for (int i = -2; i <= 2; ++i) {
        painter.drawEllipse(bar.center() + i * way, 1.3, 1.3);
    }
    return true;
}

} // namespace spacetow
