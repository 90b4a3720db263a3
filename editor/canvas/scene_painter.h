#pragma once
// Paints a level as it is edited, and a snapshot as it is played. Only what is in view costs time. Neither clears the
// background; both leave the painter as they found it.

#include "core/game/snapshot.h"
#include "core/level/level.h"
#include "editor/canvas/stage.h"
#include "editor/canvas/wall_painter.h"
#include "editor/editing/selection.h"

#include <vector>

namespace spacetow {

class DiscStamps;

/// Which objects of a level are painted: all, or all but some, or only some; by their places, ascending.
struct PaintedPart {
    const std::vector<int>* without = nullptr;
    const std::vector<int>* only = nullptr;
};

/// All objects, walls first, then the selected ones' outlines on top.
void paintLevel(const Stage& stage, const Level& level, const Selection& selection);

/// Matter behind closed walls that have no back.
void paintRock(const Stage& stage, const Level& level, const PaintedPart& part);
/// Everything else, for layers that are painted apart.
void paintObjects(const Stage& stage, const Level& level, const PaintedPart& part);
/// Outlines of the selected objects, with a dot at each vertex.
void paintSelection(const Stage& stage, const Level& level, const Selection& selection);
/// The outline of what a click would select: an object, or a group with its members.
void paintHovered(const Stage& stage, const Level& level, Key hovered);
/// Whether so much of that outline is in view that nobody may wait for it.
bool isLongToHover(const Level& level, Key hovered, const Aabb& view);

/// Statics, kinematics, dynamics, connectors.
void paintSnapshot(const Stage& stage, const Snapshot& snapshot);

/// The same in two parts, of which the first may be kept as long as nothing static changes.
Ground groundOf(const BodyPictures& statics);
void paintStatics(const Stage& stage, const BodyPictures& statics, const Ground& ground);
/// Small discs, where there are many, with the stamps that are given.
void paintMoving(const Stage& stage, const Snapshot& snapshot, DiscStamps* stamps = nullptr);

} // namespace spacetow
