#pragma once
// The ends of open chains of walls, where drawing goes on. World coordinates, m.

#include "core/level/level.h"

#include <optional>
#include <span>

namespace spacetow {

/// One end of a chain of one-way or two-sided walls.
struct ChainEnd {
    Key key = 0;
    int shape = 0;
    bool first = false; // where its first wall begins, not where its last one ends

    bool operator==(const ChainEnd&) const = default;
};

/// Where an open chain ends, and what one has to know to close it.
struct OpenChain {
    Vec2 at{0, 0};    // the end in question
    Vec2 other{0, 0}; // the other one
    int vertices = 0;
    double depth = 0; // m, of one-way walls

    bool operator==(const OpenChain&) const = default;
};

/// Nothing when there is no such chain, or it is closed.
std::optional<OpenChain> openChain(const Level& level, const ChainEnd& end);
/// The chain goes on through the points, from the given end; `closes` joins the last of them to its other end. All
/// walls keep their direction, and those that are new take that of the chain. The level as it is where there is no
/// such chain.
Level extended(Level level, const ChainEnd& end, std::span<const Vec2> points, bool closes);

} // namespace spacetow
