#pragma once
// The geometry of every kind of object: where it is, what it covers, and what moving or mapping it means. Each
// function visits all kinds by name, so that a new kind does not compile until it is known here. World coordinates, m.

#include "core/level/level.h"
#include "core/math/aabb.h"
#include "core/math/affine.h"
#include "core/math/transform.h"

#include <array>
#include <optional>

namespace spacetow {

/// Where the local origin is; nothing for the finish, connectors and groups.
std::optional<Transform> poseOf(const ObjectData& data);
inline std::optional<Transform> poseOf(const Object& object) {
    return poseOf(object.data);
}
/// The point by which an object snaps: its origin, or the first end of the finish; nothing for connectors and groups.
std::optional<Vec2> placeOf(const ObjectData& data);

/// Bounds of all but connectors and groups, which others place; of walls without their depth. Empty for those two.
Aabb ownBounds(const ObjectData& data);

/// Where the connector's ends are; nothing when it has lost one of its bodies.
std::optional<std::array<Vec2, 2>> endsOf(const ConnectorObject& connector, const ObjectList& objects);

/// Connectors and groups have no place of their own and stay.
void move(ObjectData& data, const Vec2& delta);
/// Mapped by any affine map with a determinant other than zero. Bodies keep being bodies: what is no turn of theirs
/// goes into their shapes, circles stay circles of the same area, and where left and right change places the order of
/// vertices is reversed, so that walls stay solid on the same side of what they enclose. The ship keeps its shape.
/// Velocities stay as they are.
void transform(ObjectData& data, const Affine& map);
/// What `transform` does to the coordinates of a body: connectors' anchors go with it.
Affine localMap(const BodyObject& body, const Affine& map);

/// Turns the order of vertices round: one-way walls are then solid from the other side. A closed chain keeps its first
/// vertex, so that turning it twice is no change.
void reverse(std::vector<Vec2>& vertices, bool closed);

} // namespace spacetow
