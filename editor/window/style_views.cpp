// Lists, trees, frames, scroll bars and progress.
#include "editor/canvas/palette.h"
#include "editor/window/style_draw.h"

#include <algorithm>

namespace spacetow {

bool drawItemPanel(const QStyleOptionViewItem& option, QPainter& painter) {
    const QPalette& colors = option.palette;
    if (isOn(option, QStyle::State_Selected)) {
        const QPalette::ColorGroup group = isOn(option, QStyle::State_Enabled) ? QPalette::Active : QPalette::Disabled;
        painter.fillRect(option.rect, colors.color(group, QPalette::Highlight));
    } else if (option.backgroundBrush.style() != Qt::NoBrush) {
        painter.fillRect(option.rect, option.backgroundBrush);
    } else if (isOn(option, QStyle::State_MouseOver) && isOn(option, QStyle::State_Enabled)) {
        painter.fillRect(option.rect, colors.color(QPalette::Midlight));
    }
    return true;
}

bool drawBranch(const QStyleOption& option, QPainter& painter) {
    if (!isOn(option, QStyle::State_Children)) {
        return true;
    }
    const Brushwork brushwork(painter);
    const bool rightward = option.direction == Qt::LeftToRight;
    const Direction closed = rightward ? Direction::Right : Direction::Left;
    const auto role = isOn(option, QStyle::State_Selected)    ? QPalette::HighlightedText
                      : isOn(option, QStyle::State_MouseOver) ? QPalette::Text
                                                              : QPalette::PlaceholderText;
    const auto group = isOn(option, QStyle::State_Active) ? QPalette::Active : QPalette::Inactive;
    const QColor ink = option.palette.color(group, role);
    chevron(painter, option.rect, isOn(option, QStyle::State_Open) ? Direction::Down : closed, ink);
    return true;
}

bool drawFrame(const QStyleOption& option, QPainter& painter) {
    const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(&option);
    if (frame != nullptr && frame->lineWidth == 0) {
        return true;
    }
    painter.save();
    const bool focused = isOn(option, QStyle::State_HasFocus) && isOn(option, QStyle::State_Enabled);
    painter.setPen(focused ? accentLine(option.palette) : option.palette.color(QPalette::Mid));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
    painter.restore();
    return true;
}

bool drawMenuPanel(const QStyleOption& option, QPainter& painter) {
    painter.save();
    painter.setPen(option.palette.color(QPalette::Dark));
    painter.setBrush(option.palette.color(QPalette::Base));
    painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
    painter.restore();
    return true;
}

bool drawTip(const QStyleOption& option, QPainter& painter) {
    painter.save();
    painter.setPen(
        mixed(option.palette.color(QPalette::ToolTipBase), option.palette.color(QPalette::ToolTipText), 0.3));
    painter.setBrush(option.palette.color(QPalette::ToolTipBase));
    painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
    painter.restore();
    return true;
}

QRect scrollBarPart(const QStyleOptionSlider& option, QStyle::SubControl part, int leastSlider) {
    const bool flat = option.orientation == Qt::Horizontal;
    const QRect all = option.rect;
    const int length = flat ? all.width() : all.height();
    const qint64 range = qint64(option.maximum) - option.minimum;
    const int least = std::min(leastSlider, length);
    const int slider =
        range > 0 ? std::clamp(int(qint64(option.pageStep) * length / (range + option.pageStep)), least, length)
                  : length;
    const int start = QStyle::sliderPositionFromValue(option.minimum, option.maximum, option.sliderPosition,
                                                      length - slider, option.upsideDown);
    const auto piece = [&](int from, int size) {
        const QRect box = flat ? QRect(all.x() + from, all.y(), size, all.height())
                               : QRect(all.x(), all.y() + from, all.width(), size);
        return QStyle::visualRect(option.direction, all, box);
    };
    switch (part) {
    case QStyle::SC_ScrollBarSlider:
        return piece(start, slider);
    case QStyle::SC_ScrollBarGroove:
        return piece(0, length);
    case QStyle::SC_ScrollBarSubPage:
        return piece(0, start);
    case QStyle::SC_ScrollBarAddPage:
        return piece(start + slider, length - start - slider);
    default:
        return {};
    }
}

bool drawScrollBar(const QProxyStyle& style, const QStyleOptionSlider& option, QPainter& painter,
                   const QWidget* widget) {
    const Brushwork brushwork(painter);
    painter.fillRect(option.rect, option.palette.color(QPalette::Window));
    if (option.minimum >= option.maximum) {
        return true;
    }
    const QRectF handle = style.subControlRect(QStyle::CC_ScrollBar, &option, QStyle::SC_ScrollBarSlider, widget);
    const bool held =
        isOn(option, QStyle::State_Sunken) && (option.activeSubControls & QStyle::SC_ScrollBarSlider) != 0;
    const bool pointed = isOn(option, QStyle::State_MouseOver);
    const double inset = held || pointed ? 2.5 : 3.5;
    const bool flat = option.orientation == Qt::Horizontal;
    const QRectF bar = flat ? handle.adjusted(2, inset, -2, -inset) : handle.adjusted(inset, 2, -inset, -2);
    painter.setPen(Qt::NoPen);
    painter.setBrush(held ? option.palette.color(QPalette::PlaceholderText)
                          : option.palette.color(pointed ? QPalette::Dark : QPalette::Mid));
    const double round = (flat ? bar.height() : bar.width()) / 2;
    painter.drawRoundedRect(bar, round, round);
    return true;
}

bool drawProgress(const QStyleOptionProgressBar& option, QPainter& painter) {
    const Brushwork brushwork(painter);
    const QRectF all = option.rect;
    plate(painter, all, option.palette.color(QPalette::Base), option.palette.color(QPalette::Mid));
    const double range = double(option.maximum) - double(option.minimum);
    if (range > 0) {
        const double share = std::clamp((double(option.progress) - option.minimum) / range, 0.0, 1.0);
        const QColor accent = option.palette.color(QPalette::Highlight);
        plate(painter, QRectF(all.left(), all.top(), all.width() * share, all.height()), accent, accent);
    }
    return true;
}

bool drawRubberBand(const QStyleOption& option, QPainter& painter) {
    painter.save();
    QColor fill = option.palette.color(QPalette::Highlight);
    fill.setAlpha(50);
    painter.setPen(accentLine(option.palette));
    painter.setBrush(fill);
    painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
    painter.restore();
    return true;
}

} // namespace spacetow
