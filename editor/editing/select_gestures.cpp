#include "editor/editing/select_gestures.h"

#include "core/level/arrange.h"
#include "core/level/edits.h"
#include "editor/editing/group_picking.h"
#include "editor/editing/measure.h"
#include "editor/editing/pick.h"

#include <array>

namespace spacetow {

MoveGesture::MoveGesture(const ToolContext& context, const Pointer& start, const Vec2& reference)
    : m_edit(context.edit), m_keys(unlockedKeys(*m_edit.level, m_edit.selection.keys())), m_start(start.world),
      m_reference(reference), m_snap(context, subjectOf(*m_edit.level, m_keys, start, reference), reference) {}

std::optional<SnapAnswer> MoveGesture::snapAt(const Pointer& pointer) const {
    return m_snap.moved(pointer.world - m_start, pointer);
}

Edit MoveGesture::at(const Pointer& pointer) const {
    const Vec2 delta = deltaAt(pointer);
    if (delta == Vec2(0, 0)) {
        return m_edit;
    }
    const std::optional<Vec2>& pivot = m_edit.selection.pivot();
    return {std::make_shared<const Level>(moved(*m_edit.level, m_keys, delta)),
            pivot ? m_edit.selection.withPivot(*pivot + delta) : m_edit.selection};
}

Label MoveGesture::label() const {
    return {"move", m_edit.selection.size()};
}

Overlay MoveGesture::overlay(const Pointer& pointer) const {
    const Vec2 delta = deltaAt(pointer);
    const Vec2 target = m_reference + delta;
    Overlay overlay;
    overlay.lines.push_back({OverlayStyle::Measure, {m_reference, target}});
    overlay.points.push_back({OverlayStyle::Snap, target});
    overlay.texts.push_back({pointer.world, wayText(delta)});
    return overlay;
}

Hint MoveGesture::hint(const Pointer& pointer) const {
    const Vec2 delta = deltaAt(pointer);
    return {"select.moving", {lengthText(delta.x()), lengthText(delta.y())}};
}

Edit BandGesture::at(const Pointer& pointer) const {
    const Level& level = *edit().level;
    const Aabb box = boxAt(pointer);
    const bool wholly = pointer.modifiers.alt;
    std::vector<Key> keys = membersOf(edit(), pickedIn(level, box, wholly));
    if (wholly) { // a group is inside when all that is in it is
        std::erase_if(keys, [&](Key key) {
            return std::holds_alternative<GroupObject>(level.objects.find(key)->data) &&
                   !box.contains(placedBounds(level, std::array{key}));
        });
    }
    if (m_extends) {
        keys.insert(keys.end(), edit().selection.keys().begin(), edit().selection.keys().end());
    }
    return {edit().level, Selection(std::move(keys)).entering(edit().selection.entered())};
}

Hint BandGesture::hint(const Pointer& pointer) const {
    return {"select.band", {std::to_string(at(pointer).selection.size())}};
}

} // namespace spacetow
