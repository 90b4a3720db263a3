#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr MessageText hints[] = {
    {"select.idle", QT_TRANSLATE_NOOP("messages", "Click: select · drag: rubber band · Shift or Ctrl + click: add or "
                                                  "remove · Alt + click: next object underneath")},
    {"select.object",
     QT_TRANSLATE_NOOP(
         "messages",
         "Click: select · drag: select and move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band")},
    {"select.selected",
     QT_TRANSLATE_NOOP("messages", "%1 selected · drag: move · Alt + drag: move from anywhere · Shift or Ctrl + click: "
                                   "add or remove · Delete: remove · Escape: select nothing")},
    {"select.moving",
     QT_TRANSLATE_NOOP("messages",
                       "Moving by %1 m, %2 m · Shift: along one axis · Ctrl: snap off/on · Escape: cancel")},
    {"select.band", QT_TRANSLATE_NOOP("messages", "%1 selected · Alt: only what lies wholly inside · Escape: cancel")},
    {"draw-edge.start",
     QT_TRANSLATE_NOOP("messages", "One-way wall · click: first point · drag: first segment · Ctrl: snap off/on · what "
                                   "comes from the left of the drawing direction is stopped")},
    {"draw-edge.next",
     QT_TRANSLATE_NOOP("messages",
                       "%1 points · click: add · click the first point: close · Enter or right click: end · Backspace: "
                       "undo point · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°")},
    {"draw-edge.close",
     QT_TRANSLATE_NOOP("messages",
                       "%1 points · click: close the chain · Enter or right click: end it open · Escape: cancel")},
    {"draw-edge.too-few",
     QT_TRANSLATE_NOOP("messages", "A chain of walls needs two points: click to add another, or Escape to cancel")},
    {"draw-edge.same-point",
     QT_TRANSLATE_NOOP("messages", "This is where the last point is already: move on before you click")},
    {"draw-line.start",
     QT_TRANSLATE_NOOP("messages", "Two-sided wall · click: first point · drag: first segment · Ctrl: snap off/on")},
    {"draw-line.next",
     QT_TRANSLATE_NOOP("messages",
                       "%1 points · click: add · click the first point: close · Enter or right click: end · Backspace: "
                       "undo point · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°")},
    {"draw-line.close",
     QT_TRANSLATE_NOOP("messages",
                       "%1 points · click: close the chain · Enter or right click: end it open · Escape: cancel")},
    {"draw-line.too-few",
     QT_TRANSLATE_NOOP("messages", "A chain of walls needs two points: click to add another, or Escape to cancel")},
    {"draw-line.same-point",
     QT_TRANSLATE_NOOP("messages", "This is where the last point is already: move on before you click")},
    {"draw-polygon.start",
     QT_TRANSLATE_NOOP("messages", "Polygon · click: first corner · drag: first side · Ctrl: snap off/on")},
    {"draw-polygon.next",
     QT_TRANSLATE_NOOP("messages", "%1 corners · click: add · click the first corner, Enter or right click: close · "
                                   "Backspace: undo corner · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°")},
    {"draw-polygon.close", QT_TRANSLATE_NOOP("messages", "%1 corners · click: close the polygon · Escape: cancel")},
    {"draw-polygon.too-few",
     QT_TRANSLATE_NOOP("messages", "A polygon needs three corners: click to add another, or Escape to cancel")},
    {"draw-polygon.same-point",
     QT_TRANSLATE_NOOP("messages", "This is where the last corner is already: move on before you click")},
    {"draw-polygon.crosses",
     QT_TRANSLATE_NOOP("messages",
                       "Closing it here would make the polygon cross itself · Backspace: undo corner · click: go on")},
    {"draw-polygon.flat",
     QT_TRANSLATE_NOOP(
         "messages",
         "All corners lie on one line: a polygon needs an inside · click: add a corner · Backspace: undo corner")},
    {"draw-circle.start",
     QT_TRANSLATE_NOOP("messages", "Circle · drag from the centre, or click the centre · Ctrl: snap off/on")},
    {"draw-circle.radius",
     QT_TRANSLATE_NOOP("messages", "Radius %1 m · click or release: done · Ctrl: snap off/on · Escape: cancel")},
    {"draw-circle.too-small",
     QT_TRANSLATE_NOOP("messages", "A circle needs a radius: move away from the centre before you click")},
    {"place-ship.start", QT_TRANSLATE_NOOP("messages", "Ship · click: put it here · drag: turn its nose · Ctrl: snap "
                                                       "off/on · choose the tool again for the payload")},
    {"place-ship.turning", QT_TRANSLATE_NOOP("messages", "Nose at %1° · Shift: 15° · release: done · Escape: cancel")},
    {"place-payload.start", QT_TRANSLATE_NOOP("messages", "Payload · click: put it here · drag: move it into place · "
                                                          "Ctrl: snap off/on · choose the tool again for the finish")},
    {"place-payload.moving",
     QT_TRANSLATE_NOOP("messages", "Payload at %1 m, %2 m · Ctrl: snap off/on · release: done · Escape: cancel")},
    {"place-finish.start",
     QT_TRANSLATE_NOOP(
         "messages",
         "Finish line · drag it, or click one end · Ctrl: snap off/on · choose the tool again for the ship")},
    {"place-finish.end", QT_TRANSLATE_NOOP("messages", "Finish line · click or release at the other end · Shift: 15° · "
                                                       "Ctrl: snap off/on · length %1 m, angle %2° · Escape: cancel")},
    {"place-finish.too-short",
     QT_TRANSLATE_NOOP("messages", "The finish needs two ends: move away from the first before you click")},
};

constexpr LabelText labels[] = {
    {"draw-edge", QT_TRANSLATE_NOOP("messages", "Draw one-way walls"),
     QT_TRANSLATE_NOOP("messages", "Draw one-way walls")},
    {"draw-line", QT_TRANSLATE_NOOP("messages", "Draw two-sided walls"),
     QT_TRANSLATE_NOOP("messages", "Draw two-sided walls")},
    {"draw-polygon", QT_TRANSLATE_NOOP("messages", "Draw polygon"), QT_TRANSLATE_NOOP("messages", "Draw polygon")},
    {"draw-circle", QT_TRANSLATE_NOOP("messages", "Draw circle"), QT_TRANSLATE_NOOP("messages", "Draw circle")},
    {"place-ship", QT_TRANSLATE_NOOP("messages", "Place ship"), QT_TRANSLATE_NOOP("messages", "Place ship")},
    {"place-payload", QT_TRANSLATE_NOOP("messages", "Place payload"), QT_TRANSLATE_NOOP("messages", "Place payload")},
    {"place-finish", QT_TRANSLATE_NOOP("messages", "Place finish"), QT_TRANSLATE_NOOP("messages", "Place finish")},
    {"move", QT_TRANSLATE_NOOP("messages", "Move object"), QT_TRANSLATE_N_NOOP("messages", "Move %n objects")},
    {"rotate", QT_TRANSLATE_NOOP("messages", "Rotate object"), QT_TRANSLATE_N_NOOP("messages", "Rotate %n objects")},
    {"reverse", QT_TRANSLATE_NOOP("messages", "Reverse object"), QT_TRANSLATE_N_NOOP("messages", "Reverse %n objects")},
    {"delete", QT_TRANSLATE_NOOP("messages", "Delete object"), QT_TRANSLATE_N_NOOP("messages", "Delete %n objects")},
    {"duplicate", QT_TRANSLATE_NOOP("messages", "Duplicate object"),
     QT_TRANSLATE_N_NOOP("messages", "Duplicate %n objects")},
    {"cut", QT_TRANSLATE_NOOP("messages", "Cut object"), QT_TRANSLATE_N_NOOP("messages", "Cut %n objects")},
    {"change", QT_TRANSLATE_NOOP("messages", "Change object"), QT_TRANSLATE_N_NOOP("messages", "Change %n objects")},
    {"change-level", QT_TRANSLATE_NOOP("messages", "Change level"), QT_TRANSLATE_NOOP("messages", "Change level")},
    {"change-tag", QT_TRANSLATE_NOOP("messages", "Change tag"), QT_TRANSLATE_NOOP("messages", "Change tag")},
    {"change", QT_TRANSLATE_NOOP("messages", "Change object"), QT_TRANSLATE_N_NOOP("messages", "Change %n objects")},
    {"change-level", QT_TRANSLATE_NOOP("messages", "Change level"), QT_TRANSLATE_NOOP("messages", "Change level")},
    {"change-tag", QT_TRANSLATE_NOOP("messages", "Change tag"), QT_TRANSLATE_NOOP("messages", "Change tag")},
    {"paste", QT_TRANSLATE_NOOP("messages", "Paste object"), QT_TRANSLATE_N_NOOP("messages", "Paste %n objects")},
};

} // namespace

std::span<const MessageText> hintTexts() {
    return hints;
}

std::span<const LabelText> labelTexts() {
    return labels;
}

} // namespace spacetow
