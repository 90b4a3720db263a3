// Where the pointer is, what the tools and others hear of it, and the view that follows it beyond the edges.
#include "editor/canvas/canvas.h"
#include "editor/editing/measure.h"

#include <optional>

namespace spacetow {

void Canvas::moveTo(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    m_position = position;
    m_held = modifiers;
    m_inside = true;
    const Pointer pointer = pointerAt(position, modifiers);
    if (!isLive() || m_live->showsTool()) {
        m_toolbox.move(pointer);
    } else {
        updateCursor();
        tellPlace();
    }
    if (m_drag == Drag::Tool && m_toolbox.scrolls()) {
        m_edgeScroll.follow(rect(), position);
    }
    Q_EMIT pointerMoved(pointer.world.x(), pointer.world.y());
}

void Canvas::tellPlace() {
    if (!m_position || !(m_inside || isDragging())) {
        return;
    }
    const bool isTools = !isLive() || m_live->showsTool();
    const std::optional<SnapAnswer> snap = isTools ? m_toolbox.snapAnswer() : std::nullopt;
    const Vec2 place = snap ? snap->mark : pointerPosition();
    Q_EMIT pointed(place.x(), place.y(),
                   placeDecimals(m_view.pixel(), snap && m_toolbox.snap.grid ? m_toolbox.snap.fineStep() : 0));
}

void Canvas::scrollAtEdge(const QPointF& push) {
    if (m_drag != Drag::Tool || !m_toolbox.scrolls()) {
        m_edgeScroll.end();
        return;
    }
    panBy(-push);
    moveTo(*m_position, m_held);
}

void Canvas::modifiersChanged(Qt::KeyboardModifiers modifiers) {
    m_held = modifiers;
    const bool follows = m_position && (m_inside || isDragging());
    if (follows && m_drag != Drag::Pan && (!isLive() || m_live->showsTool())) {
        m_toolbox.move(pointerAt(*m_position, modifiers));
    }
}

Vec2 Canvas::pointerPosition() const {
    return m_position ? m_view.toWorld(Vec2(m_position->x(), m_position->y())) : m_view.center;
}

Pointer Canvas::pointerAt(const QPointF& position, Qt::KeyboardModifiers modifiers) const {
    const Vec2 screen(position.x(), position.y());
    return {m_view.toWorld(screen), screen,
            Modifiers{modifiers.testFlag(Qt::ShiftModifier), modifiers.testFlag(Qt::ControlModifier),
                      modifiers.testFlag(Qt::AltModifier) || m_belowHeld},
            m_view.pixel(), m_view.visible()};
}

} // namespace spacetow
