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
    {"draw-rectangle", QT_TRANSLATE_NOOP("messages", "Draw rectangle"),
     QT_TRANSLATE_NOOP("messages", "Draw rectangle")},
    {"draw-kinematic", QT_TRANSLATE_NOOP("messages", "Draw moving body"),
     QT_TRANSLATE_NOOP("messages", "Draw moving body")},
    {"draw-connector", QT_TRANSLATE_NOOP("messages", "Draw connector"),
     QT_TRANSLATE_NOOP("messages", "Draw connector")},
    {"set-velocity", QT_TRANSLATE_NOOP("messages", "Set velocity"), QT_TRANSLATE_NOOP("messages", "Set velocity")},
    {"extend-chain", QT_TRANSLATE_NOOP("messages", "Extend chain"), QT_TRANSLATE_NOOP("messages", "Extend chain")},
    {"place-ship", QT_TRANSLATE_NOOP("messages", "Place ship"), QT_TRANSLATE_NOOP("messages", "Place ship")},
    {"place-payload", QT_TRANSLATE_NOOP("messages", "Place payload"), QT_TRANSLATE_NOOP("messages", "Place payload")},
    {"place-finish", QT_TRANSLATE_NOOP("messages", "Place finish"), QT_TRANSLATE_NOOP("messages", "Place finish")},
    {"move", QT_TRANSLATE_NOOP("messages", "Move object"), QT_TRANSLATE_N_NOOP("messages", "Move %n objects")},
    {"rotate", QT_TRANSLATE_NOOP("messages", "Rotate object"), QT_TRANSLATE_N_NOOP("messages", "Rotate %n objects")},
    {"scale", QT_TRANSLATE_NOOP("messages", "Scale object"), QT_TRANSLATE_N_NOOP("messages", "Scale %n objects")},
    {"flip", QT_TRANSLATE_NOOP("messages", "Flip object"), QT_TRANSLATE_N_NOOP("messages", "Flip %n objects")},
    {"align", QT_TRANSLATE_NOOP("messages", "Align object"), QT_TRANSLATE_N_NOOP("messages", "Align %n objects")},
    {"distribute", QT_TRANSLATE_NOOP("messages", "Distribute object"),
     QT_TRANSLATE_N_NOOP("messages", "Distribute %n objects")},
    {"order", QT_TRANSLATE_NOOP("messages", "Reorder object"), QT_TRANSLATE_N_NOOP("messages", "Reorder %n objects")},
    {"group", QT_TRANSLATE_NOOP("messages", "Group object"), QT_TRANSLATE_N_NOOP("messages", "Group %n objects")},
    {"ungroup", QT_TRANSLATE_NOOP("messages", "Ungroup"), QT_TRANSLATE_N_NOOP("messages", "Ungroup %n groups")},
    {"to-layer", QT_TRANSLATE_NOOP("messages", "Move object to another layer"),
     QT_TRANSLATE_N_NOOP("messages", "Move %n objects to another layer")},
    {"regroup", QT_TRANSLATE_NOOP("messages", "Move object to another group"),
     QT_TRANSLATE_N_NOOP("messages", "Move %n objects to another group")},
    {"rename", QT_TRANSLATE_NOOP("messages", "Rename object"), QT_TRANSLATE_NOOP("messages", "Rename object")},
    {"show", QT_TRANSLATE_NOOP("messages", "Show object"), QT_TRANSLATE_N_NOOP("messages", "Show %n objects")},
    {"unlock", QT_TRANSLATE_NOOP("messages", "Unlock object"), QT_TRANSLATE_N_NOOP("messages", "Unlock %n objects")},
    {"hide", QT_TRANSLATE_NOOP("messages", "Hide object"), QT_TRANSLATE_N_NOOP("messages", "Hide %n objects")},
    {"isolate", QT_TRANSLATE_NOOP("messages", "Isolate object"), QT_TRANSLATE_N_NOOP("messages", "Isolate %n objects")},
    {"lock", QT_TRANSLATE_NOOP("messages", "Lock object"), QT_TRANSLATE_N_NOOP("messages", "Lock %n objects")},
    {"repeat", QT_TRANSLATE_NOOP("messages", "Repeat transform"),
     QT_TRANSLATE_N_NOOP("messages", "Repeat transform of %n objects")},
    {"new-layer", QT_TRANSLATE_NOOP("messages", "New layer"), QT_TRANSLATE_NOOP("messages", "New layer")},
    {"show-all", QT_TRANSLATE_NOOP("messages", "Show all"), QT_TRANSLATE_NOOP("messages", "Show all")},
    {"unlock-all", QT_TRANSLATE_NOOP("messages", "Unlock all"), QT_TRANSLATE_NOOP("messages", "Unlock all")},
    {"array", QT_TRANSLATE_NOOP("messages", "Array of one copy"),
     QT_TRANSLATE_N_NOOP("messages", "Array of %n copies")},
    {"union", QT_TRANSLATE_NOOP("messages", "Unite bodies"), QT_TRANSLATE_N_NOOP("messages", "Unite %n objects")},
    {"difference", QT_TRANSLATE_NOOP("messages", "Subtract bodies"),
     QT_TRANSLATE_N_NOOP("messages", "Subtract %n objects")},
    {"intersection", QT_TRANSLATE_NOOP("messages", "Intersect bodies"),
     QT_TRANSLATE_N_NOOP("messages", "Intersect %n objects")},
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
    {"change-tags", QT_TRANSLATE_NOOP("messages", "Change who touches whom"),
     QT_TRANSLATE_NOOP("messages", "Change who touches whom")},
    {"change-tag", QT_TRANSLATE_NOOP("messages", "Change tag"), QT_TRANSLATE_NOOP("messages", "Change tag")},
    {"paste", QT_TRANSLATE_NOOP("messages", "Paste object"), QT_TRANSLATE_N_NOOP("messages", "Paste %n objects")},
    {"add-guide", QT_TRANSLATE_NOOP("messages", "Add guide"), QT_TRANSLATE_NOOP("messages", "Add guide")},
    {"change-guide", QT_TRANSLATE_NOOP("messages", "Change guide"), QT_TRANSLATE_NOOP("messages", "Change guide")},
    {"delete-guide", QT_TRANSLATE_NOOP("messages", "Delete guide"), QT_TRANSLATE_NOOP("messages", "Delete guide")},
    {"clear-guides", QT_TRANSLATE_NOOP("messages", "Delete all guides"),
     QT_TRANSLATE_NOOP("messages", "Delete all guides")},
};

} // namespace

std::span<const LabelText> labelTexts() {
    return labels;
}

} // namespace spacetow
