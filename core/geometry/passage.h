#pragma once
// One-way walls let bodies pass from behind, as one-way platforms do. The position of a body does not tell whether it
// passes: a body within the depth of a wall has either come from behind, or was put there and is pushed out in front.
// So each pair remembers its passage. A body passes as a whole, however many parts it has. Metres.

#include "core/geometry/collide.h"

#include <span>

namespace spacetow {

/// The state of a body on its way through a one-way wall from behind.
enum class Passage : std::uint8_t {
    None,    // the body is beside the wall, in front of it or within its depth; or the wall never opens
    Behind,  // the centre of mass is over the wall and farther behind the face than the depth
    Passing, // the body was behind, and is not yet wholly in front: the face is open for it
    Passed,  // it was passing at the last update, and no longer is
};

/// A body near a one-way wall.
struct PassingBody {
    std::span<const Part> parts; // all parts of the body, about its centre of mass
    Transform pose;              // of the body, in the coordinates of the wall
};

/// Whether the wall lets bodies pass from behind: an edge of finite depth.
inline bool letsThrough(const WallPart& wall) {
    return wall.oneWay && wall.depth < noBack;
}

/// The passage of a body, from the passage `before` at the last update. Call it in every iteration in which the body
/// may enter the depth from behind. A wall includes its neighbours at smooth joints (see WallEnd).
Passage nextPassage(Passage before, const WallPart& wall, const PassingBody& passing);

/// The same for an edge, given by its free side.
Passage nextPassage(Passage before, const WallSide& side, const PassingBody& passing);

/// Whether the face is open, or was until the last update: the passage has to be updated in the next iteration.
inline bool isChanging(Passage passage) {
    return passage == Passage::Passing || passage == Passage::Passed;
}

/// Whether the body is on its way through: passing, or behind with a point of it within the depth.
bool isOnItsWay(Passage before, const WallPart& wall, const PassingBody& passing);

/// Whether the body was passing at the last update, and no longer is.
bool hasJustLeft(Passage before, const WallPart& wall, const PassingBody& passing);

/// A quick test whether the passage is None, as it nearly always is: the wall never opens, or the centre of mass is in
/// front and the body was not behind before.
inline bool isNoPassage(Passage before, const WallPart& wall, const Vec2& center) {
    return !letsThrough(wall) || (before == Passage::None && cross(wall.b - wall.a, center - wall.a) >= 0);
}
inline bool isNoPassage(Passage before, const WallSide& side, const Vec2& center) {
    return side.depth == noBack || (before == Passage::None && side.above(center) >= 0);
}

/// Whether one edge continues the other at a hollow joint, at another joint, or not at all; both in the same
/// coordinates.
enum class EdgeJoint : std::uint8_t { None, Hollow, Other };
EdgeJoint jointOf(const WallPart& a, const WallPart& b);

/// As collide(), for a wall that is open for the other part: only the free ends of the wall collide.
Manifold collideOpenWall(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB, double margin);

} // namespace spacetow
