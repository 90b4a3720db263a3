#pragma once
// One-way walls let through what comes from behind them, as one-way platforms do. Where a part is does not tell that:
// in the depth of a wall there is what comes from behind and what was put there, which is pushed out in front. A body
// passes as a whole, however many parts it has.

#include "core/geometry/collide.h"

#include <span>

namespace spacetow {

/// How far a body has come on its way through a one-way wall from behind.
enum class Passage : std::uint8_t {
    None,    // it is beside the wall, in front of it or within its depth, or the wall is none that lets through
    Behind,  // its centre of mass is over the wall and farther behind the face than the depth
    Passing, // it was behind, and is not in front of the wall altogether: the face is open for it
    Passed,  // it was between when it was last looked at, and is no longer
};

/// A body at a wall.
struct PassingBody {
    std::span<const Part> parts; // all that it has, about its centre of mass
    Transform pose;              // of the body, in the coordinates of the wall
};

/// Whether what comes from behind may pass.
inline bool letsThrough(const WallPart& wall) {
    return wall.oneWay && wall.depth < noBack;
}

/// The passage of a body after what it was when it was last looked at. It has to be looked at before it can come from
/// behind the depth to within it. To be over a wall that another continues straight or hollow is to be over that, too.
Passage nextPassage(Passage before, const WallPart& wall, const PassingBody& passing);

/// The same for an edge whose free side this is.
Passage nextPassage(Passage before, const WallSide& side, const PassingBody& passing);

/// Whether the face is open or to be looked at again at once.
inline bool isChanging(Passage passage) {
    return passage == Passage::Passing || passage == Passage::Passed;
}

/// Whether the body is on its way through: between, or behind with something that has come to within the depth.
bool isOnItsWay(Passage before, const WallPart& wall, const PassingBody& passing);

/// Whether it was on its way when it was last looked at, and is out.
bool hasJustLeft(Passage before, const WallPart& wall, const PassingBody& passing);

/// Whether the passage is none, as nearly always: what has its centre of mass in front was never behind.
inline bool isNoPassage(Passage before, const WallPart& wall, const Vec2& center) {
    return !letsThrough(wall) || (before == Passage::None && cross(wall.b - wall.a, center - wall.a) >= 0);
}
inline bool isNoPassage(Passage before, const WallSide& side, const Vec2& center) {
    return side.depth == noBack || (before == Passage::None && side.above(center) >= 0);
}

/// Whether one edge continues the other, and how; both in the same coordinates.
enum class EdgeJoint : std::uint8_t { None, Hollow, Other };
EdgeJoint jointOf(const WallPart& a, const WallPart& b);

/// Contact of two parts of which one is a wall whose face is open for the other: only its free ends stop that.
/// Otherwise as collide().
Manifold collideOpenWall(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB, double margin);

} // namespace spacetow
