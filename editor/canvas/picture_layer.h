#pragma once
// A picture of a part of the world that is kept from frame to frame: shifted when the view is, painted anew only where
// something has changed. Transparent where nothing was painted. Device pixels unless said otherwise.

#include "editor/canvas/stage.h"

#include <QImage>
#include <QRegion>

#include <functional>
#include <vector>

namespace spacetow {

/// The view, moved by less than half a device pixel so that the world's origin lies on the corner of one. Pictures of
/// two such views of the same scale can be put beside each other.
Viewport alignedToPixels(const Viewport& view, double pixelRatio);

/// A view and what it is painted on; the view is aligned.
struct Frame2D {
    Viewport view;
    double pixelRatio = 1; // device pixels a logical one

    QSize deviceSize() const;
    /// Where the box lies, with room for pens, clipped to the frame.
    QRect deviceRect(const Aabb& world, double spareMetres) const;
    /// By how many device pixels the world has moved from `other` to this one. Of the same scale.
    QPoint movedFrom(const Frame2D& other) const;
    /// With `pixels` more on each side.
    Frame2D grown(int pixels) const;
    /// Where the whole of `other` lies in this one. Of the same scale.
    QRect rectOf(const Frame2D& other) const;
    /// A rectangle of it as a frame of its own.
    Frame2D part(const QRect& device) const;
    /// The world in a rectangle of the frame.
    Aabb worldIn(const QRect& device) const;
    QRect all() const { return {QPoint(0, 0), deviceSize()}; }

    bool operator==(const Frame2D& other) const {
        return view.center == other.view.center && view.scale == other.view.scale && view.size == other.view.size &&
               pixelRatio == other.pixelRatio;
    }
};

class PictureLayer {
  public:
    using Paint = std::function<void(const Stage&)>;

    bool isValid() const { return m_valid; }
    void discard() { *this = {}; }
    const Frame2D& frame() const { return m_frame; }
    /// Whether nothing was ever painted into it.
    bool isBlank() const { return m_image.isNull(); }

    /// Whether what it shows can be shifted to the frame.
    bool canShiftTo(const Frame2D& frame) const;
    /// What of the frame it does not show yet.
    QRegion missingIn(const Frame2D& frame) const;
    /// Takes the frame over; what is in both stays.
    void shiftTo(const Frame2D& frame);
    /// Shows nothing, and that rightly.
    void erase() {
        m_image = {};
        m_used = {};
        m_tiles.clear();
    }
    /// The same, but what it was painted into is kept, to be painted into again.
    void wipe();
    /// Nothing is to be seen any more in the rectangle of the image.
    void cut(const QRect& device);
    /// Erases the region and paints it, strip by strip, in a view of the strip alone.
    void paint(const QRegion& region, const Theme& theme, const Paint& paint);

    /// Where it belongs in the frame; `moved` is by how much what it shows has moved meanwhile, in the world. Of
    /// another scale it is drawn larger or smaller.
    void draw(QPainter& painter, const Frame2D& frame, const Vec2& moved = {0, 0}) const;

    /// The parts of the image that are drawn: outlines leave most of it transparent.
    std::vector<QRect> spots() const;

  private:
    int columns() const;
    void lookAt(const QRect& device);

    QImage m_image;
    QRect m_used;              // elsewhere the image is transparent
    std::vector<bool> m_tiles; // row by row, whether anything is seen in it
    Frame2D m_frame;
    bool m_valid = false;
};

} // namespace spacetow
