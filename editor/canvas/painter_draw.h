#pragma once
// The engine's debug drawing on a painter. Positions are those of the stage's view; what is out of it is left out.

#include "core/physics/query/debug_draw.h"
#include "editor/canvas/stage.h"

namespace spacetow {

Color toColor(const QColor& color);

/// The stage must outlive it. Pen and brush are left changed.
class PainterDraw : public DebugDraw {
  public:
    explicit PainterDraw(const Stage& stage);

    void circle(const Vec2& center, double radius, const Color& color) override;
    void filledCircle(const Vec2& center, double radius, const Color& color) override;
    void polygon(std::span<const Vec2> outline, const Color& color) override;
    void filledPolygon(std::span<const Vec2> outline, const Color& color) override;
    void line(const Vec2& a, const Vec2& b, const Color& color) override;
    void rectangle(const Aabb& box, const Color& color) override;
    void filledRectangle(const Aabb& box, const Color& color) override;
    void arrow(const Vec2& from, const Vec2& to, const Color& color) override;

  private:
    bool sees(const Aabb& box) const { return m_visible.overlaps(box); }

    QPainter& m_painter;
    Aabb m_visible; // logical pixels
};

} // namespace spacetow
