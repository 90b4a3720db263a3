#pragma once
// Small pictures of whole levels, for lists of files and for the minimap. Needs no window, and may be made by any
// thread.

#include "core/level/level.h"
#include "editor/canvas/palette.h"
#include "editor/editing/viewport.h"

#include <QImage>
#include <QSize>

namespace spacetow {

struct PictureSize {
    QSize logical; // pixels
    double ratio = 1;

    bool operator==(const PictureSize&) const = default;
};

/// What such a picture shows: all of the level.
Viewport pictureView(const Level& level, const QSize& logical);
/// As the drawing board shows it, without the grid.
QImage levelPicture(const Level& level, const PictureSize& size, Shade shade);

} // namespace spacetow
