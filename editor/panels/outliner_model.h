#pragma once
// The level as a tree for item views: what is drawn on top comes first, groups hold their members. Follows the document
// row by row: what has not changed keeps its index, and with it selection, scrolling and what is unfolded.

#include "core/level/groups.h"
#include "editor/editing/toolbox.h"
#include "editor/panels/outliner_tree.h"

#include <QAbstractItemModel>
#include <QPalette>

#include <memory>
#include <vector>

namespace spacetow {

class OutlinerModel : public QAbstractItemModel {
    Q_OBJECT

  public:
    enum Column { Name, Color, Eye, Lock, ColumnCount };
    static constexpr int keyRole = Qt::UserRole;

    /// Document and toolbox must outlive the model. It is empty until the first refresh.
    OutlinerModel(Document& document, Toolbox& toolbox, QObject* parent = nullptr);
    ~OutlinerModel() override;

    /// Shows what the document shows. Costs what has changed, but for objects that come, go or change places: then a
    /// look at each.
    void refresh();
    void setFilter(const ObjectFilter& filter);
    bool isFiltered() const { return !m_filter.isEmpty(); }
    /// All that the filter finds, without the groups that are listed because of it.
    std::vector<Key> foundKeys() const;
    /// Of the texts and icons.
    void setPalette(const QPalette& palette);

    /// 0 for the root.
    static Key keyOf(const QModelIndex& index);
    /// Invalid when it is not listed.
    QModelIndex indexOf(Key key, int column = Name) const;
    const Object* objectOf(const QModelIndex& index) const;
    /// The place in the level of what would be put between the rows `row − 1` and `row`, or −1 for on top of `parent`.
    ObjectPlace placeAt(const QModelIndex& parent, int row) const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    bool hasChildren(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Renames.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                         const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

  Q_SIGNALS:
    /// Of what was dropped nothing can be moved.
    void dropRefused();

  private:
    OutlinerNode& nodeOf(const QModelIndex& index) const;
    QModelIndex indexOf(const OutlinerNode& node, int column = Name) const;
    bool isListedOtherwise(const Level& after, std::vector<OutlinerNode*>& changed) const;
    void restructure(std::shared_ptr<const Level> after);
    void insertNew(const OutlinerArrangement& arrangement);
    void moveKept(const OutlinerArrangement& arrangement);
    void removeGone(const OutlinerArrangement& arrangement);
    void announce(const std::vector<OutlinerNode*>& nodes);
    void announceAll(OutlinerNode& parent);
    bool isDragOfOurs(const QMimeData* data) const;
    QByteArray dragMark() const;
    QVariant nameData(const OutlinerNode& node, const Object& object, int role) const;
    QVariant switchData(const Object& object, int column, int role) const;
    QColor ink(const OutlinerNode& node) const;
    bool isLocked(const OutlinerNode& node) const;

    Document& m_document;
    Toolbox& m_toolbox;
    mutable OutlinerTree m_tree;
    std::shared_ptr<const Level> m_level; // that is listed; never null
    Key m_entered = 0;
    ObjectFilter m_filter;
    QPalette m_palette;
    mutable std::vector<Key> m_dragged;
};

} // namespace spacetow
