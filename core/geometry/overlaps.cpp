#include "core/geometry/overlaps.h"

#include "core/geometry/closest.h"
#include "core/geometry/collide.h"
#include "core/geometry/wall_side.h"

#include <algorithm>

namespace spacetow {

namespace {

// Each step goes so much further than it could without passing anything, m.
constexpr double stepInto = 1e-8;
// Walls that are nearer to each other lie in one line, and the direction from one to the other is a matter of rounding,
// m.
constexpr double inOneLine = 1e-10;
// Then the steps grow, so that the rest suffices for the whole way.
constexpr int patientLooks = 200;
constexpr int maxLooks = 712;

// Edges without a back: nothing is further behind, m.
constexpr double deepest = 1e6;

/// A core on its way.
struct Mover {
    Core core; // local
    const ExactSweep& way;
    double turning; // m that turning moves any point of it on the whole way

    Mover(const Core& c, const ExactSweep& w) : core(c), way(w) {
        double reach = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(core.count); ++i) {
            reach = std::max(reach, core.points[i].norm());
        }
        turning = std::abs(way.motion.turn) * (reach + core.radius);
    }
    Core at(double fraction) const {
        const Transform pose = way.at(fraction);
        Core result = core;
        for (std::size_t i = 0; i < static_cast<std::size_t>(core.count); ++i) {
            result.points[i] = pose.toWorld(core.points[i]);
            if (core.count >= 3) {
                result.normals[i] = pose.rotation * core.normals[i];
            }
        }
        return result;
    }
};

enum class Passing { Never, Overlapping, FromTheStart };

/// When the cores first overlap. Segments that face each other before a step, and from the other side after it, have
/// passed through each other; so have those that come to lie in one line, but not those that leave it.
Passing pass(const Mover& a, const Mover& b) {
    const Vec2 relative = a.way.motion.translation - b.way.motion.translation;
    const double turning = a.turning + b.turning;
    const double radii = a.core.radius + b.core.radius;
    const double least = 2 * (relative.norm() + turning) / (maxLooks - patientLooks);
    const bool segments = a.core.count == 2 && b.core.count == 2;
    bool wasApart = false;
    Vec2 facing(0, 0);
    double fraction = 0;
    for (int look = 0; look < maxLooks; ++look) {
        const ClosestPoints closest = closestOfCores(a.at(fraction), b.at(fraction));
        if (closest.distance <= radii) {
            return look == 0 ? Passing::FromTheStart : Passing::Overlapping;
        }
        const bool inLine = segments && closest.distance <= inOneLine;
        if (wasApart && (inLine || (segments && facing.dot(closest.normal) < -0.5))) {
            return Passing::Overlapping;
        }
        // Along a fixed normal nothing comes nearer faster than this.
        const double closing = closest.normal.dot(relative) + turning;
        const double apart = closest.distance - radii;
        if (fraction >= 1 || apart - inOneLine > closing * (1 - fraction)) {
            return Passing::Never;
        }
        wasApart = !inLine;
        facing = closest.normal;
        const double step = apart + (look < patientLooks ? stepInto : std::max(stepInto, least));
        fraction = closing > 0 ? std::min(1.0, fraction + step / closing) : 1;
    }
    return Passing::Never;
}

/// What is inside the depth of an edge touches it without meeting its face.
Core behind(const WallPart& wall) {
    const WallSide side = sideOf(wall, false);
    const Vec2 down = -std::min(side.depth, deepest) * side.normal;
    Core core;
    core.count = 4;
    core.points = {wall.a, wall.a + down, wall.b + down, wall.b};
    core.normals = {-side.direction, -side.normal, side.direction, side.normal};
    return core;
}

/// What an edge goes by.
Core centerOf(const Part& part) {
    const auto* circle = std::get_if<Circle>(&part);
    Core core;
    core.count = 1;
    core.points[0] = circle != nullptr ? circle->center : std::get<ConvexPart>(part).center;
    return core;
}

/// Whether the center of the part comes to be behind the edge.
bool comesBehind(const WallPart& wall, const ExactSweep& wayOfWall, const Part& part, const ExactSweep& way) {
    return wall.oneWay && wall.depth > 0 &&
           pass({behind(wall), wayOfWall}, {centerOf(part), way}) == Passing::Overlapping;
}

} // namespace

bool overlaps(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB) {
    if (closestPoints(a, poseA, b, poseB).distance <= 0) {
        return true;
    }
    const bool wallInvolved = std::holds_alternative<WallPart>(a) || std::holds_alternative<WallPart>(b);
    return wallInvolved && collide(a, poseA, b, poseB, 0).count > 0;
}

bool overlapsDuring(const Part& a, const ExactSweep& wayA, const Part& b, const ExactSweep& wayB) {
    if (pass({coreOf(a, {}), wayA}, {coreOf(b, {}), wayB}) != Passing::Never) {
        return true;
    }
    const auto* wallA = std::get_if<WallPart>(&a);
    const auto* wallB = std::get_if<WallPart>(&b);
    if ((wallA == nullptr) == (wallB == nullptr)) {
        return false;
    }
    return wallA != nullptr ? comesBehind(*wallA, wayA, b, wayB) : comesBehind(*wallB, wayB, a, wayA);
}

} // namespace spacetow
