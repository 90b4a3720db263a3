#pragma once
// Caves made at random, closed but for gaps that the ship does not fit through, and the same with one fault.

#include "core/level/level.h"

#include <string>
#include <vector>

namespace spacetow::test {

/// One piece of the way round a cave, from corner to corner with the cave on its left.
struct CavePiece {
    enum class Kind { Edge, Line, Polygon, Circle };
    Kind kind = Kind::Edge;
    Vec2 a{0, 0};
    Vec2 b{0, 0};
    bool isChained = false; // goes on from the piece before, in the same chain
    bool isReversed = false;
    bool isMissing = false;
};

struct RandomCave {
    Vec2 ship{0, 0};
    std::vector<CavePiece> pieces;
    Level decoration; // things in the cave and around it

    /// A piece through whose middle the ship gets out straight on when it is missing; −1 where there is none.
    int weakPiece(std::uint64_t seed) const;
    /// `objectOf`: the object that each piece became part of, −1 for those that are missing.
    Level level(std::vector<int>* objectOf = nullptr) const;
};

RandomCave caveAtRandom(std::uint64_t seed);

} // namespace spacetow::test
