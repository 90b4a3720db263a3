#include "editor/panels/nodes_model.h"

#include "core/level/fields.h"
#include "editor/editing/node_pick.h"
#include "editor/panels/names.h"
#include "editor/panels/number_text.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

int axisOf(int column) {
    return column == NodesModel::X ? 0 : 1;
}

std::string mergeKeyOf(std::span<const NodeRef> nodes, int axis) {
    std::string key = "coordinate " + std::to_string(axis);
    for (const NodeRef& node : {nodes.front(), nodes.back()}) {
        key += ' ' + std::to_string(node.key) + ' ' + std::to_string(node.shape) + ' ' + std::to_string(node.vertex);
    }
    return key + ' ' + std::to_string(nodes.size());
}

/// What the change does to one coordinate, as a map of the plane.
Affine mapOf(const NumberChange& change, int axis) {
    const double number = change.operand;
    const bool isFactor = change.kind == NumberChange::Kind::Multiply || change.kind == NumberChange::Kind::Divide;
    Vec2 factors(1, 1);
    Vec2 offset(0, 0);
    if (isFactor) {
        factors[axis] = applied(change, 1);
    } else if (change.isRelative()) {
        offset[axis] = applied(change, 0);
    } else {
        factors[axis] = 0; // a translation might miss it by rounding
        offset[axis] = number;
    }
    return {{factors.x(), 0}, {0, factors.y()}, offset};
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
    const Result<NumberChange> typed = numberChange(withPlainDigits(value.toString()).toStdString(), "m");
    const int row = index.row();
    return typed && change({&row, 1}, index.column(), typed.value(), false);
}

double NodesModel::coordinate(const QModelIndex& index) const {
    return m_places[static_cast<std::size_t>(index.row())][axisOf(index.column())];
}

bool NodesModel::isAlike(std::span<const int> rows, int column) const {
    const auto at = [&](int row) { return m_places[static_cast<std::size_t>(row)][axisOf(column)]; };
    return std::ranges::all_of(rows, [&](int row) { return at(row) == at(rows.front()); });
}

bool NodesModel::change(std::span<const int> rows, int column, const NumberChange& how, bool isStep) {
    const Edit& edit = m_document.current();
    const int axis = axisOf(column);
    std::vector<NodeRef> nodes;
    for (const int row : rows) {
        nodes.push_back(node(row));
        const std::optional<Vec2> place = nodePosition(*edit.level, nodes.back());
        if (!place || !(std::abs(applied(how, (*place)[axis])) <= limits::coordinate)) {
            return false;
        }
    }
    if (nodes.empty()) {
        return false;
    }
    Level level = withMappedNodes(*edit.level, nodes, mapOf(how, axis));
    m_document.commit({"move-nodes", static_cast<int>(nodes.size())},
                      {std::make_shared<const Level>(std::move(level)), edit.selection},
                      isStep ? mergeKeyOf(nodes, axis) : std::string());
    return true;
}

} // namespace spacetow
