#pragma once
// The nodes of the objects in edit as a table: where each is, exactly, in metres of the world.

#include "core/base/expression.h"
#include "core/level/nodes.h"
#include "editor/editing/document.h"

#include <QAbstractTableModel>

#include <span>
#include <vector>

namespace spacetow {

class NodesModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { Name, X, Y };

    /// The document must outlive the model.
    explicit NodesModel(Document& document, QObject* parent = nullptr);

    /// Looks at the document anew.
    void refresh();
    const NodeRef& node(int row) const { return m_nodes[static_cast<std::size_t>(row)]; }
    /// −1 when there is no such node.
    int rowOf(const NodeRef& node) const;
    /// Of a cell in one of the columns of coordinates.
    double coordinate(const QModelIndex& index) const;
    /// Whether the column has the same number in all rows.
    bool isAlike(std::span<const int> rows, int column) const;
    /// Changes the coordinates of a column in these rows, ascending, as one edit: what is set comes to the very number.
    /// False, and nothing is changed, when a node is not there any more or would leave the range of coordinates. Steps
    /// merge within a second.
    bool change(std::span<const int> rows, int column, const NumberChange& how, bool isStep);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// An expression in the user's spelling; refuses what is none, or out of the range of coordinates.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

  private:
    QString nameOf(const NodeRef& node) const;

    Document& m_document;
    std::vector<NodeRef> m_nodes; // ascending
    std::vector<Vec2> m_places;
    bool m_severalObjects = false;
    bool m_severalShapes = false;
};

} // namespace spacetow
