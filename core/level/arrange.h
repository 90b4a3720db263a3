#pragma once
// Arranging objects: which of them may be changed at all, mirroring, alignment, order. Edits as in edits.h: free
// functions Level → Level named by past participle. World coordinates, metres.

#include "core/level/level.h"
#include "core/math/aabb.h"

#include <span>
#include <vector>

namespace spacetow {

/// The keys with all that is in the groups among them, but without what is locked, and without groups in which
/// something is: what moving, changing or removing these keys may touch. Ascending.
std::vector<Key> unlockedKeys(const Level& level, std::span<const Key> keys);

/// Bounds of the objects, groups by their members, but without connectors, which lie where their bodies are.
Aabb placedBounds(const Level& level, std::span<const Key> keys);

/// Mirrored about the middle of their bounds. One-way walls stay solid on the same side of what they enclose.
enum class FlipAxis : std::uint8_t { Horizontal, Vertical };
Level flipped(Level level, std::span<const Key> keys, FlipAxis axis);

/// Moved so that this side, or the middle, of each is where that of all of them together is. Groups go as a whole,
/// and so in everything below; what is locked, and what has no place of its own, stays and does not count.
enum class AlignTo : std::uint8_t { Left, Right, Top, Bottom, MiddleAcross, MiddleUpright };
Level aligned(Level level, std::span<const Key> keys, AlignTo side);

/// What comes to be evenly spaced between the outermost two: the left or lower edges, the middles, or the gaps.
enum class Spread : std::uint8_t { Edges, Middles, Gaps };
struct Spacing {
    Spread what = Spread::Gaps;
    bool across = true; // else upwards

    bool operator==(const Spacing&) const = default;
};
/// Needs three of them to change anything.
Level distributed(Level level, std::span<const Key> keys, const Spacing& spacing);

/// The drawing order. Forward and backward pass the next object that overlaps; what is reordered keeps its own order.
enum class OrderTo : std::uint8_t { Front, Forward, Backward, Back };
Level reordered(Level level, std::span<const Key> keys, OrderTo where);

/// All that is in none of the keys is hidden, but not the connectors between them.
Level isolated(Level level, std::span<const Key> keys);

} // namespace spacetow
