#pragma once
// Paints what the command palette has found: icon, name with the letters that were searched for, where it is found
// otherwise, and its key.

#include <QStyledItemDelegate>

namespace spacetow {

class FinderModel;

class FinderDelegate : public QStyledItemDelegate {
  public:
    /// The model must outlive this.
    explicit FinderDelegate(const FinderModel& model, QObject* parent = nullptr)
        : QStyledItemDelegate(parent), m_model(model) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  private:
    const FinderModel& m_model;
};

} // namespace spacetow
