#pragma once
// From the level to the layout of its file.

#include "core/level/json_text.h"
#include "core/level/level.h"

namespace spacetow {

JsonText writtenLevel(const Level& level);
/// The entries of the tag table that are among `which` and not as those of a table without names, and those of
/// `always`.
JsonText writtenTags(const TagTable& tags, TagMask which, TagMask always = {});
/// Tags are spelled by the names in `tags`.
JsonText writtenObject(const Object& object, const TagTable& tags);

} // namespace spacetow
