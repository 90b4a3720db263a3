#pragma once
// A level as a picture in a file, PNG or SVG: for exporting, and for the command line. Sizes are in pixels.

#include "core/level/level.h"
#include "core/physics/query/overlay_flags.h"
#include "editor/canvas/overlay_palette.h"
#include "editor/editing/viewport.h"

#include <QByteArray>
#include <QSize>
#include <QString>

#include <functional>
#include <optional>

class QPainter;
class QIODevice;

namespace spacetow {

struct Stage;
struct Theme;

constexpr int largestPicture = 16384;           // px, of either side
constexpr double mostPixels = 64 * 1024 * 1024; // of a picture; four bytes each while it is painted

enum class PictureFormat : std::uint8_t { Png, Svg };
/// By the end of a file's name; nothing for another one.
std::optional<PictureFormat> pictureFormat(const QString& path);

struct PictureSpec {
    Viewport view; // its size is that of the picture
    const Theme* theme = nullptr;
    bool transparent = false; // else on the theme's background
    double gridStep = 0;      // m; 0 for no grid
    OverlayFlags overlays;
    OverlayPalette palette; // of the overlays
    QString title;          // of an SVG
};

/// Of this part of the world, at so many pixels a metre; nothing when it has no size or a side would be too large.
std::optional<QSize> pictureSize(const Aabb& box, double pixelsPerMetre);

void paintPicture(QPainter& painter, const Level& level, const PictureSpec& spec);

/// The bytes of a file that shows what `paint` paints on it; empty when there is no memory for it.
QByteArray pictureBytes(PictureFormat format, const PictureSpec& spec, const std::function<void(QPainter&)>& paint);
QByteArray pictureBytes(PictureFormat format, const Level& level, const PictureSpec& spec);

} // namespace spacetow
