// What the tools that draw walls, polygons and circles say.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr MessageText drawHintTexts[] = {
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
};

} // namespace

std::span<const MessageText> drawHints() {
    return drawHintTexts;
}

} // namespace spacetow
