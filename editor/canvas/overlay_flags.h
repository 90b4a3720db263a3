#pragma once
// Which debug overlays are drawn over a level or a running game. The same switches serve the canvas, what
// runs in it, the command line and the tests.

namespace spacetow {

struct OverlayFlags {
    bool aabb = false;        // bounding boxes
    bool incircle = false;    // of polygons, about their centroid
    bool velocity = false;    // where the centre of mass would be a second later
    bool orientation = false; // one metre along the body's "up"
    bool normals = false;     // free side of walls, one metre
    bool quadtree = false;    // leaf cells of the static broad phase
    bool tags = false;        // what each object is; while editing
    bool problems = true;     // where something is wrong; while editing

    /// Whether anything is drawn that the physics has worked out.
    bool any() const { return aabb || incircle || velocity || orientation || normals || quadtree; }
    bool operator==(const OverlayFlags&) const = default;
};

} // namespace spacetow
