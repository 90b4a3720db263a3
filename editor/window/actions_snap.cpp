// What points snap to, and how fine the grid is.
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

using Switch = bool SnapSettings::*;

template <Switch on>
void setSwitch(MainWindow& window, bool value) {
    SnapSettings snap = window.toolbox().snap;
    snap.*on = value;
    window.setSnap(snap);
}

template <Switch on>
bool isSwitchOn(const MainWindow& window) {
    return window.toolbox().snap.*on;
}

bool isSmart(const MainWindow& window) {
    return window.toolbox().snap.smart;
}

void setStep(MainWindow& window, double step) {
    SnapSettings snap = window.toolbox().snap;
    snap.step = step;
    window.setSnap(snap);
}

constexpr ActionRow snapRows[] = {
    {.id = Act::Snap,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Snap to Grid"),
     .icon = "grid",
     .keys = "Shift+G",
     .tip = QT_TRANSLATE_NOOP("Actions", "Let points land on the grid; Ctrl suspends it while it is held"),
     .toggle = setSwitch<&SnapSettings::grid>,
     .isOn = isSwitchOn<&SnapSettings::grid>},
    {.id = Act::CoarserGrid,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Coarser Grid"),
     .keys = "Num+* Ctrl+Shift+PgUp",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go on to the next larger step of the grid"),
     .run = [](MainWindow& window) { setStep(window, coarserStep(window.toolbox().snap.step)); },
     .isPossible =
         [](const MainWindow& window) { return coarserStep(window.toolbox().snap.step) != window.toolbox().snap.step; },
     .why = QT_TRANSLATE_NOOP("Actions", "The grid is as coarse as it gets.")},
    {.id = Act::FinerGrid,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Finer Grid"),
     .keys = "Num+/ Ctrl+Shift+PgDown",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go on to the next smaller step of the grid"),
     .run = [](MainWindow& window) { setStep(window, finerStep(window.toolbox().snap.step)); },
     .isPossible =
         [](const MainWindow& window) { return finerStep(window.toolbox().snap.step) != window.toolbox().snap.step; },
     .why = QT_TRANSLATE_NOOP("Actions", "The grid is as fine as it gets.")},
    {.id = Act::SmartSnap,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "Snap to &Objects"),
     .icon = "snap",
     .keys = "Shift+S %",
     .tip = QT_TRANSLATE_NOOP("Actions", "Let points land on what is in the level; Ctrl suspends it while it is held"),
     .flags = SeparatorBefore | OnMainBar,
     .toggle = setSwitch<&SnapSettings::smart>,
     .isOn = isSwitchOn<&SnapSettings::smart>},
    {.id = Act::SnapVertices,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Vertices and Centers"),
     .icon = "snap-vertex",
     .keys = "Ctrl+Shift+F1",
     .tip = QT_TRANSLATE_NOOP("Actions", "Snap to the vertices of objects, and to the centers of circles"),
     .toggle = setSwitch<&SnapSettings::vertices>,
     .isOn = isSwitchOn<&SnapSettings::vertices>,
     .isPossible = isSmart,
     .why = QT_TRANSLATE_NOOP("Actions", "Only while snapping to objects is on.")},
    {.id = Act::SnapMidpoints,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Midpoints"),
     .icon = "snap-midpoint",
     .keys = "Ctrl+Shift+F2",
     .tip = QT_TRANSLATE_NOOP("Actions", "Snap to the middles of segments"),
     .toggle = setSwitch<&SnapSettings::midpoints>,
     .isOn = isSwitchOn<&SnapSettings::midpoints>,
     .isPossible = isSmart,
     .why = QT_TRANSLATE_NOOP("Actions", "Only while snapping to objects is on.")},
    {.id = Act::SnapIntersections,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Intersections"),
     .icon = "snap-intersection",
     .keys = "Ctrl+Shift+F3",
     .tip = QT_TRANSLATE_NOOP("Actions", "Snap to where edges and guides cross"),
     .toggle = setSwitch<&SnapSettings::intersections>,
     .isOn = isSwitchOn<&SnapSettings::intersections>,
     .isPossible = isSmart,
     .why = QT_TRANSLATE_NOOP("Actions", "Only while snapping to objects is on.")},
    {.id = Act::SnapPerpendiculars,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Perpendiculars"),
     .icon = "snap-perpendicular",
     .keys = "Ctrl+Shift+F4",
     .tip = QT_TRANSLATE_NOOP("Actions", "Snap to where the way from the last point meets an edge at a right angle"),
     .toggle = setSwitch<&SnapSettings::perpendiculars>,
     .isOn = isSwitchOn<&SnapSettings::perpendiculars>,
     .isPossible = isSmart,
     .why = QT_TRANSLATE_NOOP("Actions", "Only while snapping to objects is on.")},
    {.id = Act::SnapEdges,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Edges"),
     .icon = "snap-edge",
     .keys = "Ctrl+Shift+F5",
     .tip = QT_TRANSLATE_NOOP("Actions", "Snap to the edges of objects"),
     .toggle = setSwitch<&SnapSettings::edges>,
     .isOn = isSwitchOn<&SnapSettings::edges>,
     .isPossible = isSmart,
     .why = QT_TRANSLATE_NOOP("Actions", "Only while snapping to objects is on.")},
    {.id = Act::SnapGuides,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "G&uides"),
     .icon = "snap-guide",
     .keys = "Ctrl+Shift+F6",
     .tip = QT_TRANSLATE_NOOP("Actions", "Snap to guides"),
     .toggle = setSwitch<&SnapSettings::guides>,
     .isOn = isSwitchOn<&SnapSettings::guides>,
     .isPossible = isSmart,
     .why = QT_TRANSLATE_NOOP("Actions", "Only while snapping to objects is on.")},
    {.id = Act::SnapAlignment,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "&Alignment"),
     .icon = "snap-align",
     .keys = "Ctrl+Shift+F7",
     .tip = QT_TRANSLATE_NOOP("Actions", "Snap in line with the sides and middles of other objects"),
     .toggle = setSwitch<&SnapSettings::alignment>,
     .isOn = isSwitchOn<&SnapSettings::alignment>,
     .isPossible = isSmart,
     .why = QT_TRANSLATE_NOOP("Actions", "Only while snapping to objects is on.")},
    {.id = Act::SnapAngles,
     .menu = MenuId::Snapping,
     .text = QT_TRANSLATE_NOOP("Actions", "A&ngles"),
     .icon = "snap-angle",
     .keys = "Ctrl+Shift+F8",
     .tip = QT_TRANSLATE_NOOP("Actions", "Snap to multiples of 15° from the last point; Shift keeps to them always"),
     .toggle = setSwitch<&SnapSettings::angles>,
     .isOn = isSwitchOn<&SnapSettings::angles>,
     .isPossible = isSmart,
     .why = QT_TRANSLATE_NOOP("Actions", "Only while snapping to objects is on.")},
};

} // namespace

std::span<const ActionRow> snapActions() {
    return snapRows;
}

} // namespace spacetow
