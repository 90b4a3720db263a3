#include "editor/panels/nodes_model.h"

#include "core/base/expression.h"
#include "core/level/fields.h"
#include "editor/editing/node_pick.h"
#include "editor/panels/names.h"
#include "editor/panels/number_text.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

int axisOf(const QModelIndex& index) {
    return index.column() == NodesModel::X ? 0 : 1;
}

std::string mergeKeyOf(const NodeRef& node, int axis) {
    return "coordinate " + std::to_string(node.key) + ' ' + std::to_string(node.shape) + ' ' +
           std::to_string(node.vertex) + ' ' + std::to_string(axis);
}

} // namespace

NodesModel::NodesModel(Document& document, QObject* parent) : QAbstractTableModel(parent), m_document(document) {
    refresh();
}

void NodesModel::refresh() {
    const Edit& shown = m_document.shown();
    const std::vector<Key> keys = keysInEdit(shown);
    std::vector<NodeRef> nodes;
    std::vector<Vec2> places;
    bool severalShapes = false;
    for (const Key key : keys) {
        for (const NodePath& path : nodePaths(shown.level->objects.find(key)->data)) {
            severalShapes = severalShapes || (!nodes.empty() && nodes.back().key == key);
            for (std::size_t i = 0; i < path.points.size(); ++i) {
                nodes.push_back({key, path.shape, static_cast<int>(i)});
                places.push_back(path.points[i]);
            }
        }
    }
    const bool sameRows = nodes == m_nodes;
    const bool sameNames = severalShapes == m_severalShapes && (keys.size() > 1) == m_severalObjects;
    if (sameRows && sameNames && places == m_places) {
        return;
    }
    if (!sameRows) {
        beginResetModel();
    }
    m_nodes = std::move(nodes);
    m_places = std::move(places);
    m_severalObjects = keys.size() > 1;
    m_severalShapes = severalShapes;
    if (!sameRows) {
        endResetModel();
    } else if (!m_nodes.empty()) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Y));
    }
}

int NodesModel::rowOf(const NodeRef& node) const {
    const auto found = std::ranges::lower_bound(m_nodes, node);
    return found != m_nodes.end() && *found == node ? static_cast<int>(found - m_nodes.begin()) : -1;
}

int NodesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_nodes.size());
}

int NodesModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 3;
}

QString NodesModel::nameOf(const NodeRef& node) const {
    QString name = QString::number(node.vertex);
    if (m_severalShapes) {
        name = tr("shape %1: %2").arg(node.shape).arg(name);
    }
    const Object* object = m_severalObjects ? m_document.level().objects.find(node.key) : nullptr;
    return object != nullptr ? tr("%1, %2").arg(displayName(*object), name) : name;
}

QVariant NodesModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::EditRole)) {
        return role == Qt::TextAlignmentRole && index.column() != Name
                   ? QVariant(static_cast<int>(Qt::AlignRight | Qt::AlignVCenter))
                   : QVariant();
    }
    const auto row = static_cast<std::size_t>(index.row());
    return index.column() == Name ? nameOf(m_nodes[row]) : exactNumberText(coordinate(index));
}

QVariant NodesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    return section == Name ? tr("Node") : section == X ? tr("x [m]") : tr("y [m]");
}

Qt::ItemFlags NodesModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.column() == Name ? flags : flags | Qt::ItemIsEditable;
}

bool NodesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() == Name) {
        return false;
    }
    const Result<NumberChange> change = numberChange(withPlainDigits(value.toString()).toStdString(), "m");
    const double number = change ? applied(change.value(), coordinate(index)) : limits::coordinate + 1;
    return std::abs(number) <= limits::coordinate && place(index, number, false);
}

double NodesModel::coordinate(const QModelIndex& index) const {
    return m_places[static_cast<std::size_t>(index.row())][axisOf(index)];
}

bool NodesModel::place(const QModelIndex& index, double value, bool isStep) {
    const NodeRef node = m_nodes[static_cast<std::size_t>(index.row())];
    const Edit& edit = m_document.current();
    const std::optional<Vec2> place = nodePosition(*edit.level, node);
    if (!place) {
        return false;
    }
    Vec2 target = *place;
    target[axisOf(index)] = value;
    // To the very point, which a translation might miss by rounding.
    Level level = withMappedNodes(*edit.level, {&node, 1}, Affine{{0, 0}, {0, 0}, target});
    m_document.commit({"move-nodes", 1}, {std::make_shared<const Level>(std::move(level)), edit.selection},
                      isStep ? mergeKeyOf(node, axisOf(index)) : std::string());
    return true;
}

} // namespace spacetow
