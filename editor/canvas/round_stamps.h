#pragma once
// Many circles in one call: those of about the same size are painted once, and put where they are wanted.

#include <QPainter>
#include <QRectF>

#include <span>

namespace spacetow {

/// With the painter's pen and brush. Where there are many of a size, they stand and end within half a device pixel of
/// where they should. The painter neither turns nor scales.
void stampEllipses(QPainter& painter, std::span<const QRectF> boxes);

} // namespace spacetow
