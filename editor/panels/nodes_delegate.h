#pragma once
// Edits a coordinate in the table of nodes with the field that numbers have everywhere: in all selected rows, when the
// cell is in one of several. What is no number stays in the cell to be mended.

#include "core/base/result.h"
#include "editor/panels/nodes_model.h"

#include <QStyledItemDelegate>

#include <functional>

namespace spacetow {

class NodesDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    /// The model must outlive the delegate.
    explicit NodesDelegate(NodesModel& model, QObject* parent = nullptr);

    /// Makes a sentence of a code of core/base/expression.
    std::function<QString(const Error&)> words;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void destroyEditor(QWidget* editor, const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

  Q_SIGNALS:
    /// Empty when nothing is wrong any more.
    void faultShown(const QString& fault) const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    NodesModel& m_model;
};

} // namespace spacetow
