// What the rows of the outliner look like.
#include "editor/canvas/icons.h"
#include "editor/panels/names.h"
#include "editor/panels/outliner_model.h"

#include <QFont>
#include <QPainter>
#include <QPixmap>

namespace spacetow {

namespace {

constexpr int swatchSize = 12; // logical pixels

QIcon swatch(std::uint32_t color, const QPalette& palette) {
    QPixmap pixmap(2 * swatchSize, 2 * swatchSize);
    pixmap.setDevicePixelRatio(2);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette.color(QPalette::Mid));
    painter.setBrush(QColor::fromRgb(color));
    painter.drawRoundedRect(QRectF(0.5, 0.5, swatchSize - 1, swatchSize - 1), 3, 3);
    return pixmap;
}

/// A third of the way from the ground to the ink; icons know no transparency.
QColor faint(const QColor& ink, const QColor& ground) {
    const auto mixed = [](int one, int other) { return (one + 2 * other) / 3; };
    return QColor(mixed(ink.red(), ground.red()), mixed(ink.green(), ground.green()), mixed(ink.blue(), ground.blue()));
}

/// What is as usual is faint, so that what is not is seen.
QIcon switchIcon(const QString& name, bool isOff, const QPalette& palette) {
    const auto color = [&](QPalette::ColorRole ink, QPalette::ColorRole ground) {
        return isOff ? palette.color(ink) : faint(palette.color(ink), palette.color(ground));
    };
    return icon(name, color(QPalette::Text, QPalette::Base), color(QPalette::HighlightedText, QPalette::Highlight));
}

} // namespace

/// Faint is what is hidden, and what a filter shows only because it holds what was found.
QColor OutlinerModel::ink(const OutlinerNode& node) const {
    bool visible = !isFiltered() || (node.order >= 0 && m_filter.finds(m_level->objects[node.order]));
    for (const OutlinerNode* each = &node; each->parent != nullptr; each = each->parent) {
        visible = visible && each->order >= 0 && m_level->objects[each->order].visible;
    }
    return m_palette.color(visible ? QPalette::Active : QPalette::Disabled, QPalette::Text);
}

QVariant OutlinerModel::data(const QModelIndex& index, int role) const {
    const Object* const object = objectOf(index);
    if (object == nullptr) {
        return {};
    }
    if (role == keyRole) {
        return object->key;
    }
    return index.column() == Name ? nameData(nodeOf(index), *object, role) : switchData(*object, index.column(), role);
}

QVariant OutlinerModel::nameData(const OutlinerNode& node, const Object& object, int role) const {
    switch (role) {
    case Qt::DisplayRole:
        return displayName(object);
    case Qt::EditRole:
        return QString::fromStdString(object.name);
    case Qt::DecorationRole:
        return icon(kindIcon(object), ink(node), m_palette.color(QPalette::HighlightedText));
    case Qt::ForegroundRole:
        return ink(node);
    case Qt::ToolTipRole:
        return plainToolTip(object.name.empty() ? placedKind(object)
                                                : tr("%1: %2").arg(displayName(object), placedKind(object)));
    case Qt::FontRole: {
        QFont font;
        font.setBold(object.key == m_entered);
        return font;
    }
    default:
        return {};
    }
}

QVariant OutlinerModel::switchData(const Object& object, int column, int role) const {
    const auto* group = std::get_if<GroupObject>(&object.data);
    if (column == Color) {
        const bool isShown = group != nullptr && group->color;
        return role == Qt::DecorationRole && isShown ? QVariant(swatch(*group->color, m_palette))
               : role == Qt::ToolTipRole && group != nullptr
                   ? QVariant(tr("Color of the group. Click to choose another one"))
                   : QVariant();
    }
    const bool isEye = column == Eye;
    const bool isOff = isEye ? !object.visible : object.locked;
    switch (role) {
    case Qt::DecorationRole:
        return switchIcon(isEye ? (isOff ? QStringLiteral("eye-off") : QStringLiteral("eye"))
                                : (isOff ? QStringLiteral("lock") : QStringLiteral("unlock")),
                          isOff, m_palette);
    case Qt::ToolTipRole:
        return isEye ? (isOff ? tr("Hidden in the editor; played all the same. Click to show it")
                              : tr("Visible. Click to hide it in the editor"))
                     : (isOff ? tr("Locked: not picked on the canvas, moved or deleted. Click to unlock it")
                              : tr("Not locked. Click to lock it against changes"));
    case Qt::AccessibleTextRole:
        return isEye ? (isOff ? tr("hidden") : tr("visible")) : (isOff ? tr("locked") : tr("not locked"));
    default:
        return {};
    }
}

QVariant OutlinerModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Name:
        return tr("Name");
    case Color:
        return tr("Color");
    case Eye:
        return tr("Visible");
    default:
        return tr("Locked");
    }
}

} // namespace spacetow
