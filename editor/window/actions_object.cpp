// What is done to selected objects.
#include "editor/editing/arrange_verbs.h"
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
     .keys = "[ Ctrl+Left",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selection anticlockwise"),
     .flags = NeedsSelection | OnToolsBar | NeedsUnlocked,
     .run = doing<rotateSelected, turn>},
    {.id = Act::RotateRight,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Rotate &Right 15°"),
     .icon = "rotate-right",
     .keys = "] Ctrl+Right",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selection clockwise"),
     .flags = NeedsSelection | OnToolsBar | NeedsUnlocked,
     .run = doing<rotateSelected, -turn>},
    {.id = Act::QuarterLeft,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Rotate Left &90°"),
     .keys = "Ctrl+[ Z",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selection a quarter anticlockwise"),
     .flags = NeedsSelection | NeedsUnlocked,
     .run = doing<rotateSelected, quarter>},
    {.id = Act::QuarterRight,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Rotate Right 9&0°"),
     .keys = "Ctrl+] Shift+Z",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selection a quarter clockwise"),
     .flags = NeedsSelection | NeedsUnlocked,
     .run = doing<rotateSelected, -quarter>},
    {.id = Act::FlipHorizontally,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Flip &Horizontally"),
     .icon = "flip-h",
     .keys = "X",
     .tip = QT_TRANSLATE_NOOP("Actions", "Swap left and right; walls stay solid on the same side"),
     .flags = NeedsSelection | SeparatorBefore | NeedsUnlocked,
     .run = doing<flipSelected, FlipAxis::Horizontal>},
    {.id = Act::FlipVertically,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Flip &Vertically"),
     .icon = "flip-v",
     .keys = "Y",
     .tip = QT_TRANSLATE_NOOP("Actions", "Swap above and below; walls stay solid on the same side"),
     .flags = NeedsSelection | NeedsUnlocked,
     .run = doing<flipSelected, FlipAxis::Vertical>},
    {.id = Act::RepeatLast,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "Re&peat Last Transform"),
     .icon = "repeat",
     .keys = "Ctrl+Shift+R",
     .tip = QT_TRANSLATE_NOOP("Actions", "Move, turn, scale or copy the selection once more as it was done last"),
     .flags = NeedsSelection | SeparatorBefore | NeedsUnlocked,
     .run = doing<repeatLast>},
    {.id = Act::TypeTransform,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "&Type Place and Size…"),
     .keys = "Ctrl+Shift+M",
     .tip = QT_TRANSLATE_NOOP("Actions", "Move, scale and turn the selection by numbers"),
     .flags = NeedsSelection | SeparatorBefore | NeedsUnlocked,
     .run = [](MainWindow& window) { window.transformBar().begin(); }},
    {.id = Act::LinearArray,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "L&inear Array…"),
     .icon = "array-linear",
     .keys = "Ctrl+Shift+D",
     .tip = QT_TRANSLATE_NOOP("Actions", "Make copies of the selection in a row"),
     .flags = NeedsSelection | SeparatorBefore | NeedsCopyable,
     .run = [](MainWindow& window) { window.arrayBar().begin(ArrayBar::Kind::Linear); }},
    {.id = Act::RadialArray,
     .menu = MenuId::Transform,
     .text = QT_TRANSLATE_NOOP("Actions", "R&adial Array…"),
     .icon = "array-radial",
     .keys = "Ctrl+Alt+D",
     .tip = QT_TRANSLATE_NOOP("Actions", "Make copies of the selection round its pivot"),
     .flags = NeedsSelection | NeedsCopyable,
     .run = [](MainWindow& window) { window.arrayBar().begin(ArrayBar::Kind::Radial); }},
    {.id = Act::Reverse,
     .menu = MenuId::Object,
     .text = QT_TRANSLATE_NOOP("Actions", "Re&verse Direction"),
     .icon = "reverse",
     .keys = "Shift+R",
     .tip = QT_TRANSLATE_NOOP("Actions", "Make one-way walls solid from the other side"),
     .flags = NeedsSelection | SeparatorBefore | OnToolsBar | NeedsUnlocked | NeedsDirection,
     .run = doing<reverseSelected>},
};

} // namespace

std::span<const ActionRow> objectActions() {
    return objectMenuRows;
}

} // namespace spacetow
