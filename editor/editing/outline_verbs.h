#pragma once
// What the outliner does to objects that it names itself: put into groups and order, renamed, shown, locked. As in
// verbs.h each gives the finished edit, or nothing when there is nothing to do.

#include "core/level/groups.h"
#include "editor/editing/tool.h"

#include <optional>
#include <span>
#include <string>

namespace spacetow {

/// The objects, with the group entered that holds all of them.
Selection selectionOf(const Level& level, std::vector<Key> keys);

/// Whether `regroup` could put something of it there: not into what is locked, or what is in itself.
bool mayRegroup(const Level& level, std::span<const Key> keys, Key parent);
/// What is locked stays. The objects are selected.
std::optional<FinishedEdit> regroup(const Edit& edit, std::span<const Key> keys, const ObjectPlace& place);

std::optional<FinishedEdit> renameObject(const Edit& edit, Key key, std::string name);
/// Of groups alone; nothing takes the colour away.
std::optional<FinishedEdit> colorGroup(const Edit& edit, Key key, std::optional<std::uint32_t> color);
/// What is hidden by it leaves the selection, members of groups included.
std::optional<FinishedEdit> showObjects(const Edit& edit, std::span<const Key> keys, bool visible);
/// The selection stays as it is.
std::optional<FinishedEdit> lockObjects(const Edit& edit, std::span<const Key> keys, bool locked);

} // namespace spacetow
