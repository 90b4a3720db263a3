#pragma once
// What is seen of a shape while it is drawn: its outline up to the pointer, its points, length and angle of the next
// segment, and for one-way walls strokes on the solid side.

#include "editor/editing/overlay.h"

#include <vector>

namespace spacetow {

struct Draft {
    std::vector<Vec2> points; // placed so far, world
    Vec2 next;                // where the next one will land
    bool closes = false;      // the next click closes the shape
    bool fills = false;       // a polygon: the way back to the first point is shown too
    bool oneWay = false;
    double pixel = 0.01; // m
};

Overlay draftOverlay(const Draft& draft);

/// Length and angle of a segment beside its middle.
OverlayText measureText(const Vec2& from, const Vec2& to);

} // namespace spacetow
