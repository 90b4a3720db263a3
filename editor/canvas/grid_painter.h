#pragma once
// The grid: lines where points snap to, as far as they can be told apart, stronger ones at round numbers, and the axes.

#include "editor/canvas/stage.h"

namespace spacetow {

/// `step` is the distance in metres at which points snap. Lines closer than a few pixels are thinned out.
void paintGrid(const Stage& stage, double step);

/// The distances of the fine and the strong lines at this zoom, metres.
struct GridSteps {
    double minor;
    double major;
};
GridSteps gridSteps(double step, double pixelsPerMetre);

} // namespace spacetow
