#pragma once
// From the level to the layout of its file.

#include "core/level/json_text.h"
#include "core/level/level.h"

namespace spacetow {

JsonText writtenLevel(const Level& level);
/// Tags are spelled by the names in `tags`.
JsonText writtenObject(const Object& object, const TagTable& tags);

} // namespace spacetow
