#include "editor/panels/section_header.h"

#include <QPainter>
#include <QStyleOption>

namespace spacetow {

namespace {

constexpr int arrowSide = 12; // px
constexpr int gapBesideArrow = 4;
constexpr int above = 6; // px of air over the title
constexpr int below = 3;

} // namespace

SectionHeader::SectionHeader(const QString& title, QWidget* parent) : QAbstractButton(parent) {
    setText(title);
    setCheckable(true);
    setChecked(true);
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QFont bold = font();
    bold.setBold(true);
    setFont(bold);
}

QSize SectionHeader::sizeHint() const {
    return {arrowSide + gapBesideArrow + fontMetrics().horizontalAdvance(text()) + 2 * below,
            above + fontMetrics().height() + below};
}

void SectionHeader::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (underMouse() && isEnabled()) {
        painter.fillRect(rect().adjusted(0, above - below, 0, 0), palette().color(QPalette::Midlight));
    }
    QStyleOption arrow;
    arrow.initFrom(this);
    arrow.rect = QRect(0, above + (fontMetrics().height() - arrowSide) / 2, arrowSide, arrowSide);
    const auto shape = isChecked() ? QStyle::PE_IndicatorArrowDown : QStyle::PE_IndicatorArrowRight;
    style()->drawPrimitive(shape, &arrow, &painter, this);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(arrowSide + gapBesideArrow, above, 0, -below), Qt::AlignLeft | Qt::AlignVCenter,
                     text());
    painter.setPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Mid));
    painter.drawLine(rect().bottomLeft(), rect().bottomRight());
}

} // namespace spacetow
