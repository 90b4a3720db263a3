#include "editor/window/finder_delegate.h"

#include "editor/canvas/icons.h"
#include "editor/canvas/palette.h"
#include "editor/window/finder_model.h"

#include <QApplication>
#include <QPainter>
#include <QTextLayout>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int margin = 8;    // px, at either end
constexpr int gap = 12;      // px, between the texts
constexpr int iconSide = 16; // px

/// The name, with the letters in bold that were searched for. Returns its width.
int drawMarked(QPainter& painter, const QRect& box, const QString& name, const std::vector<int>& marks) {
    const QFontMetrics metrics(painter.font());
    QTextLayout layout(metrics.elidedText(name, Qt::ElideRight, box.width()), painter.font());
    QList<QTextLayout::FormatRange> ranges;
    for (const int place : marks) {
        QTextCharFormat format;
        format.setFontWeight(QFont::Bold);
        format.setFontUnderline(true);
        ranges << QTextLayout::FormatRange{place, 1, format};
    }
    layout.setFormats(ranges);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    line.setLineWidth(2 * box.width()); // bold letters are wider
    layout.endLayout();
    layout.draw(&painter, QPointF(box.left(), box.top() + (box.height() - line.height()) / 2));
    return static_cast<int>(line.naturalTextWidth());
}

} // namespace

QSize FinderDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {200, std::max(option.fontMetrics.height() + 10, iconSide + 8)};
}

void FinderDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const FinderRow row = m_model.found(index.row());
    QStyleOptionViewItem panel = option;
    QApplication::style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &panel, painter, option.widget);

    const bool isMarked = option.state.testFlag(QStyle::State_Selected);
    const QColor text = option.palette.color(isMarked ? QPalette::HighlightedText : QPalette::Text);
    const QColor ground = option.palette.color(isMarked ? QPalette::Highlight : QPalette::Base);
    const QColor dim = mixed(text, ground, row.isPossible ? 0.25 : 0.45);
    QRect box = option.rect.adjusted(margin, 0, -margin, 0);

    const QRect iconBox(box.left(), box.center().y() - iconSide / 2 + 1, iconSide, iconSide);
    const QIcon& picture = row.isOn ? livingIcon(QStringLiteral("ok")) : row.icon;
    picture.paint(painter, iconBox, Qt::AlignCenter,
                  !row.isPossible ? QIcon::Disabled
                  : isMarked      ? QIcon::Selected
                                  : QIcon::Normal);
    box.setLeft(iconBox.right() + margin);

    painter->save();
    painter->setFont(option.font);
    if (!row.key.isEmpty()) {
        painter->setPen(dim);
        painter->drawText(box, Qt::AlignRight | Qt::AlignVCenter, row.key);
        box.setRight(box.right() - option.fontMetrics.horizontalAdvance(row.key) - gap);
    }
    painter->setPen(row.isPossible ? text : dim);
    box.setLeft(box.left() + drawMarked(*painter, box, row.name, m_model.marks(row.name)) + gap);
    painter->setPen(dim);
    const QString beside = row.isPossible || row.whyNot.isEmpty() ? row.place : row.whyNot;
    if (box.width() > 3 * gap) {
        painter->drawText(box, Qt::AlignLeft | Qt::AlignVCenter,
                          option.fontMetrics.elidedText(beside, Qt::ElideMiddle, box.width()));
    }
    painter->restore();
}

} // namespace spacetow
