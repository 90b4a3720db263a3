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

/// Valid for the level it was made from.
class Outlines {
  public:
    explicit Outlines(const Level& level) : m_objects(level.objects) {}
    /// Empty for a connector that has lost an end.
    Outline of(const Object& object) const;

  private:
    const ObjectList& m_objects;
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
