#pragma once
// In what two levels look different: areas that have to be painted anew, and whether it all comes down to something
// that has moved. World coordinates, metres.

#include "core/level/level.h"
#include "core/math/aabb.h"

#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

/// Where a picture has to be painted anew.
struct ChangedAreas {
    bool everything = false;
    std::vector<Aabb> boxes; // with room for bands behind walls, not for pens

    void add(const Aabb& box) {
        if (!box.isEmpty()) {
            boxes.push_back(box);
        }
    }
};

struct LevelChanges {
    ChangedAreas objects; // outlines, bands, marks
    ChangedAreas rock;    // matter behind closed walls
};

/// Between two levels of which one was made from the other; takes time with what they do not share.
LevelChanges boardChangesBetween(const Level& before, const Level& after);

/// Places, in `after`, of the objects that are not as in `before`, and of connectors that hang on these; ascending.
std::vector<int> placesChanged(const Level& before, const Level& after);

/// By how much all objects at these places have moved, if that is all that has become of them.
std::optional<Vec2> commonMove(const Level& before, const Level& after, const std::vector<int>& places);

/// Places of the objects that may have matter without end behind closed walls.
std::vector<int> rockMakers(const Level& level);

/// Whether it has walls whose bands are filled in layers, which takes most of the time.
bool hasFadingBand(const Object& object);

/// How far behind its walls something of an object is painted, m, given its reach in the level's index.
double bandBehind(double reach);

} // namespace spacetow
