#pragma once
// What objects are called on the screen.

#include "core/level/level.h"

#include <QString>

namespace spacetow {

/// "Wall", "Ship", …
QString kindName(const Object& object);
/// Its own name, else what kind of thing it is.
QString displayName(const Object& object);

} // namespace spacetow
