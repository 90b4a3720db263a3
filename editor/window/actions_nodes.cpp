// What is done to the nodes of selected objects.
#include "core/level/node_edits.h"
#include "editor/editing/node_tool.h"
#include "editor/editing/node_verbs.h"
#include "editor/window/verb_action.h"

namespace spacetow {

namespace {

bool hasNodesSelected(const MainWindow& window) {
    return !window.document().selection().nodes().empty();
}

bool hasSegmentSelected(const MainWindow& window) {
    return window.document().selection().nodes().size() >= 2;
}

template <JoinWay way>
bool isJoinable(const MainWindow& window) {
    return canJoin(window.document().level(), window.document().selection().nodes(), way);
}

template <int direction>
void selectNext(MainWindow& window) {
    window.document().select(nextNode(window.document().shown(), direction));
}

bool editsNodes(const MainWindow& window) {
    return window.toolbox().current() == ToolId::Nodes && !window.document().selection().empty();
}

/// What happens to it next is done with the node tool.
void insertNodeHere(MainWindow& window) {
    const Pointer pointer{.world = window.canvas().pointerPosition(), .pixel = window.canvas().view().pixel()};
    const std::optional<FinishedEdit> edit = insertNode(window.toolbox().context(), pointer);
    if (!edit) {
        window.statusLine().showMessage(MainWindow::tr("Nothing that is selected has an edge at the pointer."), 8000);
        return;
    }
    window.takeTool(ToolId::Nodes);
    window.toolbox().finish(edit);
}

constexpr ActionRow nodesRows[] = {
    {.id = Act::InsertNode,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "Insert Node &Here"),
     .icon = "node-insert",
     .keys = "Shift+Ins",
     .tip = QT_TRANSLATE_NOOP("Actions", "Insert a node where the pointer is at an edge of the selection"),
     .flags = NeedsSelection | NeedsOutline,
     .run = insertNodeHere,
     .isPossible = [](const MainWindow& window) { return !window.isPlaying(); },
     .why = QT_TRANSLATE_NOOP("Actions", "Not while the level runs.")},
    {.id = Act::InsertMidpoints,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "Insert &Midpoints"),
     .icon = "node-midpoints",
     .keys = "Ins",
     .tip = QT_TRANSLATE_NOOP("Actions", "Insert a node in the middle of each selected segment, or of all"),
     .flags = NeedsSelection | NeedsOutline,
     .run = doing<insertMidpoints>},
    {.id = Act::DeleteSegments,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "D&elete Segments"),
     .icon = "node-delete",
     .keys = "Ctrl+Del",
     .tip = QT_TRANSLATE_NOOP("Actions", "Remove the segments between selected nodes and leave the chain open there"),
     .run = doing<removeSegments>,
     .isPossible = hasSegmentSelected,
     .why = QT_TRANSLATE_NOOP("Actions", "Select two nodes next to each other first, with the node tool.")},
    {.id = Act::JoinNodes,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "&Join Nodes"),
     .icon = "node-join",
     .keys = "Shift+J",
     .tip = QT_TRANSLATE_NOOP("Actions", "Weld two end nodes, or two neighbours, into one in the middle"),
     .flags = SeparatorBefore,
     .run = doing<joinNodes>,
     .isPossible = isJoinable<JoinWay::Weld>,
     .why = QT_TRANSLATE_NOOP("Actions", "Select two ends of walls or lines first, with the node tool.")},
    {.id = Act::JoinBySegment,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "Join by a &Segment"),
     .keys = "Ctrl+Shift+J",
     .tip = QT_TRANSLATE_NOOP("Actions", "Join two end nodes by a new segment"),
     .run = doing<joinBySegment>,
     .isPossible = isJoinable<JoinWay::Segment>,
     .why = QT_TRANSLATE_NOOP("Actions", "Select two ends of walls or lines first, with the node tool.")},
    {.id = Act::BreakNodes,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "&Break at Nodes"),
     .icon = "node-break",
     .keys = "Shift+B",
     .tip = QT_TRANSLATE_NOOP("Actions", "Split chains at the selected nodes, open closed ones"),
     .run = doing<breakNodes>,
     .isPossible = hasNodesSelected,
     .why = QT_TRANSLATE_NOOP("Actions", "Select nodes first, with the node tool.")},
    {.id = Act::StraightenNodes,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "Make S&traight in 15° Steps"),
     .keys = "Shift+L",
     .tip = QT_TRANSLATE_NOOP("Actions", "Turn the selected segments to the nearest multiple of 15°"),
     .flags = SeparatorBefore,
     .run = doing<straightenNodes>,
     .isPossible = hasSegmentSelected,
     .why = QT_TRANSLATE_NOOP("Actions", "Select two nodes next to each other first, with the node tool.")},
    {.id = Act::NextNode,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "&Next Node"),
     .keys = ".",
     .tip = QT_TRANSLATE_NOOP("Actions", "Select the next node"),
     .flags = SeparatorBefore,
     .run = selectNext<1>,
     .isPossible = editsNodes,
     .why = QT_TRANSLATE_NOOP("Actions", "Take the node tool and select an object first.")},
    {.id = Act::PreviousNode,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "&Previous Node"),
     .keys = ",",
     .tip = QT_TRANSLATE_NOOP("Actions", "Select the previous node"),
     .run = selectNext<-1>,
     .isPossible = editsNodes,
     .why = QT_TRANSLATE_NOOP("Actions", "Take the node tool and select an object first.")},
};

} // namespace

std::span<const ActionRow> nodeActions() {
    return nodesRows;
}

} // namespace spacetow
