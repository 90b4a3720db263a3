#pragma once
// Groups and layers: which objects are in which, and what that does to visible and locked.

#include "core/level/level.h"

#include <span>
#include <utility>
#include <vector>

namespace spacetow {

/// Who is in whom. Objects whose parent is missing, is no group or leads round in a circle count as being at the top;
/// lint reports them. Valid for the level it was made from.
class GroupTree {
  public:
    explicit GroupTree(const Level& level);

    /// The group that the object is in, or null.
    const Object* parentOf(const Object& object) const;
    /// Whether `object` is in `group`, directly or not.
    bool isWithin(const Object& object, Key group) const;
    /// The group in `entered` (0 for the top) through which the object is reached, or the object itself when it is
    /// directly in `entered`; null when it is not in `entered` at all.
    const Object* memberOf(Key entered, const Object& object) const;
    /// Of itself and of all groups it is in.
    bool isVisible(const Object& object) const;
    bool isLocked(const Object& object) const;
    bool hasGroups() const { return !m_groups.empty(); }

  private:
    const Object* groupOf(Key key) const;

    std::vector<std::pair<Key, const Object*>> m_groups; // ascending by key, those in a circle left out
};

bool isLayer(const Object& object);
/// The keys and those of all that is in the groups among them, ascending.
std::vector<Key> withMembers(const Level& level, std::span<const Key> keys);
/// What clicks could select after `entered` has been entered (0: the top): its members, at the top also those of
/// layers; nothing that is hidden or locked, and no layer itself. In the order of the level.
std::vector<Key> selectableKeys(const Level& level, Key entered);

/// A new group, `group.key` being fresh, with the objects as its members, in the group that the first of them is in.
/// It comes to stand before the first of them. Members of groups that are grouped themselves stay in those, and layers
/// at the top.
Level grouped(Level level, std::span<const Key> keys, Object group);
/// The groups go, their members move to where these were. Other keys are ignored.
Level ungrouped(Level level, std::span<const Key> keys);
/// The objects become members of `parent` (0 for the top). They are put, groups with all that is in them, before the
/// object `before` in the drawing order, or on top of what is in the parent when it is 0, and keep their order among
/// each other. What would come to be in itself stays where it is, and a layer at the top.
struct ObjectPlace {
    Key parent = 0;
    Key before = 0;
};
Level regrouped(Level level, std::span<const Key> keys, const ObjectPlace& place);

Level withVisible(Level level, std::span<const Key> keys, bool visible);
Level withLocked(Level level, std::span<const Key> keys, bool locked);

} // namespace spacetow
