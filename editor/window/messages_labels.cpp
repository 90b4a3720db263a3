// What edits are called in menus and in the history.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

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
    {"move-nodes", QT_TRANSLATE_NOOP("messages", "Move node"), QT_TRANSLATE_N_NOOP("messages", "Move %n nodes")},
    {"rotate-nodes", QT_TRANSLATE_NOOP("messages", "Rotate nodes"), QT_TRANSLATE_N_NOOP("messages", "Rotate %n nodes")},
    {"scale-nodes", QT_TRANSLATE_NOOP("messages", "Scale nodes"), QT_TRANSLATE_N_NOOP("messages", "Scale %n nodes")},
    {"insert-nodes", QT_TRANSLATE_NOOP("messages", "Insert nodes"), QT_TRANSLATE_NOOP("messages", "Insert nodes")},
    {"delete-nodes", QT_TRANSLATE_NOOP("messages", "Delete node"), QT_TRANSLATE_N_NOOP("messages", "Delete %n nodes")},
    {"delete-segments", QT_TRANSLATE_NOOP("messages", "Delete segments"),
     QT_TRANSLATE_NOOP("messages", "Delete segments")},
    {"join-nodes", QT_TRANSLATE_NOOP("messages", "Join nodes"), QT_TRANSLATE_NOOP("messages", "Join nodes")},
    {"break-nodes", QT_TRANSLATE_NOOP("messages", "Break at node"),
     QT_TRANSLATE_N_NOOP("messages", "Break at %n nodes")},
    {"reverse-part", QT_TRANSLATE_NOOP("messages", "Reverse part"), QT_TRANSLATE_NOOP("messages", "Reverse part")},
    {"straighten-nodes", QT_TRANSLATE_NOOP("messages", "Straighten segments"),
     QT_TRANSLATE_NOOP("messages", "Straighten segments")},
    {"knife", QT_TRANSLATE_NOOP("messages", "Cut with the knife"), QT_TRANSLATE_NOOP("messages", "Cut with the knife")},
    {"duplicate", QT_TRANSLATE_NOOP("messages", "Duplicate object"),
     QT_TRANSLATE_N_NOOP("messages", "Duplicate %n objects")},
    {"cut", QT_TRANSLATE_NOOP("messages", "Cut object"), QT_TRANSLATE_N_NOOP("messages", "Cut %n objects")},
    {"change", QT_TRANSLATE_NOOP("messages", "Change object"), QT_TRANSLATE_N_NOOP("messages", "Change %n objects")},
    {"change-level", QT_TRANSLATE_NOOP("messages", "Change level"), QT_TRANSLATE_NOOP("messages", "Change level")},
    {"change-tag", QT_TRANSLATE_NOOP("messages", "Change tag"), QT_TRANSLATE_NOOP("messages", "Change tag")},
    {"paste", QT_TRANSLATE_NOOP("messages", "Paste object"), QT_TRANSLATE_N_NOOP("messages", "Paste %n objects")},
};

} // namespace

std::span<const LabelText> labelTexts() {
    return labels;
}

} // namespace spacetow
