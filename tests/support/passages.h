#pragma once
// What passes one-way walls from behind, and the walls. SI units.

#include "tests/support/contact_scenes.h"

#include <vector>

namespace spacetow::test {

inline constexpr const char* passers[] = {"ball", "box", "ship", "angle", "trough"};

/// Things that are concave, and others.
BodyDef passerOf(const QString& what, const Vec2& at);

/// Edges from corner to corner, each a body of its own.
void addChain(World& world, const std::vector<Vec2>& corners, double depth);

/// The corners of two edges that meet in the origin, as steep on the one side as on the other; hollow as seen from the
/// front when positive.
std::vector<Vec2> bentBy(double degrees, double length = 5);

/// The corners of short ones on an arc that turns by so much in all, straight across above the origin.
std::vector<Vec2> arcOf(double degrees);

/// One body that flies by itself, and is to do so all along.
struct Flight {
    World world;
    BodyId id;
    Vec2 velocity{0, 0}, at{0, 0};

    explicit Flight(World walls) : world(std::move(walls)) {}
    Flight(int iterations, const std::vector<Vec2>& corners, double depth);
    void start(const QString& what, const Vec2& from, const Vec2& v, double spin = 0);
    /// Empty when nothing was touched for so long a way.
    QString fly(double way);
    void turnBack(double spin = 0);
};

struct FlownAs {
    double speed, across; // m/s, m
    int iterations;
};
/// For a message: how it was flown.
QString flownText(const FlownAs& flown);

} // namespace spacetow::test
