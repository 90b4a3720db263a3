#pragma once
// What the painters paint on: a painter in logical pixels, the view that maps the world to it, and the colours.
// Needs no window, so that the command line renders the same picture to a file.

#include "editor/canvas/theme.h"
#include "editor/editing/viewport.h"

#include <QPainter>
#include <QPolygonF>

#include <span>

namespace spacetow {

/// The references must outlive the stage; nothing is owned.
struct Stage {
    QPainter& painter;
    const Viewport& view;
    const Theme& theme;

    QPointF at(const Vec2& world) const {
        const Vec2 p = view.toScreen(world);
        return {p.x(), p.y()};
    }
    QPolygonF at(std::span<const Vec2> world) const {
        QPolygonF points;
        points.reserve(static_cast<qsizetype>(world.size()));
        for (const Vec2& point : world) {
            points << at(point);
        }
        return points;
    }
    double pixels(double metres) const { return metres * view.scale; }
    /// Whether anything of the box can be seen, with some pixels to spare for pens and marks.
    bool sees(const Aabb& box) const { return view.visible().grown(8 * view.pixel()).overlaps(box); }
};

/// Leaves the painter as it was found; in between edges are smooth and nothing is filled.
class SavedPainter {
  public:
    explicit SavedPainter(QPainter& painter) : m_painter(painter) {
        m_painter.save();
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.setBrush(Qt::NoBrush);
    }
    ~SavedPainter() { m_painter.restore(); }
    SavedPainter(const SavedPainter&) = delete;
    SavedPainter& operator=(const SavedPainter&) = delete;

  private:
    QPainter& m_painter;
};

/// A pen with round ends; its width is in logical pixels.
QPen stroke(const QColor& color, double width, Qt::PenStyle style = Qt::SolidLine);

/// Lengths in logical pixels.
struct Dashes {
    double dash, gap;
};

/// The dashes of a line that are in view, with the painter's pen, which is a solid one with flat ends. Where they lie
/// does not depend on the view, so that parts of a picture that are painted one after the other fit together.
void paintDashed(const Stage& stage, const Vec2& a, const Vec2& b, const Dashes& dashes);

} // namespace spacetow
