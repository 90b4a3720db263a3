#pragma once
// Edits as free functions Level → Level, named by past participle; the editor, the command line and the tests call
// the same ones. Keys that are not in the level are ignored.

#include "core/level/bounds.h"
#include "core/level/level.h"
#include "core/math/affine.h"

#include <span>

namespace spacetow {

/// Appends the object. Its key must be fresh (see freshKey). A ship, payload or finish replaces the one that is there,
/// which keeps its key and name.
Level added(Level level, Object object);
/// With a group goes what is in it, and with the last member its group (a layer stays). Also removes the connectors
/// that lose an end.
Level removed(Level level, std::span<const Key> keys);
/// A group moves with all that is in it, here and below.
Level moved(Level level, std::span<const Key> keys, const Vec2& delta);
/// Mapped as object_geometry.h says, connectors' anchors on bodies included. The determinant is not zero.
Level transformed(Level level, std::span<const Key> keys, const Affine& map);
/// Anticlockwise by `radians` about `pivot`. Angles come out in [−π, π]; velocities keep their direction.
Level rotated(Level level, std::span<const Key> keys, const Vec2& pivot, double radians);
/// Turns the solid side of edge chains round, and the winding of lines; other shapes stay.
Level reversed(Level level, std::span<const Key> keys);
/// Where copies go, and what their fresh keys are made from.
struct CopyPlace {
    Vec2 delta{0, 0}; // m, from the originals
    std::uint64_t seed = 0;
    Key parent = 0;           // the group that they come to be in, unless their own is copied too
    bool keepParents = false; // they stay in the groups of their originals instead
};
/// Copies with fresh keys, in the drawing order of the originals and in the same groups; groups are copied with all
/// that is in them, connectors when both ends are copied. Ship, payload and finish are not copied.
/// The keys of the copies come out in `copies`, without those of members of groups that are copied themselves.
Level duplicated(Level level, std::span<const Key> keys, const CopyPlace& place, std::vector<Key>& copies);
/// Objects from elsewhere (the clipboard), treated likewise, but a ship, payload or finish only when
/// the level has none. Connectors follow their ends, and are left out when an end is not among the objects. A layer
/// comes to be at the top, wherever the rest does.
Level pasted(Level level, const std::vector<Object>& objects, const CopyPlace& place, std::vector<Key>& copies);
/// The object with the same key is replaced; the key must exist.
Level withObject(Level level, Object object);
Level renamed(Level level, Key key, std::string name);
Level withTag(Level level, int index, TagInfo info);

} // namespace spacetow
