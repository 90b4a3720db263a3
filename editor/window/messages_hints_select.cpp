// What the select tool says.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr HintText selectHintTexts[] = {
    {"select.idle",
     QT_TRANSLATE_NOOP("messages", "Click: select · drag: rubber band · Shift + Alt (or B) + drag: lasso · Shift or "
                                   "Ctrl + click: add or remove · Alt or B + click: next object underneath")},
    {"select.object",
     QT_TRANSLATE_NOOP(
         "messages",
         "Click: select · drag: select and move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band")},
    {"select.selected",
     QT_TRANSLATE_NOOP("messages",
                       "%1 selected · drag: move · click again: turn or scale · Alt or B + drag: move from anywhere "
                       "· Shift or Ctrl + click: add or remove · Delete: remove · Escape: select nothing")},
    {"select.group",
     QT_TRANSLATE_NOOP("messages",
                       "Click: select the group · double click: enter it · Ctrl + click: select by itself · "
                       "drag: select and move · Shift + click: add or remove")},
    {"select.selected-group",
     QT_TRANSLATE_NOOP("messages", "%1 selected · double click: enter the group · drag: move · click again: turn or "
                                   "scale · Ctrl + click: select by itself · Delete: remove")},
    {"select.in-group",
     QT_TRANSLATE_NOOP("messages", "Inside a group, %1 selected · clicks select its members · Escape, or double click "
                                   "on empty ground: leave it")},
    {"select.in-named-group",
     QT_TRANSLATE_NOOP("messages", "Inside “%2”, %1 selected · clicks select its members · Escape, or double click on "
                                   "empty ground: leave it")},
    {"select.lasso",
     QT_TRANSLATE_NOOP("messages", "%1 selected · Ctrl: only what lies wholly inside · Escape: cancel")},
    {"select.node",
     QT_TRANSLATE_NOOP("messages", "Node · drag: move it alone · Alt or B + drag: move the whole object · double "
                                   "click: edit all nodes")},
    {"select.moving",
     QT_TRANSLATE_NOOP("messages",
                       "Moving by %1 m, %2 m · Shift: along one axis · Ctrl: snap off/on · Escape: cancel")},
    {"select.scale-handle", QT_TRANSLATE_NOOP("messages", "Drag: scale · Shift: about the middle · Ctrl: keep the "
                                                          "proportions · Alt or B: snap off/on")},
    {"select.scaling", QT_TRANSLATE_NOOP("messages", "%1 × %2 m (%3 %, %4 %) · Shift: about the middle · Ctrl: keep "
                                                     "the proportions · Alt or B: snap off/on · Escape: cancel")},
    {"select.turn-handle",
     QT_TRANSLATE_NOOP("messages", "Drag: turn about the pivot · Shift: about the opposite corner · Ctrl: in steps of "
                                   "15° · click the object: scale")},
    {"select.turning", QT_TRANSLATE_NOOP("messages", "Turning by %1° · Shift: about the opposite corner · Ctrl: in "
                                                     "steps of 15° · Escape: cancel")},
    {"select.pivot-handle",
     QT_TRANSLATE_NOOP("messages", "Drag: move the pivot, about which the selection turns · Ctrl: snap off/on")},
    {"select.small-pivot",
     QT_TRANSLATE_NOOP("messages", "Drag: move · Shift + drag: move the pivot, about which it turns")},
    {"select.pivot", QT_TRANSLATE_NOOP("messages", "Pivot at %1; %2 m · Ctrl: snap off/on · Escape: cancel")},
    {"select.locked", QT_TRANSLATE_NOOP("messages", "Locked: clicks and drags go past it")},
    {"select.all-locked",
     QT_TRANSLATE_NOOP("messages", "%1 selected · locked, so nothing changes it · Escape: select nothing")},
    {"select.band",
     QT_TRANSLATE_NOOP("messages", "%1 selected · Alt or B: only what lies wholly inside · Escape: cancel")},
};

} // namespace

std::span<const HintText> selectHints() {
    return selectHintTexts;
}

} // namespace spacetow
