#pragma once
// Tags of objects that come from another level. Tags are one by their names: what the level has is taken, what it does
// not have is made in it.

#include "core/base/result.h"
#include "core/level/level.h"

#include <vector>

namespace spacetow {

/// Objects as they were in another level, and what their tags are called there.
struct ForeignObjects {
    std::vector<Object> objects;
    TagTable tags;
};

struct AdoptedObjects {
    Level level; // with the tags that were made
    std::vector<Object> objects;
    /// What the user should know. Codes: "tags-made" (names), "tag-renamed" (name, name here), "tags-dropped" (names).
    std::vector<Error> notes;
};

/// A tag without a name becomes one that is free here. The game's own tags are known by their index when no tag here
/// has their name.
AdoptedObjects withTagsAdopted(Level level, ForeignObjects foreign);

} // namespace spacetow
