#pragma once
// What the run shows beside its bodies: the spring by which the mouse holds one, the ways that bodies went, and those
// that they would have gone in futures that were given up.

#include "core/game/course.h"
#include "core/physics/query/debug_draw.h"
#include "editor/canvas/label_painter.h"
#include "editor/canvas/stage.h"

#include <span>

namespace spacetow {

/// From the body to the pointer, with its force.
struct ShownGrab {
    Vec2 anchor{0, 0}; // world
    Vec2 target{0, 0};
    double force = 0; // N
};

void paintGrab(const Stage& stage, const ShownGrab& grab, LabelPainter& labels);
/// Ghosts fade with their age; ways of what is selected stand out.
void paintWays(const Stage& stage, const TimelineSummary& timeline, const DebugColors& colors,
               std::span<const Key> selected);

} // namespace spacetow
