// What the tools that draw walls, polygons and circles say.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr HintText drawHintTexts[] = {
    {"draw-edge.start",
     QT_TRANSLATE_NOOP("messages", "One-way wall · click: first point · drag: first segment · Ctrl: snap off/on · what "
                                   "comes from the left of the drawing direction is stopped")},
    {"draw-edge.next",
     QT_TRANSLATE_NOOP(
         "messages",
         "Points: %1 · click: add · click the first point: close · Enter or right click: end · Backspace: "
         "undo point · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°")},
    {"draw-edge.close",
     QT_TRANSLATE_NOOP("messages",
                       "Points: %1 · click: close the chain · Enter or right click: end it open · Escape: cancel")},
    {"draw-edge.too-few",
     QT_TRANSLATE_NOOP("messages", "A chain of walls needs two points: click to add another, or Escape to cancel")},
    {"draw-edge.same-point",
     QT_TRANSLATE_NOOP("messages", "This is where the last point is already: move on before you click")},
    {"draw-edge.extend",
     QT_TRANSLATE_NOOP("messages",
                       "Click or drag: go on with this chain, which keeps its direction · Alt or B + click: "
                       "begin a chain of its own here")},
    {"draw-edge.close-chain",
     QT_TRANSLATE_NOOP("messages", "Click: close the chain at its other end · Enter or right click: end it open · "
                                   "Escape: leave it as it was")},
    {"draw-line.start",
     QT_TRANSLATE_NOOP("messages", "Two-sided wall · click: first point · drag: first segment · Ctrl: snap off/on")},
    {"draw-line.next",
     QT_TRANSLATE_NOOP(
         "messages",
         "Points: %1 · click: add · click the first point: close · Enter or right click: end · Backspace: "
         "undo point · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°")},
    {"draw-line.close",
     QT_TRANSLATE_NOOP("messages",
                       "Points: %1 · click: close the chain · Enter or right click: end it open · Escape: cancel")},
    {"draw-line.too-few",
     QT_TRANSLATE_NOOP("messages", "A chain of walls needs two points: click to add another, or Escape to cancel")},
    {"draw-line.same-point",
     QT_TRANSLATE_NOOP("messages", "This is where the last point is already: move on before you click")},
    {"draw-line.extend",
     QT_TRANSLATE_NOOP("messages",
                       "Click or drag: go on with this line · Alt or B + click: begin a line of its own here")},
    {"draw-line.close-chain",
     QT_TRANSLATE_NOOP("messages", "Click: close the line at its other end · Enter or right click: end it open · "
                                   "Escape: leave it as it was")},
    {"draw-polygon.start",
     QT_TRANSLATE_NOOP("messages", "Polygon · click: first corner · drag: first side · Ctrl: snap off/on")},
    {"draw-polygon.next",
     QT_TRANSLATE_NOOP(
         "messages", "Corners: %1 · click: add · click the first corner, Enter or right click: close · "
                     "Backspace: undo corner · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length "
                     "%2 m, angle %3°")},
    {"draw-polygon.close", QT_TRANSLATE_NOOP("messages", "Corners: %1 · click: close the polygon · Escape: cancel")},
    {"draw-polygon.too-few",
     QT_TRANSLATE_NOOP("messages", "A polygon needs three corners: click to add another, or Escape to cancel")},
    {"draw-polygon.same-point",
     QT_TRANSLATE_NOOP("messages", "This is where the last corner is already: move on before you click")},
    {"draw-polygon.crossing",
     QT_TRANSLATE_NOOP("messages",
                       "This side would run through another one, and a polygon must not cross itself · move on before "
                       "you click")},
    {"draw-polygon.crossed",
     QT_TRANSLATE_NOOP("messages", "The polygon crosses itself where it is marked and cannot be finished like this · "
                                   "Backspace: undo corner")},
    {"draw-polygon.crosses",
     QT_TRANSLATE_NOOP("messages",
                       "Closing it here would make the polygon cross itself · Backspace: undo corner · click: go on")},
    {"draw-polygon.flat",
     QT_TRANSLATE_NOOP(
         "messages",
         "All corners lie on one line: a polygon needs an inside · click: add a corner · Backspace: undo corner")},
    {"draw-rectangle.start", QT_TRANSLATE_NOOP("messages", "Rectangle · drag from corner to corner, or click both, or "
                                                           "click one and type the size · Shift: from the middle · "
                                                           "Ctrl: square")},
    {"draw-rectangle.size",
     QT_TRANSLATE_NOOP("messages", "Width %1 m, height %2 m · click or release: done · Shift: from the middle · Ctrl: "
                                   "square · Alt or B: snap off/on · Escape: cancel")},
    {"draw-rectangle.too-small",
     QT_TRANSLATE_NOOP("messages", "A rectangle needs width and height: move on before you click or release")},
    {"draw-kinematic.start",
     QT_TRANSLATE_NOOP("messages", "Moving body · drag: rectangle · click: first corner of a polygon · then its "
                                   "velocity · Shift: from the middle · Ctrl: square")},
    {"velocity.drawing",
     QT_TRANSLATE_NOOP(
         "messages",
         "Velocity %1 m/s, %2° · click or drag: set it · digits: type it · Shift: 15° · Ctrl: snap off/on · "
         "Enter, right click or Escape: leave the body at rest")},
    {"velocity.dragging",
     QT_TRANSLATE_NOOP("messages",
                       "Velocity %1 m/s, %2° · Shift: 15° · Ctrl: snap off/on · release: done · Escape: cancel")},
    {"velocity.handle", QT_TRANSLATE_NOOP("messages", "Drag: change the velocity of this body, a metre for each m/s")},
    {"connector.start",
     QT_TRANSLATE_NOOP("messages", "Connector · drag from one body to another, or click both · anchors snap to nodes, "
                                   "middles and the grid")},
    {"connector.from-named", QT_TRANSLATE_NOOP("messages", "Drag or click: connect “%1” with another body")},
    {"connector.from-static", QT_TRANSLATE_NOOP("messages", "Drag or click: connect this fixed body with another one")},
    {"connector.from-kinematic",
     QT_TRANSLATE_NOOP("messages", "Drag or click: connect this moving body with another one")},
    {"connector.from-dynamic",
     QT_TRANSLATE_NOOP("messages", "Drag or click: connect this loose body with another one")},
    {"connector.to-named",
     QT_TRANSLATE_NOOP("messages", "Length %1 m · release or click: connect with “%2” · Escape: cancel")},
    {"connector.to-static",
     QT_TRANSLATE_NOOP("messages", "Length %1 m · release or click: connect with this fixed body · Escape: cancel")},
    {"connector.to-kinematic",
     QT_TRANSLATE_NOOP("messages", "Length %1 m · release or click: connect with this moving body · Escape: cancel")},
    {"connector.to-dynamic",
     QT_TRANSLATE_NOOP("messages", "Length %1 m · release or click: connect with this loose body · Escape: cancel")},
    {"connector.nothing-moves",
     QT_TRANSLATE_NOOP("messages", "Neither of these two bodies can be moved by a connector, one should be dynamic · "
                                   "release or click: connect them all the same · length %1 m")},
    {"connector.same-body",
     QT_TRANSLATE_NOOP("messages", "This is the body where the connector begins: it needs another one")},
    {"connector.no-body", QT_TRANSLATE_NOOP("messages", "Connectors join bodies; ship, payload and finish are none")},
    {"connector.nothing-here",
     QT_TRANSLATE_NOOP("messages", "There is no body here: a connector leads from one body to another")},
    {"connector.began-nowhere",
     QT_TRANSLATE_NOOP("messages", "There was no body where the drag began: press on one, then drag to another")},
    {"connector.ended-nowhere",
     QT_TRANSLATE_NOOP("messages", "Nothing was connected: release the button over another body")},
    {"typing.length-angle",
     QT_TRANSLATE_NOOP("messages",
                       "Length and angle · Tab: the other one · an empty one is left to the pointer · Enter "
                       "or click: place the point · Escape: back to the pointer")},
    {"typing.speed-angle",
     QT_TRANSLATE_NOOP("messages", "Speed and direction · Tab: the other one · an empty one is left to the pointer · "
                                   "Enter or click: set the velocity · Escape: back to the pointer")},
    {"typing.width-height",
     QT_TRANSLATE_NOOP("messages",
                       "Width and height · Tab: the other one · an empty one is left to the pointer · Enter "
                       "or click: draw the rectangle · Escape: back to the pointer")},
    {"typing.radius",
     QT_TRANSLATE_NOOP("messages", "Radius · Enter or click: draw the circle · Escape: back to the pointer")},
    {"typing.no-number",
     QT_TRANSLATE_NOOP("messages", "“%1” is no number in metres: type one such as 2.5, 80 cm or 3/4")},
    {"typing.no-angle",
     QT_TRANSLATE_NOOP("messages", "“%1” is no angle: type degrees such as 45, −22.5 or 180/7, anticlockwise from the "
                                   "right")},
    {"typing.too-small", QT_TRANSLATE_NOOP("messages", "“%1” is too small: a size must be more than nothing")},
    {"draw-circle.start",
     QT_TRANSLATE_NOOP(
         "messages",
         "Circle · drag from the center, or click it and then click or type the radius · Ctrl: snap off/on")},
    {"draw-circle.radius",
     QT_TRANSLATE_NOOP("messages", "Radius %1 m · click or release: done · Ctrl: snap off/on · Escape: cancel")},
    {"draw-circle.too-small",
     QT_TRANSLATE_NOOP("messages", "A circle needs a radius: move away from the center before you click")},
};

} // namespace

std::span<const HintText> drawHints() {
    return drawHintTexts;
}

} // namespace spacetow
