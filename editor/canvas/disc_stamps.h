#pragma once
// Discs of bodies as pictures that are made once and put where they are wanted: where there are thousands of balls,
// painting each as a path takes longer than a frame lasts. They stand within an eighth of a device pixel of where they
// should.

#include "editor/canvas/body_painter.h"

#include <QPixmap>

#include <cstdint>
#include <unordered_map>

namespace spacetow {

class DiscStamps {
  public:
    static constexpr double largest = 24; // px, of a radius

    /// As paintDisc does it, for radii up to `largest`; pixels.
    void paint(const Stage& stage, const QPointF& center, double radius, const BodyStyle& style);
    /// How many pictures there are.
    std::size_t size() const { return m_stamps.size(); }

  private:
    std::unordered_map<std::uint32_t, QPixmap> m_stamps;
    const Theme* m_theme = nullptr; // in whose colours they are
    double m_ratio = 1;             // device pixels a pixel
};

} // namespace spacetow
