#include "editor/canvas/canvas_frame.h"

namespace spacetow {

CanvasFrame::CanvasFrame(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), m_grid(this), m_top(Qt::Horizontal), m_left(Qt::Vertical), m_canvas(document, toolbox) {
    m_grid.setContentsMargins(0, 0, 0, 0);
    m_grid.setSpacing(0);
    m_grid.addWidget(&m_corner, 0, 0);
    m_grid.addWidget(&m_top, 0, 1);
    m_grid.addWidget(&m_left, 1, 0);
    m_grid.addWidget(&m_canvas, 1, 1);
    connect(&m_canvas, &Canvas::viewChanged, this, [this] {
        m_top.setView(m_canvas.view());
        m_left.setView(m_canvas.view());
    });
    connect(&m_canvas, &Canvas::pointerMoved, this, [this](double x, double y) {
        m_top.setPointer(Vec2(x, y));
        m_left.setPointer(Vec2(x, y));
    });
    for (const GuideSource* source : std::initializer_list<const GuideSource*>{&m_corner, &m_top, &m_left}) {
        connect(source, &GuideSource::pressed, &m_canvas,
                [this, source](const QPointF& global, Qt::KeyboardModifiers modifiers) {
                    m_canvas.setFocus(); // Escape and the modifiers are the gesture's
                    m_canvas.beginGuide(source->angle(), global, modifiers);
                });
        connect(source, &GuideSource::dragged, &m_canvas, &Canvas::dragGuide);
        connect(source, &GuideSource::released, &m_canvas, &Canvas::endGuide);
    }
    connect(&m_canvas, &Canvas::pointerLeft, this, [this] {
        m_top.setPointer({});
        m_left.setPointer({});
    });
}

void CanvasFrame::setRulersVisible(bool visible) {
    m_corner.setVisible(visible);
    m_top.setVisible(visible);
    m_left.setVisible(visible);
}

void CanvasFrame::setExtent(const Aabb& selected) {
    m_top.setExtent(selected);
    m_left.setExtent(selected);
}

} // namespace spacetow
