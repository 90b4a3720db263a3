// What the node tool and the knife say.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr HintText nodesHints[] = {
    {"nodes.none", QT_TRANSLATE_NOOP("messages", "Nodes · click a wall, line, polygon or finish to edit its nodes")},
    {"nodes.without",
     QT_TRANSLATE_NOOP("messages", "What is selected has no nodes · click a wall, line, polygon or finish to edit it")},
    {"nodes.idle",
     QT_TRANSLATE_NOOP("messages",
                       "Nodes · click or rubber band: select nodes · Shift + Alt + drag: lasso · double click "
                       "on a segment: insert a node · Escape: done")},
    {"nodes.object",
     QT_TRANSLATE_NOOP("messages", "Click: edit the nodes of this object · Shift + click: add it to those in edit")},
    {"nodes.selected",
     QT_TRANSLATE_NOOP("messages",
                       "%1 nodes selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · "
                       "Shift+J: join · Shift+R: turn the part between them round as a chain of its own · "
                       "Escape: select none")},
    {"nodes.one-selected",
     QT_TRANSLATE_NOOP("messages",
                       "1 node selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · "
                       "Escape: select none")},
    {"nodes.node",
     QT_TRANSLATE_NOOP("messages",
                       "Node · drag: move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band · "
                       "Alt while dragging: leave other nodes at this place behind")},
    {"nodes.segment",
     QT_TRANSLATE_NOOP("messages", "Segment · drag: move both ends · click: select them · double click or Ctrl + Alt + "
                                   "click: insert a node here")},
    {"nodes.insert", QT_TRANSLATE_NOOP("messages", "Click: insert a node here")},
    {"nodes.moving",
     QT_TRANSLATE_NOOP("messages",
                       "Moving by %1 m, %2 m · Shift: along one axis · Ctrl: snap off/on · Escape: cancel")},
    {"nodes.moving-together",
     QT_TRANSLATE_NOOP("messages", "Moving by %1 m, %2 m together with other nodes at this place · Alt: leave them "
                                   "behind · Shift: along one axis · Ctrl: snap off/on · Escape: cancel")},
    {"nodes.together",
     QT_TRANSLATE_NOOP("messages",
                       "Two neighbouring nodes lie on one point, which leaves a side without length · move on, "
                       "or Escape to cancel")},
    {"nodes.crosses",
     QT_TRANSLATE_NOOP("messages", "The polygon crosses itself like this and cannot be played · move on, or Escape to "
                                   "cancel")},
    {"nodes.scale-handle",
     QT_TRANSLATE_NOOP("messages",
                       "Drag: scale the selected nodes · Shift: about the middle · Ctrl: in proportion · Alt: "
                       "snap off/on · click a selected node: turn them instead")},
    {"nodes.turn-handle", QT_TRANSLATE_NOOP("messages", "Drag: turn the selected nodes · Ctrl: in steps of 15° · click "
                                                        "a selected node: scale them instead")},
    {"nodes.scaling", QT_TRANSLATE_NOOP("messages", "Scaling to %1 m × %2 m · Shift: about the middle · Ctrl: in "
                                                    "proportion · Alt: snap off/on · Escape: cancel")},
    {"nodes.turning", QT_TRANSLATE_NOOP("messages", "Turning by %1° · Ctrl: in steps of 15° · Escape: cancel")},
    {"nodes.band", QT_TRANSLATE_NOOP("messages", "Nodes selected: %1 · release: done · Escape: cancel")},
    {"nodes.lasso",
     QT_TRANSLATE_NOOP("messages", "Nodes selected: %1 · draw around the nodes · release: done · Escape: cancel")},
    {"knife.idle", QT_TRANSLATE_NOOP("messages", "Knife · drag a line across walls, lines and polygons to cut them · "
                                                 "Shift: 15° · Ctrl: snap off/on")},
    {"knife.selected",
     QT_TRANSLATE_NOOP("messages", "Knife · drag a line across to cut what is selected (%1) · Escape: "
                                   "select nothing, so as to cut everything")},
    {"knife.cutting",
     QT_TRANSLATE_NOOP("messages", "Cuts: %1 · release: cut · Shift: 15° · Ctrl: snap off/on · Escape: "
                                   "cancel")},
    {"knife.nothing",
     QT_TRANSLATE_NOOP("messages", "Nothing to cut here yet · chains are cut where the line meets them, "
                                   "polygons where it goes right through")},
};

} // namespace

std::span<const HintText> nodeHints() {
    return nodesHints;
}

} // namespace spacetow
