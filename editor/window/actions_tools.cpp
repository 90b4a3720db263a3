// What the tools are called, and their keys. What they do stands in their table, editor/editing/tools.cpp.
#include "editor/editing/guide_verbs.h"
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

void addGuideHere(MainWindow& window) {
    window.toolbox().finish(addGuide(window.toolbox().context(), window.canvas().pointerPosition()));
    window.openGuide(window.document().level().guides.size() - 1);
}

constexpr ActionRow toolsRows[] = {
    {.id = ToolId::Select,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Select"),
     .icon = "select",
     .keys = "S Q",
     .tip = QT_TRANSLATE_NOOP("Actions", "Select and move objects")},
    {.id = ToolId::Nodes,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Nodes"),
     .icon = "nodes",
     .keys = "O N",
     .tip = QT_TRANSLATE_NOOP("Actions", "Move, insert and delete the nodes of selected objects")},
    {.id = ToolId::Knife,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Knife"),
     .icon = "knife",
     .keys = "K",
     .tip = QT_TRANSLATE_NOOP("Actions", "Cut walls, lines and polygons along a line")},
    {.id = ToolId::Edge,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "One-Way &Wall"),
     .icon = "edge",
     .keys = "E",
     .tip = QT_TRANSLATE_NOOP("Actions", "Draw walls that are solid from one side"),
     .flags = SeparatorBefore},
    {.id = ToolId::Line,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "Two-Way &Line"),
     .icon = "line",
     .keys = "L",
     .tip = QT_TRANSLATE_NOOP("Actions", "Draw walls that are solid from both sides")},
    {.id = ToolId::Polygon,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Polygon"),
     .icon = "polygon",
     .keys = "P",
     .tip = QT_TRANSLATE_NOOP("Actions", "Draw a solid polygon")},
    {.id = ToolId::Rectangle,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Rectangle"),
     .icon = "rectangle",
     .keys = "R",
     .tip = QT_TRANSLATE_NOOP("Actions", "Draw a solid rectangle")},
    {.id = ToolId::Circle,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Circle"),
     .icon = "circle",
     .keys = "C",
     .tip = QT_TRANSLATE_NOOP("Actions", "Draw a circle from its center")},
    {.id = ToolId::Kinematic,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Moving Body"),
     .icon = "kinematic",
     .keys = "W",
     .tip = QT_TRANSLATE_NOOP("Actions", "Draw a body that moves as it is told, and its velocity"),
     .flags = SeparatorBefore},
    {.id = ToolId::Connector,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "C&onnector"),
     .icon = "connector",
     .keys = "J",
     .tip = QT_TRANSLATE_NOOP("Actions", "Join two bodies by a spring or rope")},
    {.id = ToolId::Ship,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "S&hip"),
     .icon = "ship",
     .tip = QT_TRANSLATE_NOOP("Actions", "Place the ship; drag to turn it"),
     .flags = KeyElsewhere | SeparatorBefore},
    {.id = ToolId::Payload,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "Pa&yload"),
     .icon = "payload",
     .tip = QT_TRANSLATE_NOOP("Actions", "Place the payload"),
     .flags = KeyElsewhere},
    {.id = ToolId::Finish,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Finish"),
     .icon = "finish",
     .tip = QT_TRANSLATE_NOOP("Actions", "Draw the line that the payload has to cross"),
     .flags = KeyElsewhere},
    {.id = Act::PlaceNext,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "Pl&ace Ship, Payload, Finish"),
     .keys = "I",
     .tip = QT_TRANSLATE_NOOP("Actions", "Place ship, payload or finish; again for the next of them"),
     .run = [](MainWindow& window) { window.takeNextOf(placeTools); }},
    {.id = Act::AddGuide,
     .menu = MenuId::Insert,
     .text = QT_TRANSLATE_NOOP("Actions", "&Guide…"),
     .icon = "guide",
     .keys = "Shift+I",
     .tip = QT_TRANSLATE_NOOP("Actions", "Add a guide at the pointer and type where it is"),
     .flags = SeparatorBefore,
     .run = addGuideHere},
};

} // namespace

std::span<const ActionRow> toolActions() {
    return toolsRows;
}

} // namespace spacetow
