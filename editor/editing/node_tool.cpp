#include "editor/editing/node_tool.h"

#include "core/level/node_edits.h"
#include "core/level/object_geometry.h"
#include "editor/editing/node_gestures.h"
#include "editor/editing/node_handles.h"
#include "editor/editing/node_pick.h"
#include "editor/editing/select_tool.h"
#include "editor/editing/snap_point.h"

#include <algorithm>

namespace spacetow {

namespace {

std::optional<Hit> hitUnder(const ToolContext& context, const Pointer& pointer, std::span<const Key> keys) {
    return nodeHit(*context.edit.level, {pointer.world, grabPixels * pointer.pixel, keys});
}

std::optional<Hit> hitUnder(const ToolContext& context, const Pointer& pointer) {
    return hitUnder(context, pointer, keysInEdit(context.edit));
}

/// The best object under the pointer that has nodes, or 0.
Key objectUnder(const ToolContext& context, const Pointer& pointer) {
    const Level& level = *context.edit.level;
    for (const Key key : picked(level, pointer.world, grabPixels * pointer.pixel)) {
        if (hasNodes(level.objects.find(key)->data)) {
            return key;
        }
    }
    return 0;
}

FinishedEdit choosing(const ToolContext& context, const Selection& selection) {
    return {{}, {context.edit.level, selection.entering(context.edit.selection.entered())}};
}

/// The objects in edit, with these nodes. Groups give way to their members, whose nodes these are.
Selection selectionWith(const Edit& edit, std::vector<NodeRef> nodes) {
    return nodes.empty() ? edit.selection.withNodes({}) : Selection(keysInEdit(edit), std::move(nodes));
}

std::vector<NodeRef> nodesOfHit(const Level& level, const Hit& hit) {
    return hit.kind == HitKind::Node ? std::vector{nodeOf(hit)} : endsOf(level, hit);
}

bool toggles(const Pointer& pointer) {
    return pointer.modifiers.shift || pointer.modifiers.ctrl;
}

bool inserts(const Pointer& pointer) {
    return pointer.modifiers.ctrl && pointer.modifiers.alt;
}

} // namespace

std::optional<FinishedEdit> insertNode(const ToolContext& context, const Pointer& pointer) {
    const std::optional<Hit> hit = hitUnder(context, pointer);
    if (!hit || hit->kind != HitKind::Segment) {
        return {};
    }
    Pointer plain = pointer;
    plain.modifiers = {}; // held for the click, not for the grid
    const std::optional<Vec2> place = placeOn(*context.edit.level, *hit, snapped(context, plain));
    if (!place) {
        return {};
    }
    NodeEdit edit = withNode(*context.edit.level, nodeOf(*hit), *place);
    Selection selection = selectionWith(context.edit, std::move(edit.nodes));
    return FinishedEdit{{"insert-nodes", 1},
                        {std::make_shared<const Level>(std::move(edit.level)), std::move(selection)}};
}

std::unique_ptr<Gesture> NodeTool::press(const ToolContext& context, const Pointer& pointer) {
    const Edit& edit = context.edit;
    const Modifiers& held = pointer.modifiers;
    if (const std::optional<NodeHandle> handle = nodeHandleAt(edit, m_turns, pointer)) {
        return dragOfNodeHandle(context, *handle, m_turns, pointer);
    }
    if (held.shift) {
        return std::make_unique<NodeBandGesture>(edit, pointer.world,
                                                 held.alt ? MarqueeShape::Lasso : MarqueeShape::Box, true);
    }
    const std::optional<Hit> hit = hitUnder(context, pointer);
    if (!hit) {
        return std::make_unique<NodeBandGesture>(edit, pointer.world,
                                                 held.alt ? MarqueeShape::Lasso : MarqueeShape::Box, held.ctrl);
    }
    std::vector<NodeRef> grabbed = nodesOfHit(*edit.level, *hit);
    ToolContext with = context;
    const bool all =
        std::ranges::all_of(grabbed, [&edit](const NodeRef& node) { return edit.selection.contains(node); });
    if (!all) {
        with.edit.selection = selectionWith(edit, grabbed).entering(edit.selection.entered());
    }
    const Vec2 reference = nodePosition(*edit.level, grabbed.front()).value_or(pointer.world);
    return std::make_unique<MoveNodesGesture>(with, NodeDrag{with.edit.selection.nodes(), reference, pointer.world});
}

std::optional<FinishedEdit> NodeTool::click(const ToolContext& context, const Pointer& pointer) {
    const Edit& edit = context.edit;
    if (inserts(pointer)) {
        return insertNode(context, pointer);
    }
    if (nodeHandleAt(edit, m_turns, pointer)) {
        return {};
    }
    if (const std::optional<Hit> hit = hitUnder(context, pointer)) {
        std::vector<NodeRef> nodes = nodesOfHit(*edit.level, *hit);
        if (!toggles(pointer) && hit->kind == HitKind::Node && edit.selection.nodes().size() > 1 &&
            edit.selection.contains(nodes.front())) {
            m_turns = !m_turns;
            return {};
        }
        if (!toggles(pointer)) {
            m_turns = false;
            return choosing(context, selectionWith(edit, std::move(nodes)));
        }
        std::vector<NodeRef> chosen = edit.selection.nodes();
        const bool all =
            std::ranges::all_of(nodes, [&edit](const NodeRef& node) { return edit.selection.contains(node); });
        if (all) {
            std::erase_if(chosen,
                          [&nodes](const NodeRef& node) { return std::ranges::find(nodes, node) != nodes.end(); });
        } else {
            chosen.insert(chosen.end(), nodes.begin(), nodes.end());
        }
        return choosing(context, selectionWith(edit, std::move(chosen)));
    }
    if (const Key key = objectUnder(context, pointer)) {
        return choosing(context, toggles(pointer) ? edit.selection.toggled(key) : Selection({key}));
    }
    return choosing(context, toggles(pointer) ? edit.selection : edit.selection.withNodes({}));
}

std::optional<FinishedEdit> NodeTool::doubleClick(const ToolContext& context, const Pointer& pointer) {
    return insertNode(context, pointer);
}

std::optional<FinishedEdit> NodeTool::secondaryClick(const ToolContext& context, const Pointer& pointer) {
    const std::optional<Hit> hit = hitUnder(context, pointer);
    if (!hit) {
        return {};
    }
    std::vector<NodeRef> nodes = nodesOfHit(*context.edit.level, *hit);
    if (std::ranges::any_of(nodes, [&](const NodeRef& node) { return context.edit.selection.contains(node); })) {
        return {};
    }
    return choosing(context, selectionWith(context.edit, std::move(nodes)));
}

Overlay NodeTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    Overlay overlay = standing(context, pointer.pixel);
    if (const std::optional<NodeHandle> handle = nodeHandleAt(context.edit, m_turns, pointer)) {
        overlay.points.push_back({OverlayStyle::HotHandle, handle->at});
        return overlay;
    }
    const std::optional<Hit> hit = hitUnder(context, pointer, overlay.nodes->keys);
    if (!hit) {
        return overlay;
    }
    overlay.nodes->hot = nodesOfHit(*context.edit.level, *hit);
    overlay.nodes->hotSegment = hit->kind == HitKind::Segment;
    if (hit->kind == HitKind::Segment && inserts(pointer)) {
        Pointer plain = pointer;
        plain.modifiers = {};
        if (const auto place = placeOn(*context.edit.level, *hit, snapped(context, plain))) {
            overlay.points.push_back({OverlayStyle::Snap, *place});
        }
    }
    return overlay;
}

Overlay NodeTool::standing(const ToolContext& context, double pixel) const {
    Overlay overlay;
    overlay.nodes = OverlayNodes{keysInEdit(context.edit), {}, {}};
    for (const NodeHandle& handle : nodeHandles(context.edit, m_turns, pixel)) {
        overlay.points.push_back({m_turns ? OverlayStyle::HotHandle : OverlayStyle::Handle, handle.at});
    }
    return overlay;
}

Hint NodeTool::hint(const ToolContext& context, const Pointer& pointer) const {
    const Selection& selection = context.edit.selection;
    if (nodeHandleAt(context.edit, m_turns, pointer)) {
        return {m_turns ? "nodes.turn-handle" : "nodes.scale-handle", {}};
    }
    const std::vector<Key> keys = keysInEdit(context.edit);
    if (const std::optional<Hit> hit = hitUnder(context, pointer, keys)) {
        if (hit->kind == HitKind::Segment) {
            return {inserts(pointer) ? "nodes.insert" : "nodes.segment", {}};
        }
        return {"nodes.node", {}};
    }
    if (keys.empty()) {
        return {selection.empty() ? "nodes.none" : "nodes.without", {}};
    }
    if (!selection.nodes().empty()) {
        const std::size_t count = selection.nodes().size();
        return count == 1 ? Hint{"nodes.one-selected", {}} : Hint{"nodes.selected", {std::to_string(count)}};
    }
    return {objectUnder(context, pointer) != 0 ? "nodes.object" : "nodes.idle", {}};
}

CursorShape NodeTool::cursor(const ToolContext& context, const Pointer& pointer) const {
    if (nodeHandleAt(context.edit, m_turns, pointer)) {
        return CursorShape::Pointing;
    }
    if (const std::optional<Hit> hit = hitUnder(context, pointer)) {
        return hit->kind == HitKind::Node ? CursorShape::Move : CursorShape::Insert;
    }
    return objectUnder(context, pointer) != 0 ? CursorShape::Pointing : CursorShape::Arrow;
}

namespace {

/// The node that a plain drag would move; nothing with modifiers, which mean something for objects.
std::optional<Hit> nodeToDrag(const ToolContext& context, const Pointer& pointer) {
    const Selection& selection = context.edit.selection;
    if (selection.size() != 1 || pointer.modifiers.shift || pointer.modifiers.alt) {
        return {};
    }
    const std::vector<Key> keys = keysInEdit(context.edit);
    if (keys != selection.keys()) {
        return {};
    }
    const double tolerance = grabPixels * pointer.pixel;
    const Aabb box = ownBounds(context.edit.level->objects.find(keys.front())->data);
    constexpr double room = 5; // times the reach of a node
    if (box.size().maxCoeff() < room * tolerance) {
        return {};
    }
    const std::optional<Hit> hit = nodeHit(*context.edit.level, {pointer.world, tolerance, keys});
    return hit && hit->kind == HitKind::Node ? hit : std::nullopt;
}

} // namespace

std::unique_ptr<Gesture> dragOfNode(const ToolContext& context, const Pointer& pointer) {
    const std::optional<Hit> hit = nodeToDrag(context, pointer);
    if (!hit) {
        return nullptr;
    }
    return std::make_unique<MoveNodesGesture>(context, NodeDrag{{nodeOf(*hit)}, hit->at, pointer.world});
}

bool isOnNode(const ToolContext& context, const Pointer& pointer) {
    return nodeToDrag(context, pointer).has_value();
}

} // namespace spacetow
