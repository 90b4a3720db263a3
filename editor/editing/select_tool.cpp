#include "editor/editing/select_tool.h"

#include "core/level/outline.h"
#include "editor/editing/node_pick.h"
#include "editor/editing/node_tool.h"
#include "editor/editing/select_gestures.h"
#include "editor/editing/tools.h"

#include <algorithm>

namespace spacetow {

namespace {

std::vector<Key> underPointer(const ToolContext& context, const Pointer& pointer) {
    return picked(*context.edit.level, pointer.world, grabPixels * pointer.pixel);
}

FinishedEdit selecting(const ToolContext& context, Selection selection) {
    return {{}, {context.edit.level, std::move(selection)}};
}

/// The place by which an object snaps.
std::optional<Vec2> placeOf(const Object& object) {
    if (const std::optional<Transform> pose = poseOf(object)) {
        return pose->position;
    }
    if (const auto* finish = std::get_if<FinishObject>(&object.data)) {
        return finish->a;
    }
    return {};
}

/// The place of the selected object nearest to the pointer, or the pointer itself when none has a place.
Vec2 nearestPlace(const Edit& edit, const Vec2& pointer) {
    std::optional<Vec2> nearest;
    for (const Object& object : edit.level->objects) {
        const std::optional<Vec2> place = edit.selection.contains(object.key) ? placeOf(object) : std::nullopt;
        if (place && (!nearest || (*place - pointer).norm() < (*nearest - pointer).norm())) {
            nearest = place;
        }
    }
    return nearest.value_or(pointer);
}

/// What follows the selected one in the pile under the pointer, from the top again after the bottom.
Key nextInPile(const std::vector<Key>& pile, const Selection& selection) {
    const auto top = std::find_if(pile.begin(), pile.end(), [&selection](Key key) { return selection.contains(key); });
    return top == pile.end() || top + 1 == pile.end() ? pile.front() : *(top + 1);
}

} // namespace

std::unique_ptr<Gesture> SelectTool::press(const ToolContext& context, const Pointer& pointer) {
    const Edit& edit = context.edit;
    const Modifiers& held = pointer.modifiers;
    if (auto node = dragOfNode(context, pointer)) {
        return node;
    }
    if (held.alt && !held.shift && !edit.selection.empty()) {
        return std::make_unique<MoveGesture>(context, pointer, nearestPlace(edit, pointer.world));
    }
    const std::vector<Key> pile = held.shift ? std::vector<Key>() : underPointer(context, pointer);
    if (pile.empty()) {
        return std::make_unique<BandGesture>(edit, pointer.world, held.shift || held.ctrl);
    }
    ToolContext grabbed = context;
    if (!edit.selection.contains(pile.front())) {
        grabbed.edit.selection = Selection({pile.front()});
    }
    const std::optional<Vec2> place = placeOf(*edit.level->objects.find(pile.front()));
    return std::make_unique<MoveGesture>(grabbed, pointer, place ? *place : nearestPlace(grabbed.edit, pointer.world));
}

std::optional<FinishedEdit> SelectTool::click(const ToolContext& context, const Pointer& pointer) {
    const Selection& selection = context.edit.selection;
    const std::vector<Key> pile = underPointer(context, pointer);
    const bool toggles = pointer.modifiers.shift || pointer.modifiers.ctrl;
    if (pile.empty()) {
        return selecting(context, toggles ? selection : Selection());
    }
    if (toggles) {
        return selecting(context, selection.toggled(pile.front()));
    }
    return selecting(context, Selection({pointer.modifiers.alt ? nextInPile(pile, selection) : pile.front()}));
}

std::optional<FinishedEdit> SelectTool::secondaryClick(const ToolContext& context, const Pointer& pointer) {
    const std::vector<Key> pile = underPointer(context, pointer);
    const Selection& selection = context.edit.selection;
    if (pile.empty() || std::any_of(pile.begin(), pile.end(), [&](Key key) { return selection.contains(key); })) {
        return {};
    }
    return selecting(context, Selection({pile.front()}));
}

std::optional<ToolId> SelectTool::toolAfterDoubleClick(const ToolContext& context, const Pointer& pointer) const {
    const std::vector<Key> pile = underPointer(context, pointer);
    const bool held = pointer.modifiers != Modifiers();
    return !held && !pile.empty() && hasNodes(context.edit.level->objects.find(pile.front())->data)
               ? std::optional(ToolId::Nodes)
               : std::nullopt;
}

Overlay SelectTool::overlay(const ToolContext&, const Pointer&) const {
    return {};
}

Hint SelectTool::hint(const ToolContext& context, const Pointer& pointer) const {
    const Selection& selection = context.edit.selection;
    if (isOnNode(context, pointer)) {
        return {"select.node", {}};
    }
    const std::vector<Key> pile = underPointer(context, pointer);
    if (!pile.empty() && !selection.contains(pile.front())) {
        return {"select.object", {}};
    }
    if (selection.empty()) {
        return {"select.idle", {}};
    }
    return {"select.selected", {std::to_string(selection.size())}};
}

CursorShape SelectTool::cursor(const ToolContext& context, const Pointer& pointer) const {
    const std::vector<Key> pile = underPointer(context, pointer);
    if (pile.empty()) {
        return CursorShape::Arrow;
    }
    return context.edit.selection.contains(pile.front()) ? CursorShape::Move : CursorShape::Pointing;
}

} // namespace spacetow
