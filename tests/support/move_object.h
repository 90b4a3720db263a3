#pragma once
// Another order of a level's objects.

#include "core/level/level.h"

namespace spacetow::test {

/// The object at `from` comes to stand at `to`; those between make room.
inline void moveObject(ObjectList& objects, int from, int to) {
    Object object = objects[from];
    objects.erase(from);
    objects.insert(to, std::move(object));
}

} // namespace spacetow::test
