// What the tools that place ship, payload and finish say.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr HintText placeHintTexts[] = {
    {"place-ship.start", QT_TRANSLATE_NOOP("messages", "Ship · click: put it here · drag: turn its nose · Ctrl: snap "
                                                       "off/on · choose the tool again for the payload")},
    {"place-ship.turning", QT_TRANSLATE_NOOP("messages", "Nose at %1° · Shift: 15° · release: done · Escape: cancel")},
    {"place-payload.start", QT_TRANSLATE_NOOP("messages", "Payload · click: put it here · drag: move it into place · "
                                                          "Ctrl: snap off/on · choose the tool again for the finish")},
    {"place-payload.moving",
     QT_TRANSLATE_NOOP("messages", "Payload at %1 m, %2 m · Ctrl: snap off/on · release: done · Escape: cancel")},
    {"place-finish.start",
     QT_TRANSLATE_NOOP("messages", "Finish line · drag it, or click one end and then click or type the other · Ctrl: "
                                   "snap off/on · choose the tool again for the ship")},
    {"place-finish.end", QT_TRANSLATE_NOOP("messages", "Finish line · click or release at the other end · Shift: 15° · "
                                                       "Ctrl: snap off/on · length %1 m, angle %2° · Escape: cancel")},
    {"place-finish.too-short",
     QT_TRANSLATE_NOOP("messages", "The finish needs two ends: move away from the first before you click")},
};

} // namespace

std::span<const HintText> placeHints() {
    return placeHintTexts;
}

} // namespace spacetow
