#include "editor/editing/node_verbs.h"

#include "core/level/node_edits.h"
#include "editor/editing/node_pick.h"

#include <algorithm>

namespace spacetow {

namespace {

std::optional<FinishedEdit> finishing(const ToolContext& context, LabelCode code, NodeEdit edit) {
    const Edit& before = context.edit;
    if (edit.level == *before.level) {
        return {};
    }
    Selection selection =
        Selection(before.selection.keys(), std::move(edit.nodes)).entering(before.selection.entered());
    selection = selection.within(edit.level);
    return FinishedEdit{{code, static_cast<int>(before.selection.nodes().size())},
                        {std::make_shared<const Level>(std::move(edit.level)), std::move(selection)}};
}

std::optional<FinishedEdit> joining(const ToolContext& context, JoinWay way) {
    return finishing(context, "join-nodes", joined(*context.edit.level, context.edit.selection.nodes(), way));
}

} // namespace

std::optional<FinishedEdit> removeNodes(const ToolContext& context) {
    return finishing(context, "delete-nodes", {withoutNodes(*context.edit.level, context.edit.selection.nodes()), {}});
}

std::optional<FinishedEdit> insertMidpoints(const ToolContext& context) {
    const Level& level = *context.edit.level;
    const std::vector<NodeRef>& nodes = context.edit.selection.nodes();
    return finishing(context, "insert-nodes",
                     nodes.size() < 2 ? withMidpoints(level, allNodes(level, keysInEdit(context.edit)))
                                      : withMidpoints(level, nodes));
}

std::optional<FinishedEdit> removeSegments(const ToolContext& context) {
    return finishing(context, "delete-segments", withoutSegments(*context.edit.level, context.edit.selection.nodes()));
}

std::optional<FinishedEdit> joinNodes(const ToolContext& context) {
    return joining(context, JoinWay::Weld);
}

std::optional<FinishedEdit> joinBySegment(const ToolContext& context) {
    return joining(context, JoinWay::Segment);
}

std::optional<FinishedEdit> breakNodes(const ToolContext& context) {
    return finishing(context, "break-nodes", brokenAt(*context.edit.level, context.edit.selection.nodes()));
}

std::optional<FinishedEdit> reverseNodes(const ToolContext& context) {
    const Level& level = *context.edit.level;
    const std::vector<NodeRef>& nodes = context.edit.selection.nodes();
    if (auto part = finishing(context, "reverse-part", reversedPart(level, nodes))) {
        return part;
    }
    // Single nodes stand for their chains.
    std::vector<NodeRef> whole = allNodes(level, context.edit.selection.keys());
    std::erase_if(whole, [&nodes](const NodeRef& node) {
        return std::ranges::none_of(
            nodes, [&node](const NodeRef& of) { return of.key == node.key && of.shape == node.shape; });
    });
    return finishing(context, "reverse-part", reversedPart(level, whole));
}

std::optional<FinishedEdit> straightenNodes(const ToolContext& context) {
    return finishing(context, "straighten-nodes", straightened(*context.edit.level, context.edit.selection.nodes()));
}

std::optional<FinishedEdit> nudgeNodes(const ToolContext& context, const Vec2& delta) {
    const Level& level = *context.edit.level;
    const std::vector<NodeRef>& nodes = context.edit.selection.nodes();
    auto moved = finishing(context, "move-nodes",
                           {withMappedNodes(level, withCompany(level, nodes), Affine::translation(delta)), nodes});
    if (moved) {
        moved->mergeKey = "nudge-nodes";
    }
    return moved;
}

std::optional<FinishedEdit> rotateNodes(const ToolContext& context, double radians) {
    const Selection& selection = context.edit.selection;
    const Level& level = *context.edit.level;
    const std::vector<NodeRef>& nodes = selection.nodes();
    const Vec2 pivot = selection.pivot().value_or(boundsOfNodes(level, nodes).center());
    auto turned =
        finishing(context, "rotate-nodes",
                  {withMappedNodes(level, withCompany(level, nodes), Affine::rotation(pivot, radians)), nodes});
    if (turned) {
        turned->mergeKey = "rotate-nodes";
        // Another pivot after each turn, and four quarters would not bring them back.
        turned->edit.selection = turned->edit.selection.withPivot(pivot);
    }
    return turned;
}

Selection selectAllNodes(const Edit& edit) {
    const std::vector<Key> keys = keysInEdit(edit);
    return Selection(keys, allNodes(*edit.level, keys)).entering(edit.selection.entered());
}

Selection invertedNodes(const Edit& edit) {
    const std::vector<Key> keys = keysInEdit(edit);
    std::vector<NodeRef> nodes = allNodes(*edit.level, keys);
    std::erase_if(nodes, [&edit](const NodeRef& node) { return edit.selection.contains(node); });
    return Selection(keys, std::move(nodes)).entering(edit.selection.entered());
}

Selection nextNode(const Edit& edit, int direction) {
    const std::vector<Key> keys = keysInEdit(edit);
    const std::vector<NodeRef> all = allNodes(*edit.level, keys);
    const std::vector<NodeRef>& chosen = edit.selection.nodes();
    if (all.empty()) {
        return edit.selection;
    }
    NodeRef next = direction > 0 ? all.front() : all.back();
    if (!chosen.empty() && direction > 0) {
        const auto after = std::ranges::upper_bound(all, chosen.back());
        next = after == all.end() ? all.front() : *after;
    } else if (!chosen.empty()) {
        const auto from = std::ranges::lower_bound(all, chosen.front());
        next = from == all.begin() ? all.back() : *(from - 1);
    }
    return Selection(keys, {next}).entering(edit.selection.entered());
}

} // namespace spacetow
