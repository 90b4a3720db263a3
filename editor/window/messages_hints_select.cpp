// What the select tool says.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr MessageText selectHintTexts[] = {
    {"select.idle", QT_TRANSLATE_NOOP("messages", "Click: select · drag: rubber band · Shift or Ctrl + click: add or "
                                                  "remove · Alt + click: next object underneath")},
    {"select.object",
     QT_TRANSLATE_NOOP(
         "messages",
         "Click: select · drag: select and move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band")},
    {"select.selected",
     QT_TRANSLATE_NOOP("messages", "%1 selected · drag: move · Alt + drag: move from anywhere · Shift or Ctrl + click: "
                                   "add or remove · Delete: remove · Escape: select nothing")},
    {"select.node",
     QT_TRANSLATE_NOOP("messages", "Node · drag: move it alone · Alt + drag: move the whole object · double "
                                   "click: edit all nodes")},
    {"select.moving",
     QT_TRANSLATE_NOOP("messages",
                       "Moving by %1 m, %2 m · Shift: along one axis · Ctrl: snap off/on · Escape: cancel")},
    {"select.band", QT_TRANSLATE_NOOP("messages", "%1 selected · Alt: only what lies wholly inside · Escape: cancel")},
};

} // namespace

std::span<const MessageText> selectHints() {
    return selectHintTexts;
}

} // namespace spacetow
