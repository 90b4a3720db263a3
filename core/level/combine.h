#pragma once
// Union, difference and intersection of bodies made of polygons.

#include "core/base/result.h"
#include "core/geometry/polygon_booleans.h"
#include "core/level/level.h"

#include <span>

namespace spacetow {

struct CombinedBodies {
    Level level;
    Key key = 0; // of the body that is left
};

/// The body drawn first takes the shape and keeps all else; the others go, and with them the connectors that they
/// hold. The difference is the first without the others. Groups stand for the bodies in them. What is locked is left
/// out. Codes: "combine-too-few", "combine-no-polygon" (name of the body), "combine-unnamed-no-polygon", "combine-too-far", "combine-empty",
/// "combine-not-simple".
Result<CombinedBodies> combinedBodies(Level level, std::span<const Key> keys, PolygonBoolean how);

} // namespace spacetow
