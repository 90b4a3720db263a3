#pragma once
// Ways through the triangles of a LeakMesh.

#include "core/level/leak_mesh.h"

namespace spacetow {

/// Which triangles the ship can get to. It ends at the first one outside.
struct Reach {
    bool isOutside = false;
    std::vector<char> triangles; // 1 for those reached
};
Reach reachOf(const LeakMesh& mesh, const std::stop_token& stop);

/// The way to the outside that is the shortest, or nearly so.
struct Escape {
    std::vector<int> edges;   // over which it goes, in their order
    std::vector<Vec2> points; // from the ship to a place outside
};
/// Without edges when there is none. `margin`: how far it keeps away from walls where there is room, m.
Escape shortestEscape(const LeakMesh& mesh, const Vec2& ship, double margin, const std::stop_token& stop);

} // namespace spacetow
