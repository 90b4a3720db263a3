#pragma once
// Which debug overlays are drawn over a level or a running game. drawWorld, the canvas, the command line and the tests
// share these flags; editor/canvas/overlay_table.h has their names and explanations.

namespace spacetow {

struct OverlayFlags {
    bool aabb = false;        // bounding boxes, and those of the broad phase
    bool incircle = false;    // of polygons, about their centroid
    bool velocity = false;    // where the centre of mass would be a second later
    bool orientation = false; // one metre along the body's "up"
    bool normals = false;     // free side of walls, one metre, and the band behind them that is solid
    bool quadtree = false;    // cells of both quadtrees, with what they hold
    bool contacts = false;    // points, normals and impulses
    bool tension = false;     // of connectors
    bool trails = false;      // where bodies have been
    bool masses = false;      // centres of mass
    bool names = false;       // of bodies
    bool islands = false;     // who pushes whom, and who sleeps
    bool tags = false;        // what each body is
    bool collides = false;    // what the selection would collide with
    bool risk = false;        // of passing through a wall in one iteration
    bool ways = true;         // of a run, where it is held, and in futures given up; who shows the run draws them
    bool problems = true;     // where something is wrong; while editing

    /// Whether any overlay is on that needs a World; `ways` and `problems` do not.
    bool any() const {
        return aabb || incircle || velocity || orientation || normals || quadtree || contacts || tension || trails ||
               masses || names || islands || tags || collides || risk;
    }
    bool operator==(const OverlayFlags&) const = default;
};

} // namespace spacetow
