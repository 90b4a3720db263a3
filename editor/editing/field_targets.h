#pragma once
// Which objects and shapes a field that is entered goes to.

#include "core/level/field_edits.h"
#include "editor/editing/selection.h"

#include <vector>

namespace spacetow {

/// The shapes that selected nodes belong to, ascending. Of an object without selected nodes all shapes are meant.
std::vector<ShapeRef> shapesOf(const Selection& selection);

/// Of the object, out of those above.
std::vector<int> shapesOf(std::span<const ShapeRef> shapes, Key key);

} // namespace spacetow
