#pragma once
// The edits that cure what lint finds (see fixes.h): each of one object, by its key, or of one of its shapes. What they
// do not concern stays as it is; a key that is not in the level is ignored.

#include "core/level/field_edits.h"

#include <string_view>

namespace spacetow {

/// The number that follows `name` in a JSON pointer; −1 for none.
int numberAfter(std::string_view pointer, std::string_view name);

/// Points that repeat the one before, in all outlines. What would be too short then stays.
Level withoutRepeats(Level level, Key key);
/// Points on straight ways.
Level withoutIdlePoints(Level level, Key key);
/// Polygons that run clockwise are turned round.
Level anticlockwise(Level level, Key key);
/// Polygons that cross themselves get the same corners in an order in which they do not; spikes go.
Level untangled(Level level, Key key);
/// Solid on its other side.
Level reversedShape(Level level, Key key, int shape);
/// The end of an open chain that is at `from` goes to `to`, another end; a chain that comes to its own end is closed.
Level withEndMoved(Level level, const ShapeRef& chain, const Vec2& from, const Vec2& to);
/// The end of an open chain that is at `from` goes on to `to`; a chain that comes to its own end is closed.
Level withWallAdded(Level level, const ShapeRef& chain, const Vec2& from, const Vec2& to);
/// One-way walls get a depth of at most `thickness` metres, rounded down to centimetres.
Level withDepthAtMost(Level level, const ShapeRef& chain, double thickness);
/// Walls that lie on others go.
Level withoutOverlaps(Level level, Key key);
/// An object goes that is there twice, unless something hangs on it.
Level withoutTwin(Level level, Key key);
/// Shapes that cannot be built go, and with the last one the object.
Level withoutUnbuildable(Level level, Key key);
/// By place: keys that are taken name no single object.
Level withFreshKey(Level level, int index);
Level withoutParent(Level level, Key key);
Level taggedAsWall(Level level, Key key);
/// Ship or payload go to the nearest place where they start free, within 10 m.
Level movedFree(Level level, Key key);

} // namespace spacetow
