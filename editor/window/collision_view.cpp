#include "editor/window/collision_view.h"

#include "editor/editing/collisions.h"

namespace spacetow {

CollisionView::CollisionView(Document& document, Canvas& canvas) : m_document(document), m_canvas(canvas) {
    m_listener = m_document.changed.connect([this](const Change&) { refresh(); });
}

CollisionView::~CollisionView() {
    m_document.changed.disconnect(m_listener);
}

void CollisionView::setOn(bool on) {
    m_on = on;
    m_shown = {};
    refresh();
}

void CollisionView::refresh() {
    if (!m_on) {
        m_canvas.setHighlighted({});
        return;
    }
    // A gesture changes neither tags nor, but for selecting, what is selected.
    const Edit& current = m_document.current();
    if (current.level != m_shown.level || !(current.selection == m_shown.selection)) {
        m_shown = current;
        m_canvas.setHighlighted(collidingWith(*current.level, current.selection.keys()));
    }
}

} // namespace spacetow
