#pragma once
// A side of a polygon becomes two in one line, one of which may be inside of a floor. Metres.

#include "core/geometry/part.h"

namespace spacetow {

/// A new corner on the face, `at` metres from its start; the corners behind it move up by one. Expects that there is
/// room for one more.
void insertCorner(ConvexPart& part, int face, double at);

} // namespace spacetow
