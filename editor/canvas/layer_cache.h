#pragma once
// Keeps the picture of what does not change from one frame to the next: background, grid and the objects that no
// gesture is moving. Panning shifts it and paints only the strips that come into view.

#include "core/level/level.h"
#include "editor/canvas/overlay_flags.h"
#include "editor/canvas/stage.h"
#include "editor/editing/selection.h"

#include <QPixmap>
#include <QRegion>

#include <memory>
#include <unordered_set>

namespace spacetow {

class LayerCache {
  public:
    struct Request {
        Viewport view;
        std::shared_ptr<const Level> level;
        Selection selection;   // outlined
        OverlayFlags overlays; // of all objects, moving ones included
        double gridStep = 0;   // m; 0 for no grid
        double pixelRatio = 1; // device pixels a logical one
        Shade shade = Shade::Dark;
    };

    /// The picture for the request, painted anew only where it must be. Objects marked as moving are not in it.
    const QPixmap& layer(const Request& request);

    /// Leaves out from now on the objects in which `after` differs from `before`, and the connectors that hang on
    /// them. Gives up, so that nothing is moving, where rock would have to be painted under what stays.
    void setMoving(const Level& before, const Level& after);
    void clearMoving();
    bool isMoving(Key key) const { return m_moving.contains(key); }
    bool hasMoving() const { return !m_moving.empty(); }

  private:
    bool isCurrent(const Request& request) const;
    bool shiftTo(const Request& request);
    void paint(const QRegion& where);

    QPixmap m_pixmap;
    Request m_painted;
    std::unordered_set<Key> m_moving;
    bool m_valid = false;
};

} // namespace spacetow
