#pragma once
// The canvas with its rulers around it.

#include "editor/canvas/canvas.h"
#include "editor/canvas/ruler.h"

#include <QGridLayout>
#include <QWidget>

namespace spacetow {

class CanvasFrame : public QWidget {
    Q_OBJECT

  public:
    /// Document and toolbox must outlive the frame.
    CanvasFrame(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);

    Canvas& canvas() { return m_canvas; }
    bool areRulersVisible() const { return !m_top.isHidden(); }
    void setRulersVisible(bool visible);
    /// What the rulers show of the selection; empty for nothing.
    void setExtent(const Aabb& selected);
    Ruler& top() { return m_top; }
    Ruler& left() { return m_left; }
    RulerCorner& corner() { return m_corner; }

  private:
    QGridLayout m_grid;
    RulerCorner m_corner;
    Ruler m_top;
    Ruler m_left;
    Canvas m_canvas;
};

} // namespace spacetow
