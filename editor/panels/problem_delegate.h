#pragma once
// Rows of the problems panel: the sentence, and where there is a fix a button for it.

#include <QStyledItemDelegate>

namespace spacetow {

class ProblemDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// Of the row that takes up `row`; nothing for rows without a fix.
    QRect buttonIn(const QRect& row, const QModelIndex& index) const;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

  Q_SIGNALS:
    void fixClicked(const QModelIndex& index);
};

} // namespace spacetow
