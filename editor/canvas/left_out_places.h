#pragma once
// Where overlays have left something out of a picture that is painted part by part.

#include "editor/canvas/left_out.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/picture_layer.h"

#include <QRegion>

#include <vector>

namespace spacetow {

class LeftOutPlaces {
  public:
    /// What the picture does not keep: what is out of the frame, and in the region, which is painted anew.
    void forget(const Frame2D& frame, const QRegion& region);
    void add(const OverlayGaps& gaps);
    LeftOut in(const Viewport& view) const;

  private:
    std::vector<Vec2> m_dots; // world
    bool m_names = false;     // which are painted anew all together
};

} // namespace spacetow
