#pragma once
// What clicks mean where objects are in groups: at the top they mean the outermost group, in a group that was entered
// its members, and what lies outside leaves it.

#include "editor/editing/document.h"
#include "editor/editing/input.h"

#include <optional>
#include <vector>

namespace spacetow {

/// How near the pointer must be to something to mean it, in pixels.
constexpr double grabPixels = 6;

struct GroupPick {
    Key key = 0;     // what a click selects
    Key entered = 0; // the group whose members clicks then mean
    Key object = 0;  // what lies under the pointer: the same, or something in it
};

/// What lies under the pointer, each once; members of the entered group come first. What is selected already counts
/// as a whole, so that it can be dragged.
std::vector<GroupPick> pickedMembers(const Edit& edit, const Pointer& pointer);
/// The objects as clicks could select them in the entered group: members, each once; what is outside is left out.
std::vector<Key> membersOf(const Edit& edit, const std::vector<Key>& objects);

/// The object by itself, though it is in groups: the innermost of them is entered.
Selection directly(const Edit& edit, Key object);
/// Into the group, with that in it selected in which `object` lies; nothing when `group` is none.
std::optional<Selection> entering(const Edit& edit, Key group, Key object);
/// Out of the group that was entered, which is then selected; nothing when none was.
std::optional<Selection> leaving(const Edit& edit);

} // namespace spacetow
