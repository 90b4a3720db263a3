#include "editor/editing/select_tool.h"

#include "core/level/arrange.h"
#include "core/level/nodes.h"
#include "core/level/object_geometry.h"
#include "editor/editing/guide_gestures.h"
#include "editor/editing/lasso_gesture.h"
#include "editor/editing/node_pick.h"
#include "editor/editing/node_tool.h"
#include "editor/editing/select_gestures.h"
#include "editor/editing/tools.h"

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

constexpr double spotlightPixels = 12; // of room about the group that was entered

std::vector<GroupPick> underPointer(const ToolContext& context, const Pointer& pointer) {
    return pickedMembers(context.edit, pointer);
}

void add(Overlay& overlay, const Overlay& more) {
    overlay.lines.insert(overlay.lines.end(), more.lines.begin(), more.lines.end());
    overlay.points.insert(overlay.points.end(), more.points.begin(), more.points.end());
    overlay.texts.insert(overlay.texts.end(), more.texts.begin(), more.texts.end());
}

FinishedEdit selecting(const ToolContext& context, Selection selection) {
    return {{}, {context.edit.level, std::move(selection)}};
}

/// The place of the selected object nearest to the pointer, or the pointer itself when none has a place.
Vec2 nearestPlace(const Edit& edit, const Vec2& pointer) {
    std::optional<Vec2> nearest;
    for (const Key key : unlockedKeys(*edit.level, edit.selection.keys())) {
        const std::optional<Vec2> place = placeOf(edit.level->objects.find(key)->data);
        if (place && (!nearest || (*place - pointer).norm() < (*nearest - pointer).norm())) {
            nearest = place;
        }
    }
    return nearest.value_or(pointer);
}

/// Where the origin of a single body is, unless it is in the middle, where everybody looks for it.
std::optional<Vec2> originBeside(const Edit& edit, const HandleFrame& frame, double pixel) {
    constexpr double apart = 3; // px
    const Object* object =
        edit.selection.size() == 1 ? edit.level->objects.find(edit.selection.keys().front()) : nullptr;
    const auto* body = object == nullptr ? nullptr : std::get_if<BodyObject>(&object->data);
    const bool isBeside =
        body != nullptr && !frame.box.isEmpty() && (body->position - pointOf(frame, {0, 0})).norm() > apart * pixel;
    return isBeside ? std::optional(body->position) : std::nullopt;
}

/// What follows the selected one in the pile under the pointer, from the top again after the bottom.
const GroupPick& nextInPile(const std::vector<GroupPick>& pile, const Selection& selection) {
    const auto top = std::ranges::find_if(pile, [&](const GroupPick& pick) { return selection.contains(pick.key); });
    return top == pile.end() || top + 1 == pile.end() ? pile.front() : *(top + 1);
}

} // namespace

std::unique_ptr<Gesture> SelectTool::press(const ToolContext& context, const Pointer& pointer) {
    const Edit& edit = context.edit;
    const Modifiers& held = pointer.modifiers;
    const std::optional<Handle> handle = handleUnder(context, pointer);
    const bool turns = handle && modeOf(context) != HandleMode::Scale;
    if (const std::optional<VelocityArrow> arrow = velocityUnder(context, pointer)) {
        return dragOfVelocity(context, *arrow, pointer);
    }
    // The handles that scale stand beside nodes, the pivot may lie on one.
    if (auto node = turns ? nullptr : dragOfNode(context, pointer)) {
        return node;
    }
    if (handle) {
        return dragOf(*handle, modeOf(context), context, pointer);
    }
    if (held.alt && held.shift) {
        return std::make_unique<LassoGesture>(edit, pointer.world);
    }
    if (held.alt && !edit.selection.empty()) {
        return std::make_unique<MoveGesture>(context, pointer, nearestPlace(edit, pointer.world));
    }
    const std::vector<GroupPick> pile = held.shift ? std::vector<GroupPick>() : underPointer(context, pointer);
    if (pile.empty()) {
        const std::optional<std::size_t> guide = guideInReach(context, pointer);
        if (guide && !held.shift && !held.ctrl) {
            return std::make_unique<MoveGuideGesture>(context, *guide);
        }
        return std::make_unique<BandGesture>(edit, pointer.world, held.shift || held.ctrl);
    }
    const GroupPick& top = pile.front();
    ToolContext grabbed = context;
    if (!edit.selection.contains(top.key)) {
        grabbed.edit.selection = Selection({top.key}).entering(top.entered);
    }
    const std::optional<Vec2> place = placeOf(edit.level->objects.find(top.key)->data);
    return std::make_unique<MoveGesture>(grabbed, pointer, place ? *place : nearestPlace(grabbed.edit, pointer.world));
}

std::optional<FinishedEdit> SelectTool::click(const ToolContext& context, const Pointer& pointer) {
    const Selection& selection = context.edit.selection;
    const Modifiers& held = pointer.modifiers;
    const std::optional<Handle> handle = handleUnder(context, pointer);
    const bool selects = !handle || (handle->side.isPivot() && held.shift); // a drag alone takes that pivot
    if (!selects || velocityUnder(context, pointer)) {
        return {};
    }
    const std::vector<GroupPick> pile = underPointer(context, pointer);
    if (pile.empty()) {
        return selecting(context, held.shift || held.ctrl ? selection : Selection().entering(selection.entered()));
    }
    const GroupPick& top = pile.front();
    if (held.ctrl && top.key != top.object) {
        return selecting(context, directly(context.edit, top.object));
    }
    if (held.shift || held.ctrl) {
        return selecting(context, selection.toggled(top.key).entering(top.entered));
    }
    if (!held.alt && selection.contains(top.key)) {
        m_turning = m_turning == selection.keys() ? std::vector<Key>() : selection.keys();
        return {};
    }
    const GroupPick& chosen = held.alt ? nextInPile(pile, selection) : top;
    return selecting(context, Selection({chosen.key}).entering(chosen.entered));
}

std::optional<FinishedEdit> SelectTool::doubleClick(const ToolContext& context, const Pointer& pointer) {
    const std::vector<GroupPick> pile = underPointer(context, pointer);
    const std::optional<Selection> selection =
        pile.empty() ? leaving(context.edit) : entering(context.edit, pile.front().key, pile.front().object);
    if (!selection) {
        return {};
    }
    return selecting(context, *selection);
}

std::optional<FinishedEdit> SelectTool::secondaryClick(const ToolContext& context, const Pointer& pointer) {
    const std::vector<GroupPick> pile = underPointer(context, pointer);
    const Selection& selection = context.edit.selection;
    if (pile.empty() ||
        std::ranges::any_of(pile, [&](const GroupPick& pick) { return selection.contains(pick.key); })) {
        return {};
    }
    return selecting(context, Selection({pile.front().key}).entering(pile.front().entered));
}

std::optional<ToolId> SelectTool::toolAfterDoubleClick(const ToolContext& context, const Pointer& pointer) const {
    const std::vector<GroupPick> pile = underPointer(context, pointer);
    const bool held = pointer.modifiers != Modifiers();
    return !held && !pile.empty() && hasNodes(context.edit.level->objects.find(pile.front().key)->data)
               ? std::optional(ToolId::Nodes)
               : std::nullopt;
}

const HandleFrame& SelectTool::frameOf(const ToolContext& context) const {
    const bool known = m_framed && m_framed->edit.level == context.edit.level && m_framed->snap == context.snap &&
                       m_framed->edit.selection == context.edit.selection;
    if (!known) {
        const std::vector<Key>& keys = context.edit.selection.keys();
        m_framed = Framed{context.edit, context.snap, handleFrame(context),
                          !keys.empty() && unlockedKeys(*context.edit.level, keys).empty()};
    }
    return m_framed->frame;
}

bool SelectTool::isAllLocked(const ToolContext& context) const {
    frameOf(context);
    return m_framed->allLocked;
}

HandleMode SelectTool::modeOf(const ToolContext& context) const {
    return m_turning == context.edit.selection.keys() ? HandleMode::Turn
           : frameOf(context).scales                  ? HandleMode::Scale
                                                      : HandleMode::TurnAtOnce;
}

std::optional<Handle> SelectTool::handleUnder(const ToolContext& context, const Pointer& pointer) const {
    if (context.edit.selection.empty()) {
        return {};
    }
    return handleAt(frameOf(context), modeOf(context), pointer);
}

std::optional<VelocityArrow> SelectTool::velocityUnder(const ToolContext& context, const Pointer& pointer) const {
    const std::optional<VelocityArrow> arrow = velocityArrow(context.edit, pointer.pixel);
    return arrow && isOnVelocity(*arrow, pointer) ? arrow : std::nullopt;
}

Overlay SelectTool::handles(const ToolContext& context, double pixel, const std::optional<Handle>& hot) const {
    Overlay overlay;
    if (!context.edit.selection.empty()) {
        overlay = handleOverlay(frameOf(context), modeOf(context), pixel, hot);
        if (const std::optional<Vec2> origin = originBeside(context.edit, frameOf(context), pixel)) {
            overlay.points.push_back({OverlayStyle::Origin, *origin});
        }
    }
    if (const std::optional<VelocityArrow> arrow = velocityArrow(context.edit, pixel)) {
        add(overlay, velocityOverlay(*arrow, pixel, false));
    }
    if (const Key entered = context.edit.selection.entered(); entered != 0) {
        overlay.spotlight = placedBounds(*context.edit.level, std::array{entered}).grown(spotlightPixels * pixel);
    }
    return overlay;
}

Overlay SelectTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    const std::optional<Handle> handle = handleUnder(context, pointer);
    const std::optional<VelocityArrow> arrow = velocityUnder(context, pointer);
    Overlay overlay = handles(context, pointer.pixel, handle);
    if (arrow) {
        add(overlay, velocityOverlay(*arrow, pointer.pixel, true));
    } else if (!handle && !context.pressed) {
        const std::vector<GroupPick> pile = underPointer(context, pointer);
        const bool selects = !pile.empty() && !context.edit.selection.contains(pile.front().key);
        overlay.hovered = selects ? pile.front().key : 0;
    }
    return overlay;
}

Overlay SelectTool::standing(const ToolContext& context, double pixel) const {
    return handles(context, pixel, std::nullopt);
}

Hint SelectTool::hint(const ToolContext& context, const Pointer& pointer) const {
    const Selection& selection = context.edit.selection;
    const std::optional<Handle> handle = handleUnder(context, pointer);
    const bool turns = handle && modeOf(context) != HandleMode::Scale;
    if (velocityUnder(context, pointer)) {
        return {"velocity.handle", {}};
    }
    if (!turns && isOnNode(context, pointer)) {
        return {"select.node", {}};
    }
    if (handle) {
        return handleHint(*handle, modeOf(context));
    }
    const std::vector<GroupPick> pile = underPointer(context, pointer);
    const bool overGroup = !pile.empty() && pile.front().key != pile.front().object;
    if (!pile.empty() && !selection.contains(pile.front().key)) {
        return {overGroup ? "select.group" : "select.object", {}};
    }
    const HandleFrame& frame = frameOf(context);
    if (!pile.empty() && modeOf(context) == HandleMode::Turn && coversSelection(frame, pointer.pixel)) {
        return {"select.small-pivot", {}};
    }
    if (pile.empty() && isLockedAt(*context.edit.level, pointer.world, grabPixels * pointer.pixel)) {
        return {"select.locked", {}};
    }
    if (isAllLocked(context)) {
        return {"select.all-locked", {std::to_string(selection.size())}};
    }
    if (overGroup) {
        return {"select.selected-group", {std::to_string(selection.size())}};
    }
    if (selection.entered() != 0) {
        const Object* group = context.edit.level->objects.find(selection.entered());
        const std::string count = std::to_string(selection.size());
        return group == nullptr || group->name.empty() ? Hint{"select.in-group", {count}}
                                                       : Hint{"select.in-named-group", {count, group->name}};
    }
    if (guideInReach(context, pointer)) {
        return {"guide.hover", {}};
    }
    if (selection.empty()) {
        return {"select.idle", {}};
    }
    return {"select.selected", {std::to_string(selection.size())}};
}

CursorShape SelectTool::cursor(const ToolContext& context, const Pointer& pointer) const {
    if (velocityUnder(context, pointer)) {
        return CursorShape::Pointing;
    }
    if (const std::optional<Handle> handle = handleUnder(context, pointer)) {
        return handleCursor(handle->side, modeOf(context), frameOf(context).turn);
    }
    const std::vector<GroupPick> pile = underPointer(context, pointer);
    if (pile.empty()) {
        return guideInReach(context, pointer) ? CursorShape::Move : CursorShape::Arrow;
    }
    return context.edit.selection.contains(pile.front().key) ? CursorShape::Move : CursorShape::Pointing;
}

} // namespace spacetow
