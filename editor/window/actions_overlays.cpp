// What is drawn over bodies, while editing and while playing.
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

template <bool OverlayFlags::*flag>
void setOverlay(MainWindow& window, bool on) {
    OverlayFlags flags = window.overlays();
    flags.*flag = on;
    window.setOverlays(flags);
}

template <bool OverlayFlags::*flag>
bool hasOverlay(const MainWindow& window) {
    return window.overlays().*flag;
}

constexpr ActionRow overlaysRows[] = {
    {.id = Act::OverlayAabb,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Bounding Boxes"),
     .icon = "overlay-aabb",
     .keys = "Alt+1",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the bounding box of every body"),
     .flags = WhilePlaying | OnMainBar,
     .toggle = setOverlay<&OverlayFlags::aabb>,
     .isOn = hasOverlay<&OverlayFlags::aabb>},
    {.id = Act::OverlayIncircle,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Incircles"),
     .icon = "overlay-incircle",
     .keys = "Alt+2",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the incircle of every polygon"),
     .flags = WhilePlaying | OnMainBar,
     .toggle = setOverlay<&OverlayFlags::incircle>,
     .isOn = hasOverlay<&OverlayFlags::incircle>},
    {.id = Act::OverlayVelocity,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Velocities"),
     .icon = "overlay-velocity",
     .keys = "Alt+3",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show where every body would be in a second"),
     .flags = WhilePlaying | OnMainBar,
     .toggle = setOverlay<&OverlayFlags::velocity>,
     .isOn = hasOverlay<&OverlayFlags::velocity>},
    {.id = Act::OverlayOrientation,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Orientations"),
     .icon = "overlay-orientation",
     .keys = "Alt+4",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show which way up every body is"),
     .flags = WhilePlaying | OnMainBar,
     .toggle = setOverlay<&OverlayFlags::orientation>,
     .isOn = hasOverlay<&OverlayFlags::orientation>},
    {.id = Act::OverlayNormals,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Normals"),
     .icon = "overlay-normals",
     .keys = "Alt+5",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the free side of every wall"),
     .flags = WhilePlaying | OnMainBar,
     .toggle = setOverlay<&OverlayFlags::normals>,
     .isOn = hasOverlay<&OverlayFlags::normals>},
    {.id = Act::OverlayQuadtree,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Quadtree"),
     .icon = "overlay-quadtree",
     .keys = "Alt+6",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the cells in which collisions are looked for"),
     .flags = WhilePlaying | OnMainBar,
     .toggle = setOverlay<&OverlayFlags::quadtree>,
     .isOn = hasOverlay<&OverlayFlags::quadtree>},
    {.id = Act::OverlaysOff,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&All Off"),
     .icon = "overlay-none",
     .keys = "Alt+0",
     .tip = QT_TRANSLATE_NOOP("Actions", "Hide all overlays"),
     .flags = WhilePlaying | SeparatorBefore,
     .run = [](MainWindow& window) { window.setOverlays({.problems = window.overlays().problems}); }},
    {.id = Act::OverlayTags,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Tags"),
     .icon = "tag",
     .keys = "Alt+Shift+O",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show names and colors of the tags of every object"),
     .flags = SeparatorBefore,
     .toggle = setOverlay<&OverlayFlags::tags>,
     .isOn = hasOverlay<&OverlayFlags::tags>},
    {.id = Act::OverlayProblems,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Problems"),
     .icon = "warning",
     .keys = "Shift+P",
     .tip = QT_TRANSLATE_NOOP("Actions", "Mark the places of all problems of the level"),
     .toggle = setOverlay<&OverlayFlags::problems>,
     .isOn = hasOverlay<&OverlayFlags::problems>},
    {.id = Act::ShowCollisions,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "Show What &Collides"),
     .icon = "collides",
     .keys = "Shift+T",
     .tip = QT_TRANSLATE_NOOP("Actions", "Mark everything that the selection would collide with, by its tags"),
     .toggle = [](MainWindow& window, bool on) { window.collisions().setOn(on); },
     .isOn = [](const MainWindow& window) { return window.collisions().isOn(); }},
};

} // namespace

std::span<const ActionRow> overlayActions() {
    return overlaysRows;
}

} // namespace spacetow
