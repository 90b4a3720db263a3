#pragma once
// What an object looks like on the canvas, in world coordinates: for picking, for the ghost of what is being placed,
// and for the middle about which a selection turns. A group looks like nothing: its members do.

#include "core/geometry/shape.h"
#include "core/level/object_geometry.h"

#include <utility>
#include <vector>

namespace spacetow {

struct OutlinePath {
    std::vector<Vec2> points; // world; at least one
    bool closed = false;
    bool filled = false; // its inside belongs to the object
};

struct Outline {
    std::vector<OutlinePath> paths;
    std::vector<Circle> discs; // world, filled
};

/// Knows where the bodies are that connectors join, which would be a search for each connector otherwise.
/// Valid for the level it was made from.
class Outlines {
  public:
    /// Linear in the number of objects.
    explicit Outlines(const Level& level);
    /// Empty for a connector that has lost an end.
    Outline of(const Object& object) const;

  private:
    const Transform* find(Key key) const;

    std::vector<std::pair<Key, Transform>> m_ends; // ascending by key
};

Aabb boundsOf(const Outline& outline);
/// 0 inside what is filled; infinite for an empty outline.
double distanceTo(const Outline& outline, const Vec2& point);
bool touches(const Outline& outline, const Aabb& box);

struct PointSum {
    Vec2 sum{0, 0};
    int count = 0;
};
/// Over all corners and centres. Their mean turns with the outline, as the middle of its bounds does not.
PointSum pointsOf(const Outline& outline);

} // namespace spacetow
