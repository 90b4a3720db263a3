#pragma once
// One-way walls let through what comes from behind them, as one-way platforms do. Where a part is does not tell that:
// in the depth of a wall there is what comes from behind and what was put there, which is pushed out in front.

#include "core/geometry/collide.h"

namespace spacetow {

/// How far a part has come on its way through a one-way wall from behind.
enum class Passage : std::uint8_t {
    None,    // it is beside the wall, in front of it or within its depth, or the wall is none that lets through
    Behind,  // its centre is over the wall and farther behind the face than the depth
    Between, // it was behind, and is not in front of the wall altogether: the face is open for it
};

/// The passage of two parts, in either order, after what it was when they were last looked at. They have to be looked
/// at before they can come from behind the depth to within it.
Passage nextPassage(Passage before, const Part& a, const Transform& poseA, const Part& b, const Transform& poseB);

/// The same for a circle at a one-way wall, whose free side this is; both in the same coordinates.
Passage nextPassage(Passage before, const WallSide& side, const Circle& circle);

/// Contact of two parts of which one is a wall whose face is open for the other: only its free ends stop that.
/// Otherwise as collide().
Manifold collideOpenWall(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB, double margin);

} // namespace spacetow
