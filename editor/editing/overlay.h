#pragma once
// What a tool draws over the level while it is at work, in world coordinates. The canvas decides colours and widths.

#include "core/level/nodes.h"
#include "core/math/aabb.h"
#include "core/math/vec.h"
#include "editor/editing/snap_answer.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spacetow {

enum class OverlayStyle : std::uint8_t {
    Draft,      // outline of the shape being drawn
    Fault,      // a part of it that must not stay as it is
    SolidSide,  // shade behind one-way walls being drawn: to the right of the way along the line
    Band,       // rubber band
    Handle,     // something to grab
    HotHandle,  // the one under the pointer, or the one that closes a shape
    TurnHandle, // something that turns what is selected
    Pivot,      // about which it turns, or what stays where it is
    Origin,     // of a body's coordinates: what its position says
    Snap,       // where the point will land
    Measure,    // length and angle while drawing
    Velocity,   // where something would be a second later
};

struct OverlayLine {
    OverlayStyle style;
    std::vector<Vec2> points; // world
    bool closed = false;
    double depth = 0; // m, of a solid side; may be without end

    bool operator==(const OverlayLine&) const = default;
};
struct OverlayPoint {
    OverlayStyle style;
    Vec2 at; // world

    bool operator==(const OverlayPoint&) const = default;
};
struct OverlayCircle {
    OverlayStyle style;
    Vec2 center;
    double radius; // m

    bool operator==(const OverlayCircle&) const = default;
};
/// "1.25 m  45°" beside a point, in one line or several; numbers need no translation.
struct OverlayText {
    Vec2 at;
    std::string text;

    bool operator==(const OverlayText&) const = default;
};

/// The nodes of objects in edit. Which of them are selected stands in the selection; only those in view are looked at.
struct OverlayNodes {
    std::vector<Key> keys;    // of the objects, ascending
    std::vector<NodeRef> hot; // under the pointer; of a segment both ends
    bool hotSegment = false;

    bool operator==(const OverlayNodes&) const = default;
};

struct Overlay {
    std::vector<OverlayLine> lines;
    std::vector<OverlayPoint> points;
    std::vector<OverlayCircle> circles;
    std::vector<OverlayText> texts;
    std::optional<OverlayNodes> nodes;
    std::optional<SnapAnswer> snap; // in place of the points of style Snap
    Key hovered = 0;                // object or group that a click would select; 0 for none
    Aabb spotlight;                 // what is outside is dimmed; nothing is while it is empty

    bool operator==(const Overlay&) const = default;
};

} // namespace spacetow
