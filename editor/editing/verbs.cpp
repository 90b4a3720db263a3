#include "editor/editing/verbs.h"

#include "core/level/bounds.h"
#include "core/level/edits.h"
#include "core/level/groups.h"
#include "core/level/object_geometry.h"
#include "core/level/outline.h"
#include "editor/editing/node_verbs.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

constexpr double almost = 1e-9; // m, by which rounding moves what is on the grid

Label labelOf(LabelCode code, const Selection& selection) {
    return {code, selection.size()};
}

Edit withLevel(const Edit& edit, Level level) {
    return {std::make_shared<const Level>(std::move(level)), edit.selection};
}

/// The mean of the points of all selected objects; nothing when none of them has a place of its own.
std::optional<Vec2> middleOf(const Edit& edit) {
    const Outlines outlines(*edit.level);
    const std::vector<Key> keys = withMembers(*edit.level, edit.selection.keys());
    PointSum all;
    for (const int place : edit.level->objects.indicesOf(keys)) {
        const Object& object = edit.level->objects[place];
        if (!std::holds_alternative<ConnectorObject>(object.data)) {
            const PointSum points = pointsOf(outlines.of(object));
            all.sum += points.sum;
            all.count += points.count;
        }
    }
    if (all.count == 0) {
        return {};
    }
    return all.sum / all.count;
}

/// The place of what is selected alone, where that says where its middle is.
std::optional<Vec2> ownMiddle(const ToolContext& context) {
    const std::vector<Key>& keys = context.edit.selection.keys();
    const Object* only = keys.size() == 1 ? context.edit.level->objects.find(keys.front()) : nullptr;
    if (only == nullptr || std::holds_alternative<FinishObject>(only->data)) {
        return {};
    }
    const std::optional<Vec2> place = placeOf(only->data);
    const auto* body = std::get_if<BodyObject>(&only->data);
    if (!place || body == nullptr || body->kind == BodyKind::Kinematic) {
        return place;
    }
    const Aabb box = boundsOf(*context.edit.level, *only);
    const Vec2 step = Vec2::Constant(context.snap.grid ? 0.5 * context.snap.step : 0); // as far as it was rounded
    const Vec2 room = (0.25 * box.size()).cwiseMax(step);
    const bool isMiddle = ((*place - box.center()).cwiseAbs().array() <= room.array()).all();
    return isMiddle && box.grown(almost).contains(*place) ? place : std::nullopt;
}

} // namespace

std::optional<Vec2> turningPoint(const ToolContext& context) {
    if (const std::optional<Vec2>& pivot = context.edit.selection.pivot()) {
        return pivot;
    }
    if (const std::optional<Vec2> own = ownMiddle(context)) {
        return own;
    }
    const std::optional<Vec2> middle = middleOf(context.edit);
    return middle ? std::optional(onGridWithin(context.snap,
                                               boundsOf(*context.edit.level, context.edit.selection.keys()), *middle))
                  : std::nullopt;
}

std::optional<FinishedEdit> removeSelected(const ToolContext& context) {
    const Selection& selection = context.edit.selection;
    if (!selection.nodes().empty()) {
        return removeNodes(context);
    }
    if (selection.empty()) {
        return {};
    }
    const std::vector<Key> keys = unlockedKeys(*context.edit.level, selection.keys());
    if (keys.empty()) {
        return {};
    }
    Edit edit = withLevel(context.edit, removed(*context.edit.level, keys));
    edit.selection = Selection().entering(selection.entered()).within(*edit.level);
    return FinishedEdit{labelOf("delete", selection), std::move(edit)};
}

std::optional<FinishedEdit> duplicateSelected(const ToolContext& context) {
    const Vec2 delta(context.snap.step, -context.snap.step);
    std::vector<Key> copies;
    Level level = duplicated(*context.edit.level, context.edit.selection.keys(), {delta, context.seed}, copies);
    if (copies.empty()) {
        return {};
    }
    Selection selection(std::move(copies));
    const Label label = labelOf("duplicate", selection);
    selection = selection.entering(context.edit.selection.entered());
    return FinishedEdit{label,
                        {std::make_shared<const Level>(std::move(level)), std::move(selection)},
                        {},
                        Repeatable{Affine::translation(delta), true}};
}

std::optional<FinishedEdit> nudgeSelected(const ToolContext& context, const Vec2& delta) {
    const Selection& selection = context.edit.selection;
    if (!selection.nodes().empty()) {
        return nudgeNodes(context, delta);
    }
    if (selection.empty()) {
        return {};
    }
    Edit edit =
        withLevel(context.edit, moved(*context.edit.level, unlockedKeys(*context.edit.level, selection.keys()), delta));
    if (const std::optional<Vec2>& pivot = selection.pivot()) {
        edit.selection = selection.withPivot(*pivot + delta);
    }
    return FinishedEdit{labelOf("move", selection), std::move(edit), "nudge", Repeatable{Affine::translation(delta)}};
}

std::optional<FinishedEdit> rotateSelected(const ToolContext& context, double radians) {
    const Selection& selection = context.edit.selection;
    if (!selection.nodes().empty()) {
        return rotateNodes(context, radians);
    }
    const std::optional<Vec2> pivot = turningPoint(context);
    if (!pivot) {
        return {};
    }
    const Level& level = *context.edit.level;
    Edit edit = withLevel(context.edit, rotated(level, unlockedKeys(level, selection.keys()), *pivot, radians));
    edit.selection = selection.withPivot(pivot);
    return FinishedEdit{labelOf("rotate", selection), std::move(edit), "rotate",
                        Repeatable{Affine::rotation(*pivot, radians)}};
}

std::optional<FinishedEdit> mapSelected(const ToolContext& context, LabelCode code, const Affine& map) {
    const Selection& selection = context.edit.selection;
    const Level& level = *context.edit.level;
    const std::vector<Key> keys = unlockedKeys(level, selection.keys());
    if (keys.empty()) {
        return {};
    }
    Edit edit = withLevel(context.edit, transformed(level, keys, map));
    if (const std::optional<Vec2>& pivot = selection.pivot()) {
        edit.selection = selection.withPivot(map(*pivot));
    }
    return FinishedEdit{labelOf(code, selection), std::move(edit), {}, Repeatable{map}};
}

std::optional<FinishedEdit> flipSelected(const ToolContext& context, FlipAxis axis) {
    const Selection& selection = context.edit.selection;
    if (selection.empty()) {
        return {};
    }
    return FinishedEdit{labelOf("flip", selection),
                        withLevel(context.edit, flipped(*context.edit.level, selection.keys(), axis))};
}

std::optional<FinishedEdit> reverseSelected(const ToolContext& context) {
    const Selection& selection = context.edit.selection;
    if (!selection.nodes().empty()) {
        return reverseNodes(context);
    }
    if (selection.empty()) {
        return {};
    }
    return FinishedEdit{
        labelOf("reverse", selection),
        withLevel(context.edit, reversed(*context.edit.level, unlockedKeys(*context.edit.level, selection.keys())))};
}

Selection selectAll(const Edit& edit) {
    return Selection(selectableKeys(*edit.level, edit.selection.entered())).entering(edit.selection.entered());
}

Selection invertedSelection(const Edit& edit) {
    std::vector<Key> keys = selectableKeys(*edit.level, edit.selection.entered());
    std::erase_if(keys, [&edit](Key key) { return edit.selection.contains(key); });
    return Selection(std::move(keys)).entering(edit.selection.entered());
}

} // namespace spacetow
