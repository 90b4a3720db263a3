#pragma once
// A ruler in metres along the top or the left of the canvas: ticks at round distances, a mark where the pointer is and
// a bar as long as the selection. It repaints only what changes. Dragging out of it is the canvas's affair.

#include "core/math/aabb.h"
#include "editor/canvas/guide_source.h"
#include "editor/editing/viewport.h"

#include <optional>

namespace spacetow {

/// Which ticks a ruler has: `major` ones carry numbers, each parted into `parts`.
struct RulerSteps {
    double major = 1; // m; 1, 2 or 5 times a power of ten
    int parts = 10;
    int decimals = 0; // that the numbers need
};
/// The closest steps whose numbers are at least `leastPixels` apart.
RulerSteps rulerSteps(double pixelsPerMetre, double leastPixels);

class Ruler : public GuideSource {
    Q_OBJECT

  public:
    explicit Ruler(Qt::Orientation orientation, QWidget* parent = nullptr);

    /// How thick rulers are with the font of the widget, in pixels.
    static int thickness(const QWidget& widget);
    static QFont numberFont(const QWidget& widget);

    void setView(const Viewport& view);
    void setPointer(std::optional<Vec2> world);
    void setExtent(const Aabb& selected); // empty for none

    Qt::Orientation orientation() const { return m_orientation; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    bool isFlat() const { return m_orientation == Qt::Horizontal; }
    double length() const { return isFlat() ? width() : height(); }
    /// Along the ruler, in pixels from its start.
    double toPixel(double metres) const;
    double toMetre(double pixel) const;
    double along(const Vec2& world) const { return isFlat() ? world.x() : world.y(); }
    QRect strip(double from, double to) const;
    void paintTicks(QPainter& painter, const QRect& where) const;
    void paintNumber(QPainter& painter, double at, const QString& text) const;

    Qt::Orientation m_orientation;
    Viewport m_view;
    std::optional<double> m_pointer;                   // px
    std::optional<std::pair<double, double>> m_extent; // m
};

} // namespace spacetow
