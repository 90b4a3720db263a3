#include "editor/panels/problem_delegate.h"

#include "editor/panels/names.h"
#include "editor/panels/problem_list.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QToolTip>

namespace spacetow {

namespace {

constexpr int buttonGap = 4; // px, round the button

QStyle& styleOf(const QStyleOptionViewItem& option) {
    return option.widget != nullptr ? *option.widget->style() : *QApplication::style();
}

} // namespace

QRect ProblemDelegate::buttonIn(const QRect& row, const QModelIndex& index) const {
    if (index.data(ProblemList::fixRole).toString().isEmpty()) {
        return {};
    }
    const QFontMetrics metrics(QApplication::font());
    const QSize size(metrics.horizontalAdvance(tr("Fix")) + 16, metrics.height() + 6);
    return {QPoint(row.right() - size.width() - buttonGap, row.top() + (row.height() - size.height()) / 2), size};
}

void ProblemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const QRect button = buttonIn(option.rect, index);
    if (button.isNull()) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    styleOf(option).drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);
    QStyleOptionViewItem text = option;
    text.rect.setRight(button.left() - buttonGap);
    QStyledItemDelegate::paint(painter, text, index);
    QStyleOptionButton look;
    look.rect = button;
    look.text = tr("Fix");
    look.palette = option.palette;
    look.fontMetrics = QFontMetrics(QApplication::font());
    look.state = QStyle::State_Enabled | QStyle::State_Raised | (option.state & QStyle::State_MouseOver);
    styleOf(option).drawControl(QStyle::CE_PushButton, &look, painter, option.widget);
}

QSize ProblemDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    QStyleOptionViewItem narrow = option;
    const QRect button = buttonIn(QRect(0, 0, 1000, 100), index);
    if (view != nullptr) {
        const int taken = button.isNull() ? 0 : button.width() + 2 * buttonGap;
        narrow.rect = QRect(0, 0, std::max(40, view->viewport()->width() - taken - 2), 1000);
    }
    const QSize size = QStyledItemDelegate::sizeHint(narrow, index);
    const int height = button.isNull() ? size.height() : std::max(size.height(), button.height() + 2);
    return {view == nullptr ? size.width() : view->viewport()->width() - 2, height};
}

bool ProblemDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                  const QModelIndex& index) {
    if (event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::MouseButtonPress) {
        const auto& mouse = static_cast<const QMouseEvent&>(*event);
        if (mouse.button() == Qt::LeftButton && buttonIn(option.rect, index).contains(mouse.position().toPoint())) {
            if (event->type() == QEvent::MouseButtonRelease) {
                Q_EMIT fixClicked(index);
            }
            return true;
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

bool ProblemDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                                const QModelIndex& index) {
    if (event->type() == QEvent::ToolTip && buttonIn(option.rect, index).contains(event->pos())) {
        QToolTip::showText(event->globalPos(), plainToolTip(index.data(ProblemList::fixRole).toString()), view);
        return true;
    }
    return QStyledItemDelegate::helpEvent(event, view, option, index);
}

} // namespace spacetow
