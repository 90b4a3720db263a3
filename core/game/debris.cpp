#include "core/game/debris.h"

#include "core/game/rules.h"

#include <array>
#include <cmath>
#include <numbers>

namespace spacetow {
namespace {

/// Uniform over all directions; by rejection, because sines differ between platforms.
Vec2 direction(Random& random) {
    for (;;) {
        const double x = random.uniform(-1, 1);
        const double y = random.uniform(-1, 1);
        const double squared = x * x + y * y;
        if (squared > 1e-4 && squared <= 1) {
            const double length = std::sqrt(squared);
            return {x / length, y / length};
        }
    }
}

/// Regular, 3 … 6 sides, about the origin.
Polygon chip(std::uint32_t sides, double radius) {
    // A turn by 2π/n from exact surds, for the same reason.
    const double root3 = std::sqrt(3.0);
    const double root5 = std::sqrt(5.0);
    const std::array<Rot, 4> turns{Rot{-0.5, root3 / 2}, Rot{0, 1}, Rot{(root5 - 1) / 4, std::sqrt(10 + 2 * root5) / 4},
                                   Rot{0.5, root3 / 2}};
    Polygon polygon;
    Vec2 corner(radius, 0);
    for (std::uint32_t i = 0; i < sides; ++i) {
        polygon.vertices.push_back(corner);
        corner = turns[sides - 3] * corner;
    }
    return polygon;
}

DebrisPiece pieceOf(const BodyState& source, Random& random) {
    using std::numbers::pi;
    BodyDef def;
    const std::uint32_t sides = 3 + random.below(4);
    def.shapes = {chip(sides, random.uniform(debris::minRadius, debris::maxRadius))};
    def.mass = random.uniform(debris::minMass, debris::maxMass);
    const Vec2 offset = direction(random) * random.uniform(0, debris::maxOffset);
    def.position = source.massCenter + offset;
    const Vec2 kick = direction(random) * random.uniform(debris::minSpeed, debris::maxSpeed);
    def.velocity = source.velocity + kick;
    def.angle = source.angle + random.uniform(-pi, pi);
    def.angularVelocity = random.uniform(-2 * pi, 2 * pi);
    def.restitution = debris::restitution;
    def.linearDamping = debris::linearDamping;
    def.angularDamping = debris::angularDamping;
    def.filter = rules::debrisFilter;
    return {std::move(def), random.uniform(debris::minLife, debris::maxLife)};
}

} // namespace

std::vector<DebrisPiece> debrisOf(const BodyState& source, int least, Random& random) {
    std::vector<DebrisPiece> pieces;
    const int count = least + static_cast<int>(random.below(5));
    pieces.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        pieces.push_back(pieceOf(source, random));
    }
    return pieces;
}

} // namespace spacetow
