#pragma once
// The overlays of drawWorld (debug_draw.h) that need more than one body, or only the outline of a body. Each function
// draws its overlay, whether the overlay is switched on or not.

#include "core/physics/query/debug_view.h"

#include <cmath>

namespace spacetow {

// Units of the picture: the same at every scale.
constexpr double leastExtent = 2; // a body that is smaller is not drawn

/// Whether a line of this length, m, would be a dot. Pictures without an area have no dots: they leave nothing out.
inline bool isDot(const DebugView& view, double length) {
    return view.area && view.view.toView(std::abs(length)) < 1;
}

/// The same for a mark at that point of the world that is then left out. Tells the host, unless the mark is shorter than a
/// centimetre and so could not be seen from nearer either.
inline bool isLeftOut(const DebugView& view, double length, const Vec2& at, DebugDraw& draw) {
    constexpr double worthSeeing = 0.01; // m
    if (!isDot(view, length)) {
        return false;
    }
    if (std::abs(length) >= worthSeeing) {
        draw.leftOut(view.view.toView(at));
    }
    return true;
}

/// The leaves of both quadtrees: the more a leaf holds, the more opaque; with the count where it fits.
void drawTrees(const World& world, const DebugView& view, DebugDraw& draw);
/// The body filled in the colour of its island, or in the colour of sleep.
void drawIsland(const World& world, BodyId body, const DebugView& view, DebugDraw& draw);
/// The body outlined in the colour of its first coloured tag, with a dot for each further one.
void drawTags(const World& world, BodyId body, const DebugView& view, DebugDraw& draw);
/// Outlines all other bodies by whether the selected bodies collide with them or pass through.
void drawCollisions(const World& world, const DebugView& view, DebugDraw& draw);
/// Connectors with their tension as hue, and in newtons where the text fits.
void drawConnectors(const World& world, const DebugView& view, DebugDraw& draw);
void drawRisks(const World& world, const DebugView& view, DebugDraw& draw);
void drawTrails(const DebugView& view, DebugDraw& draw);
/// Contact points, normals, and the force of the last iteration as arrows: normal force along the normal, friction
/// across. One metre stands for the weight of the lighter body at 9.81 m/s²: impulse · iterations / seconds /
/// (mass · 9.81) = 1. Below that the arrow is to scale; above, each further metre stands for ten times as much.
void drawContacts(const World& world, const DebugView& view, DebugDraw& draw);
/// A cross along the axes of the body.
void drawMassCenter(const BodyState& state, const DebugView& view, DebugDraw& draw);
void drawName(const World& world, BodyId body, const DebugView& view, DebugDraw& draw);

} // namespace spacetow
