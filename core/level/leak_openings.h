#pragma once
// What would close an opening: two places at walls, on either side of the way out.

#include "core/level/leak_paths.h"

#include <utility>
#include <vector>

namespace spacetow {

/// Vertices at which a chain ends and nothing else begins.
std::vector<int> looseEnds(const LeakMesh& mesh);
/// The wall that the vertex belongs to; of several, any. −1 for none.
int wallAt(const LeakMesh& mesh, int vertex);

/// Those next to the way.
std::vector<int> endsBeside(const LeakMesh& mesh, const std::vector<int>& ends, const std::vector<Vec2>& way);

/// What the way may lead through between.
struct OpeningSides {
    std::vector<int> ends;                         // of chains
    std::vector<std::pair<int, int>> nearestWalls; // an end and where another wall is nearest to it
};

/// A wall that would bar the way, between two vertices.
struct Closure {
    double cost = 0; // m, its length, and more where it is less likely to be meant
    int a = 0, b = 0;
};

/// The likeliest first: between ends of chains, then an end and another wall, then two walls, short before long. Of
/// those between the same two, the first.
std::vector<Closure> likelyClosures(const LeakMesh& mesh, const std::vector<LeakWall>& walls, const OpeningSides& sides,
                                    const Escape& escape);

} // namespace spacetow
