#include "editor/window/menus.h"

#include "editor/panels/names.h"

#include <QCoreApplication>

#include <algorithm>

namespace spacetow {

namespace {

constexpr MenuRow menuTable[] = {
    {MenuId::File, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&File")},
    {MenuId::Recent, MenuId::File, QT_TRANSLATE_NOOP("spacetow::MainWindow", "Open &Recent"), Act::Open},
    {MenuId::Backups, MenuId::File, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Backups"), Act::Reload},
    {MenuId::Edit, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Edit")},
    {MenuId::View, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&View")},
    {MenuId::Overlays, MenuId::View, QT_TRANSLATE_NOOP("spacetow::MainWindow", "O&verlays"), Act::Grid},
    {MenuId::Snapping, MenuId::View, QT_TRANSLATE_NOOP("spacetow::MainWindow", "S&napping"), Act::Grid},
    {MenuId::GridStep, MenuId::Snapping, QT_TRANSLATE_NOOP("spacetow::MainWindow", "Grid S&tep"), Act::Snap},
    {MenuId::SubGrid, MenuId::Snapping, QT_TRANSLATE_NOOP("spacetow::MainWindow", "Su&b-Grid"), Act::Snap},
    {MenuId::Panels, MenuId::View, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Panels"), Act::Grid},
    {MenuId::Appearance, MenuId::View, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Appearance"), Act::Grid},
    {MenuId::Language, MenuId::View, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Language"), Act::Grid},
    {MenuId::Insert, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Insert")},
    {MenuId::Object, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Object")},
    {MenuId::Order, MenuId::Object, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Order")},
    {MenuId::Align, MenuId::Object, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Align")},
    {MenuId::Transform, MenuId::Object, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Transform")},
    {MenuId::Path, MenuId::Object, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Path")},
    {MenuId::Level, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Level")},
    {MenuId::Play, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Play")},
    {MenuId::Window, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Window")},
    {MenuId::Help, {}, QT_TRANSLATE_NOOP("spacetow::MainWindow", "&Help")},
};

} // namespace

std::span<const MenuRow> menuRows() {
    return menuTable;
}

const MenuRow& menuRow(MenuId id) {
    return *std::ranges::find(menuTable, id, &MenuRow::id);
}

QString menuText(const MenuRow& row) {
    return QCoreApplication::translate("spacetow::MainWindow", row.text);
}

QString menuPath(MenuId id) {
    const MenuRow& row = menuRow(id);
    const QString name = withoutMnemonic(menuText(row));
    return row.parent ? QStringLiteral("%1 ▸ %2").arg(menuPath(*row.parent), name) : name;
}

} // namespace spacetow
