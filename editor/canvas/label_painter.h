#pragma once
// Words on a plate beside a point of the canvas: lengths and angles, names of what was snapped to.

#include "editor/canvas/stage.h"

#include <QRectF>
#include <QString>

#include <vector>

namespace spacetow {

/// Above leaves room below for the other: measures stand above the pointer, names below.
enum class LabelSide { Above, Below };

/// The labels of one frame: each is kept inside the view, and clear of those painted before as long as there is room.
class LabelPainter {
  public:
    explicit LabelPainter(const Stage& stage) : m_stage(stage) {} // which outlives the labels
    /// One line or several; beside the point or, where another label is, as near to it as there is room.
    void paint(const Vec2& at, const QString& words, LabelSide side = LabelSide::Above);
    /// The plates so far, pixels.
    const std::vector<QRectF>& plates() const { return m_plates; }

  private:
    QRectF placed(const QPointF& at, const QSizeF& size, LabelSide side) const;

    const Stage& m_stage;
    std::vector<QRectF> m_plates;
};

/// On a plate in the middle of the view, in as many lines as it takes.
void paintInMiddle(const Stage& stage, const QString& words);

} // namespace spacetow
