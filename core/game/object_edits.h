#pragma once
// What is different between the level that a session runs and the same level after an edit, as far as the world is
// concerned. Values are compared, so that a level that was read from a file is taken over like the one that was edited.

#include "core/level/level.h"

#include <vector>

namespace spacetow {

/// Null where there is, or was, no such object.
struct ObjectEdit {
    const Object* before;
    const Object* after;
};

/// Of all objects whose data differ: first those that were removed, then the others in the order of the edited level.
/// The pointers are into the two levels.
std::vector<ObjectEdit> editsBetween(const Level& before, const Level& after);

/// Of the objects that were added or changed, those which lint keeps out of the world; sorted.
std::vector<Key> unbuildable(const Level& level, const std::vector<ObjectEdit>& edits);

template <class T>
const T* as(const Object* object) {
    return object == nullptr ? nullptr : std::get_if<T>(&object->data);
}

} // namespace spacetow
