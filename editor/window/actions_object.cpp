// What is done to selected objects.
#include "editor/editing/verbs.h"
#include "editor/window/verb_action.h"

#include <numbers>

namespace spacetow {

namespace {

constexpr double turn = std::numbers::pi / 12; // 15°
constexpr double quarter = std::numbers::pi / 2;

constexpr ActionRow objectMenuRows[] = {
    {.id = Act::RotateLeft,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Rotate &Left 15°"),
     .icon = "rotate-left",
     .keys = "[",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selection anticlockwise"),
     .flags = NeedsSelection | OnToolsBar | InContextMenu,
     .run = doing<rotateSelected, turn>},
    {.id = Act::RotateRight,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Rotate &Right 15°"),
     .icon = "rotate-right",
     .keys = "]",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selection clockwise"),
     .flags = NeedsSelection | OnToolsBar | InContextMenu,
     .run = doing<rotateSelected, -turn>},
    {.id = Act::QuarterLeft,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Rotate Left &90°"),
     .keys = "Ctrl+[ Z",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selection a quarter anticlockwise"),
     .flags = NeedsSelection,
     .run = doing<rotateSelected, quarter>},
    {.id = Act::QuarterRight,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Rotate Right 9&0°"),
     .keys = "Ctrl+] Shift+Z",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selection a quarter clockwise"),
     .flags = NeedsSelection,
     .run = doing<rotateSelected, -quarter>},
    {.id = Act::Reverse,
     .menu = MenuId::Object,
     .text = QT_TRANSLATE_NOOP("Actions", "Re&verse Direction"),
     .icon = "reverse",
     .keys = "Shift+R",
     .tip = QT_TRANSLATE_NOOP("Actions", "Make one-way walls solid from the other side"),
     .flags = NeedsSelection | SeparatorBefore | OnToolsBar | InContextMenu,
     .run = doing<reverseSelected>},
};

} // namespace

std::span<const ActionRow> objectActions() {
    return objectMenuRows;
}

} // namespace spacetow
