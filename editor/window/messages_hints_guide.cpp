// What is said about guides.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr HintText guideTexts[] = {
    {"guide.hover",
     QT_TRANSLATE_NOOP("messages", "Guide · drag: move it · drag onto a ruler: delete it · double click: "
                                   "type place, angle and name")},
    {"guide.new",
     QT_TRANSLATE_NOOP("messages", "New guide at %1 m, %2 m · release: done · Ctrl: snap off/on · back onto "
                                   "the ruler or Escape: none")},
    {"guide.outside", QT_TRANSLATE_NOOP("messages", "New guide · drag it into the drawing board · Escape: none")},
    {"guide.moving",
     QT_TRANSLATE_NOOP("messages", "Guide at %1 m, %2 m, %3° · release: done · Shift: turn · Ctrl: snap "
                                   "off/on · onto a ruler: delete · Escape: cancel")},
    {"guide.delete", QT_TRANSLATE_NOOP("messages", "Guide on the ruler · release: delete it · Escape: cancel")},
};

} // namespace

std::span<const HintText> guideHints() {
    return guideTexts;
}

} // namespace spacetow
