#include "editor/panels/outliner_model.h"

#include "core/level/arrange.h"
#include "editor/editing/outline_verbs.h"

#include <QCoreApplication>
#include <QMimeData>

#include <algorithm>

namespace spacetow {

namespace {

constexpr auto mimeType = "application/x-spacetow-objects";
constexpr int manyRuns = 200; // of rows that come or go; for more the view begins anew

using Nodes = std::vector<OutlinerNode*>;

/// Calls `visit(first, last)` for each run of neighbours in the list for which `isWanted`, from the end to the start.
template <class IsWanted, class Visit>
void visitRuns(const Nodes& nodes, IsWanted isWanted, Visit visit) {
    for (int last = static_cast<int>(nodes.size()) - 1; last >= 0; --last) {
        if (!isWanted(*nodes[static_cast<std::size_t>(last)])) {
            continue;
        }
        int first = last;
        while (first > 0 && isWanted(*nodes[static_cast<std::size_t>(first - 1)])) {
            --first;
        }
        visit(first, last);
        last = first;
    }
}

bool isNew(const OutlinerNode& node) {
    return node.isNew;
}

bool isGone(const OutlinerNode& node) {
    return node.order < 0 && node.key != 0; // the root never goes
}

/// Rows that come or go.
int runsOf(const OutlinerArrangement& arrangement) {
    int runs = 0;
    const auto count = [&runs](int, int) { ++runs; };
    for (const auto& [parent, members] : arrangement.members) {
        if (!isNew(*parent) && !isGone(*parent)) {
            visitRuns(members, isNew, count);
            visitRuns(parent->members, isGone, count);
        }
    }
    return runs;
}

void setMembers(OutlinerNode& parent, Nodes members) {
    parent.members = std::move(members);
    int place = 0;
    for (OutlinerNode* member : parent.members) {
        member->parent = &parent;
        member->place = place++;
    }
    parent.hasCounted = true;
}

} // namespace

OutlinerModel::OutlinerModel(Document& document, Toolbox& toolbox, QObject* parent)
    : QAbstractItemModel(parent), m_document(document), m_toolbox(toolbox), m_level(std::make_shared<Level>()) {}

OutlinerModel::~OutlinerModel() = default;

void OutlinerModel::refresh() {
    const Edit shown = m_document.shown();
    if (shown.level != m_level) {
        Nodes changed;
        if (isListedOtherwise(*shown.level, changed)) {
            restructure(shown.level);
        } else {
            m_level = shown.level;
            announce(changed);
        }
    }
    if (shown.selection.entered() != m_entered) {
        Nodes groups{m_tree.find(m_entered), m_tree.find(shown.selection.entered())};
        m_entered = shown.selection.entered();
        std::erase(groups, nullptr);
        announce(groups);
    }
}

/// Else only what looks different has to be drawn anew.
bool OutlinerModel::isListedOtherwise(const Level& after, Nodes& changed) const {
    const ObjectList& before = m_level->objects;
    if (before.size() != after.objects.size() || (m_filter.asksForTags() && !(m_level->tags == after.tags))) {
        return true;
    }
    bool differs = false;
    after.objects.visitDifferences(before, [&](int index) {
        const Object& was = before[index];
        const Object& now = after.objects[index];
        OutlinerNode* const node = m_tree.at(index);
        const bool wasGroup = std::holds_alternative<GroupObject>(was.data);
        differs = differs || was.key != now.key || was.parent != now.parent ||
                  wasGroup != std::holds_alternative<GroupObject>(now.data) ||
                  (isFiltered() && m_filter.finds(was) != m_filter.finds(now));
        if (!differs && node != nullptr && !looksAlike(was, now)) {
            changed.push_back(node);
        }
    });
    return differs;
}

void OutlinerModel::restructure(
    std::shared_ptr<const Level> after) { // NOLINT(performance-unnecessary-value-param): it may be m_level
    m_filter.prepare(after->tags);
    const std::shared_ptr<const Level> before = std::exchange(m_level, after);
    const OutlinerArrangement arrangement = m_tree.arrange(before->objects, *after, m_filter);
    if (runsOf(arrangement) > manyRuns) {
        beginResetModel();
        for (const auto& [parent, members] : arrangement.members) {
            if (!isGone(*parent)) {
                setMembers(*parent, members);
            }
            for (OutlinerNode* member : members) {
                member->isNew = false;
            }
        }
        m_tree.forget(arrangement.gone);
        endResetModel();
        return;
    }
    insertNew(arrangement);
    moveKept(arrangement);
    removeGone(arrangement);
    m_tree.forget(arrangement.gone);
    announce(arrangement.changed);
}

void OutlinerModel::insertNew(const OutlinerArrangement& arrangement) {
    for (const auto& [node, members] : arrangement.members) {
        OutlinerNode& parent = *node;
        if (isNew(parent) || isGone(parent)) {
            continue; // the new members of new groups are in them already
        }
        const auto insert = [&](int first, int last) {
            int at = 0; // behind the last one before them that is here already
            for (int before = first - 1; before >= 0; --before) {
                OutlinerNode& neighbor = *members[static_cast<std::size_t>(before)];
                if (neighbor.parent == &parent && !isNew(neighbor)) {
                    at = rowCount(indexOf(parent)) - m_tree.rowOf(neighbor);
                    break;
                }
            }
            const int row = static_cast<int>(parent.members.size()) - at;
            beginInsertRows(indexOf(parent), row, row + last - first);
            parent.members.insert(parent.members.begin() + at, members.begin() + first, members.begin() + last + 1);
            parent.hasCounted = false;
            endInsertRows();
        };
        visitRuns(members, isNew, insert);
    }
    for (const auto& [parent, members] : arrangement.members) {
        for (OutlinerNode* member : members) {
            member->isNew = false;
        }
    }
}

void OutlinerModel::moveKept(const OutlinerArrangement& arrangement) {
    const auto isInPlace = [](const auto& entry) {
        auto expected = entry.second.begin();
        for (const OutlinerNode* member : entry.first->members) {
            if (!isGone(*member) && (expected == entry.second.end() || *expected++ != member)) {
                return false;
            }
        }
        return expected == entry.second.end();
    };
    if (std::ranges::all_of(arrangement.members, isInPlace)) {
        return;
    }
    Q_EMIT layoutAboutToBeChanged();
    const QModelIndexList before = persistentIndexList();
    for (const auto& [parent, members] : arrangement.members) {
        Nodes all = members;
        std::ranges::copy_if(parent->members, std::back_inserter(all), [](const auto* node) { return isGone(*node); });
        setMembers(*parent, std::move(all));
    }
    QModelIndexList after;
    for (const QModelIndex& index : before) {
        after << indexOf(nodeOf(index), index.column());
    }
    changePersistentIndexList(before, after);
    Q_EMIT layoutChanged();
}

void OutlinerModel::removeGone(const OutlinerArrangement& arrangement) {
    for (const auto& [node, members] : arrangement.members) {
        OutlinerNode& parent = *node;
        if (isGone(parent)) {
            continue; // goes with what is in it
        }
        const auto remove = [&](int first, int last) {
            const int size = static_cast<int>(parent.members.size());
            beginRemoveRows(indexOf(parent), size - 1 - last, size - 1 - first);
            parent.members.erase(parent.members.begin() + first, parent.members.begin() + last + 1);
            parent.hasCounted = false;
            endRemoveRows();
        };
        visitRuns(Nodes(parent.members), isGone, remove);
    }
}

/// As one range in each group: views draw anew only what is in sight.
void OutlinerModel::announce(const Nodes& nodes) {
    std::unordered_map<const OutlinerNode*, std::pair<int, int>> rowsOf;
    for (const OutlinerNode* node : nodes) {
        const int row = m_tree.rowOf(*node);
        const auto [found, isFirst] = rowsOf.emplace(node->parent, std::pair(row, row));
        found->second = {std::min(found->second.first, row), std::max(found->second.second, row)};
    }
    for (const auto& [parent, rows] : rowsOf) {
        const QModelIndex group = indexOf(*parent);
        Q_EMIT dataChanged(index(rows.first, 0, group), index(rows.second, ColumnCount - 1, group));
    }
    for (OutlinerNode* node : nodes) {
        announceAll(*node); // they are as hidden as their group
    }
}

void OutlinerModel::announceAll(OutlinerNode& parent) {
    if (parent.members.empty()) {
        return;
    }
    const QModelIndex group = indexOf(parent);
    Q_EMIT dataChanged(index(0, 0, group), index(rowCount(group) - 1, ColumnCount - 1, group));
    for (OutlinerNode* member : parent.members) {
        announceAll(*member);
    }
}

void OutlinerModel::setFilter(const ObjectFilter& filter) {
    m_filter = filter;
    restructure(m_level);
}

std::vector<Key> OutlinerModel::foundKeys() const {
    std::vector<Key> keys;
    for (const Object& object : m_level->objects) {
        if (m_filter.finds(object)) {
            keys.push_back(object.key);
        }
    }
    return keys;
}

void OutlinerModel::setPalette(const QPalette& palette) {
    m_palette = palette;
    announceAll(m_tree.root());
}

OutlinerNode& OutlinerModel::nodeOf(const QModelIndex& index) const {
    return index.isValid() ? *static_cast<OutlinerNode*>(index.internalPointer()) : m_tree.root();
}

QModelIndex OutlinerModel::indexOf(const OutlinerNode& node, int column) const {
    return node.parent == nullptr ? QModelIndex() : createIndex(m_tree.rowOf(node), column, &node);
}

Key OutlinerModel::keyOf(const QModelIndex& index) {
    return index.isValid() ? static_cast<const OutlinerNode*>(index.internalPointer())->key : 0;
}

QModelIndex OutlinerModel::indexOf(Key key, int column) const {
    const OutlinerNode* const node = m_tree.find(key);
    return node == nullptr ? QModelIndex() : indexOf(*node, column);
}

const Object* OutlinerModel::objectOf(const QModelIndex& index) const {
    const OutlinerNode& node = nodeOf(index);
    return node.order < 0 ? nullptr : &m_level->objects[node.order];
}

ObjectPlace OutlinerModel::placeAt(const QModelIndex& parent, int row) const {
    const QModelIndex above = row > 0 ? index(row - 1, Name, parent) : QModelIndex();
    return {keyOf(parent), keyOf(above)};
}

QModelIndex OutlinerModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    const Nodes& members = nodeOf(parent).members;
    return createIndex(row, column, members[members.size() - 1 - static_cast<std::size_t>(row)]);
}

QModelIndex OutlinerModel::parent(const QModelIndex& child) const {
    return child.isValid() ? indexOf(*nodeOf(child).parent) : QModelIndex();
}

int OutlinerModel::rowCount(const QModelIndex& parent) const {
    return parent.column() > 0 ? 0 : static_cast<int>(nodeOf(parent).members.size());
}

int OutlinerModel::columnCount(const QModelIndex&) const {
    return ColumnCount;
}

bool OutlinerModel::hasChildren(const QModelIndex& parent) const {
    return rowCount(parent) > 0;
}

Qt::ItemFlags OutlinerModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::ItemIsDropEnabled;
    }
    const Object* const object = objectOf(index);
    if (object == nullptr) {
        return Qt::NoItemFlags;
    }
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.column() == Name) {
        flags |= Qt::ItemIsEditable;
        flags |= isLocked(nodeOf(index)) ? Qt::NoItemFlags : Qt::ItemIsDragEnabled;
    }
    return flags | (std::holds_alternative<GroupObject>(object->data) ? Qt::ItemIsDropEnabled : Qt::NoItemFlags);
}

bool OutlinerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || index.column() != Name || objectOf(index) == nullptr) {
        return false;
    }
    return m_toolbox.finish(renameObject(m_document.current(), keyOf(index), value.toString().toStdString()));
}

bool OutlinerModel::isLocked(const OutlinerNode& node) const {
    for (const OutlinerNode* each = &node; each->parent != nullptr; each = each->parent) {
        if (each->order >= 0 && m_level->objects[each->order].locked) {
            return true;
        }
    }
    return false;
}

QStringList OutlinerModel::mimeTypes() const {
    return {QLatin1String(mimeType)};
}

/// So that what is dragged out of another window or another program is not taken for ours.
QByteArray OutlinerModel::dragMark() const {
    return QByteArray::number(QCoreApplication::applicationPid()) + ' ' +
           QByteArray::number(reinterpret_cast<quintptr>(this));
}

QMimeData* OutlinerModel::mimeData(const QModelIndexList& indexes) const {
    m_dragged.clear();
    for (const QModelIndex& index : indexes) {
        if (index.column() == Name) {
            m_dragged.push_back(keyOf(index));
        }
    }
    auto* const data = new QMimeData; // owned by the drag
    data->setData(QLatin1String(mimeType), dragMark());
    return data;
}

bool OutlinerModel::isDragOfOurs(const QMimeData* data) const {
    return data != nullptr && data->data(QLatin1String(mimeType)) == dragMark();
}

bool OutlinerModel::canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int /*column*/,
                                    const QModelIndex& parent) const {
    return action == Qt::MoveAction && isDragOfOurs(data) &&
           mayRegroup(*m_level, m_dragged, placeAt(parent, row).parent);
}

bool OutlinerModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                 const QModelIndex& parent) {
    if (!canDropMimeData(data, action, row, column, parent)) {
        return false;
    }
    const Edit edit = m_document.current();
    const std::vector<Key> movable = unlockedKeys(*edit.level, m_dragged);
    if (std::ranges::none_of(m_dragged, [&](Key key) { return std::ranges::binary_search(movable, key); })) {
        Q_EMIT dropRefused();
        return false;
    }
    return m_toolbox.finish(regroup(edit, m_dragged, placeAt(parent, row)));
}

} // namespace spacetow
