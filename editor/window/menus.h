#pragma once
// The menus as a table. Their entries are the actions that name them, in the order of the rows.

#include "editor/window/act.h"

#include <QString>

#include <optional>
#include <span>

namespace spacetow {

enum class MenuId : std::uint8_t {
    File,
    Recent,
    Backups,
    Edit,
    View,
    Overlays,
    Snapping,
    GridStep,
    SubGrid,
    Panels,
    Appearance,
    Language,
    Insert,
    Object,
    Order,
    Align,
    Transform,
    Path,
    Level,
    Play,
    Window,
    Help,
};

struct MenuRow {
    MenuId id;
    std::optional<MenuId> parent; // none: it stands in the menu bar
    const char* text;             // with mnemonic; translate with menuText
    /// The action of the parent below which it stands; none: at the end.
    std::optional<ActionId> after = {};
};

/// A menu comes after its parent.
std::span<const MenuRow> menuRows();
const MenuRow& menuRow(MenuId id);
/// Translated, with mnemonic.
QString menuText(const MenuRow& row);
/// "View ▸ Overlays".
QString menuPath(MenuId id);

} // namespace spacetow
