#pragma once
// A map of Tiled as a drawing. Units are the map's pixels, a tile is usually a metre; the lower left corner of the map
// is the origin, of an infinite one the upper left of its first tile. Tiles, pictures and text are reported.

#include "editor/exchange/drawing.h"
#include "editor/exchange/tiled_map.h"

namespace spacetow {

/// The notes are left in the report.
Drawing tiledDrawing(const TiledMap& map, Report& report);

} // namespace spacetow
