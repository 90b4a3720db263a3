#pragma once
// The engine's debug drawing on a painter. Positions are those of the stage's view; what is out of it is left out.
// Thousands of marks are a matter of every frame, so what has one colour is painted at once: fillings first, in their
// order, then lines, then texts, each colour in the order in which it first came.

#include "core/physics/query/debug_draw.h"
#include "editor/canvas/stage.h"

#include <QLineF>
#include <QRectF>

#include <string>
#include <vector>

namespace spacetow {

Color toColor(const QColor& color);
QColor toQColor(const Color& color);

/// The stage must outlive it. What was drawn is on the painter when it is destroyed or flushed. Pen and brush are left
/// changed.
class PainterDraw : public DebugDraw {
  public:
    explicit PainterDraw(const Stage& stage);
    ~PainterDraw() override { flush(); }
    PainterDraw(const PainterDraw&) = delete;
    PainterDraw& operator=(const PainterDraw&) = delete;

    void flush();

    void circle(const Vec2& center, double radius, const Color& color) override;
    void filledCircle(const Vec2& center, double radius, const Color& color) override;
    void polygon(std::span<const Vec2> outline, const Color& color) override;
    void filledPolygon(std::span<const Vec2> outline, const Color& color) override;
    void line(const Vec2& a, const Vec2& b, const Color& color) override;
    void rectangle(const Aabb& box, const Color& color) override;
    void filledRectangle(const Aabb& box, const Color& color) override;
    void text(const Vec2& at, std::string_view text, const Color& color) override;
    void arrow(const Vec2& from, const Vec2& to, const Color& color) override;

  private:
    /// Everything of one colour.
    struct Batch {
        Color color;
        std::vector<QRectF> discs;
        std::vector<QPolygonF> areas;
        std::vector<QRectF> filledBoxes;
        std::vector<QRectF> boxes;
        std::vector<QRectF> circles;
        std::vector<QLineF> lines;
        std::vector<QPolygonF> outlines;
    };
    struct Text {
        QPointF at;
        QString text;
        Color color;
    };

    bool sees(const Aabb& box) const { return m_visible.overlaps(box); }
    /// Of so many marks that smooth ones would take five times as long, and nobody would see it.
    bool isCrowd() const { return m_marks > 1500; }
    Batch& batch(const Color& color);
    void paintFillings(const Batch& batch);
    void paintDiscs(const Batch& batch);
    void paintLines(const Batch& batch);
    void paintTexts();

    const Stage& m_stage;
    QPainter& m_painter;
    Aabb m_visible; // logical pixels
    std::vector<Batch> m_batches;
    std::size_t m_last = 0; // used last
    std::size_t m_marks = 0;
    std::vector<Text> m_texts;
};

} // namespace spacetow
