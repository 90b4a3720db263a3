#pragma once
// The engine's debug drawing, gathered to be painted at once, or part by part. Positions are those of the view; what is
// out of it is left out. Thousands of marks are a matter of every frame, so what has one colour is painted together:
// fillings first, in their order, then lines, then texts, each colour in the order in which it first came.

#include "core/physics/query/debug_draw.h"
#include "editor/canvas/stage.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QRectF>

#include <functional>
#include <string>
#include <vector>

namespace spacetow {

Color toColor(const QColor& color);
QColor toQColor(const Color& color);

class PainterDraw : public DebugDraw {
  public:
    /// The size of the view, logical pixels.
    explicit PainterDraw(const Vec2& size);

    /// All that has been drawn, with the stage's painter, of which pen and brush are left changed. Several threads may
    /// do so at the same time, each with a painter of its own.
    void paint(const Stage& stage) const;

    void circle(const Vec2& center, double radius, const Color& color) override;
    void filledCircle(const Vec2& center, double radius, const Color& color) override;
    void polygon(std::span<const Vec2> outline, const Color& color) override;
    void filledPolygon(std::span<const Vec2> outline, const Color& color) override;
    void line(const Vec2& a, const Vec2& b, const Color& color) override;
    void rectangle(const Aabb& box, const Color& color) override;
    void filledRectangle(const Aabb& box, const Color& color) override;
    void text(const Vec2& at, std::string_view text, const Color& color) override;
    void name(const Vec2& at, std::string_view name, const Color& color, std::uint64_t user) override;
    void arrow(const Vec2& from, const Vec2& to, const Color& color) override;
    void leftOut(const Vec2& at) override;
    /// Where marks were left out, as they would be no more than dots: of those that are near each other, one.
    const std::vector<Vec2>& dots() const { return m_dots; }

    /// Chooses the names that will be painted: as many as do not lie on each other, those of a lower rank first, and of
    /// one rank those that were drawn first. Takes as long as there are names.
    void placeNames(const QFontMetricsF& metrics, const std::function<int(std::uint64_t user)>& rank);
    /// Whose names have been chosen; ascending.
    const std::vector<std::uint64_t>& named() const { return m_named; }
    bool leavesOutNames() const { return m_leavesOutNames; }

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

    struct Name {
        QPointF at;
        QString text;
        Color color;
        std::uint64_t user = 0;
    };

    bool sees(const Aabb& box) const { return m_visible.overlaps(box); }
    /// Of so many marks that smooth ones would take five times as long, and nobody would see it.
    bool isCrowd() const { return m_marks > 1500; }
    Batch& batch(const Color& color);
    void paintFillings(QPainter& painter, const Batch& batch) const;
    void paintDiscs(QPainter& painter, const Batch& batch) const;
    void paintLines(QPainter& painter, const Batch& batch) const;
    void paintTexts(const Stage& stage) const;

    Aabb m_visible; // logical pixels
    std::vector<Batch> m_batches;
    std::size_t m_last = 0; // used last
    std::size_t m_marks = 0;
    std::vector<Vec2> m_dots;
    std::vector<bool> m_dotted; // squares of the view that have one
    std::vector<Text> m_texts;
    std::vector<Name> m_names; // of which none has been chosen yet
    std::vector<std::uint64_t> m_named;
    bool m_leavesOutNames = false;
};

} // namespace spacetow
