#include "editor/editing/kinematic_tool.h"

#include "editor/editing/rectangle_tool.h"
#include "editor/editing/velocity_handle.h"

#include <utility>

namespace spacetow {

std::optional<Vec2> KinematicTool::arrowFrom(const ToolContext& context) const {
    return m_body != 0 ? velocityOrigin(*context.edit.level, m_body) : std::nullopt;
}

/// What comes out of the outline is a body that now gets its velocity.
std::optional<FinishedEdit> KinematicTool::drawn(std::optional<FinishedEdit> finished) {
    m_body = finished ? finished->edit.selection.keys().front() : 0;
    return finished;
}

std::unique_ptr<Gesture> KinematicTool::press(const ToolContext& context, const Pointer& pointer) {
    m_pressedOn = context.edit.level;
    if (const std::optional<Vec2> from = arrowFrom(context)) {
        // As if the arrow that follows the pointer had been taken by its tip.
        return dragOfVelocity(context, {m_body, *from, Vec2(pointer.world - *from), pointer.world}, pointer);
    }
    return m_outline.isBusy() ? nullptr : dragOfRectangle(context, pointer, BodyKind::Kinematic);
}

void KinematicTool::dragEnded(const ToolContext& context, const Pointer&) {
    const std::shared_ptr<const Level> before = std::exchange(m_pressedOn, nullptr);
    const bool drew = before && before != context.edit.level && m_body == 0;
    m_body = drew ? context.edit.selection.keys().front() : 0;
}

std::optional<FinishedEdit> KinematicTool::click(const ToolContext& context, const Pointer& pointer) {
    const std::optional<Vec2> from = arrowFrom(context);
    if (!from) {
        return drawn(m_outline.click(context, pointer));
    }
    const Key body = std::exchange(m_body, 0);
    return FinishedEdit{{"set-velocity", 1}, withVelocity(context.edit, body, velocityTo(context, *from, pointer))};
}

std::optional<FinishedEdit> KinematicTool::drop(const ToolContext& context, const Pointer& pointer) {
    return drawn(m_outline.drop(context, pointer));
}

std::optional<FinishedEdit> KinematicTool::doubleClick(const ToolContext& context, const Pointer& pointer) {
    return arrowFrom(context) ? click(context, pointer) : drawn(m_outline.doubleClick(context, pointer));
}

std::optional<FinishedEdit> KinematicTool::secondaryClick(const ToolContext& context, const Pointer& pointer) {
    if (m_body != 0) {
        cancel();
        return {};
    }
    return drawn(m_outline.secondaryClick(context, pointer));
}

std::optional<FinishedEdit> KinematicTool::key(const ToolContext& context, ToolKey key, const Pointer& pointer) {
    if (m_body != 0) {
        cancel();
        return {};
    }
    return drawn(m_outline.key(context, key, pointer));
}

std::optional<TypedMeasures> KinematicTool::measures(const ToolContext& context, const Pointer& pointer) const {
    const std::optional<Vec2> from = arrowFrom(context);
    return from ? polarMeasures(TypedKind::SpeedAngle, velocityTo(context, *from, pointer))
                : m_outline.measures(context, pointer);
}

void KinematicTool::hover(const ToolContext& context, const Pointer& pointer) {
    if (!arrowFrom(context)) {
        m_body = 0; // it has been undone
        m_outline.hover(context, pointer);
    }
}

void KinematicTool::cancel() {
    m_outline.cancel();
    m_body = 0;
}

Overlay KinematicTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    const std::optional<Vec2> from = arrowFrom(context);
    return from ? velocityDraft(*from, velocityTo(context, *from, pointer), pointer.pixel)
                : m_outline.overlay(context, pointer);
}

Hint KinematicTool::hint(const ToolContext& context, const Pointer& pointer) const {
    const std::optional<Vec2> from = arrowFrom(context);
    return from ? velocityHint("velocity.drawing", velocityTo(context, *from, pointer))
                : m_outline.hint(context, pointer);
}

CursorShape KinematicTool::cursor(const ToolContext& context, const Pointer& pointer) const {
    return arrowFrom(context) ? CursorShape::Cross : m_outline.cursor(context, pointer);
}

} // namespace spacetow
