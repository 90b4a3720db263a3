#include "core/geometry/cast.h"

#include "core/geometry/closest.h"
#include "core/geometry/collide.h"
#include "core/geometry/moved.h"
#include "core/geometry/wall_side.h"
#include "core/math/trig.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr int maxSteps = 400;
constexpr int patientSteps = 100; // after these many the steps grow, so that the rest suffices for the whole motion

/// What of a part takes part in the cast, in local coordinates.
struct Caster {
    const Part& part;
    const Sweep& motion;
    Core core;        // local
    double reach = 0; // m, from the pivot to the farthest point of the core

    Caster(const Part& p, const Sweep& m) : part(p), motion(m) { use(coreOf(p, Transform{})); }

    void use(const Core& local) {
        core = local;
        reach = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(core.count); ++i) {
            reach = std::max(reach, (core.points[i] - motion.pivot).norm());
        }
    }
    Core coreAt(const Transform& pose) const {
        Core result;
        result.count = core.count;
        result.radius = core.radius;
        for (std::size_t i = 0; i < static_cast<std::size_t>(core.count); ++i) {
            result.points[i] = pose.toWorld(core.points[i]);
            if (core.count >= 3) {
                result.normals[i] = pose.rotation * core.normals[i];
            }
        }
        return result;
    }
    /// Metres an unturned whole motion moves the world point `p`, which belongs to the part at `fraction`.
    Vec2 velocityOf(const Vec2& p, double fraction) const {
        const Vec2 pivot = motion.start.toWorld(motion.pivot) + fraction * motion.translation;
        return motion.translation + cross(motion.turn, p - pivot);
    }
    double turningSpeed() const { return std::fabs(motion.turn) * reach; }
};

Vec2 referencePoint(const Part& part, const Transform& pose) {
    if (const auto* circle = std::get_if<Circle>(&part)) {
        return pose.toWorld(circle->center);
    }
    if (const auto* convex = std::get_if<ConvexPart>(&part)) {
        return pose.toWorld(convex->center);
    }
    const auto& wall = std::get<WallPart>(part);
    return pose.toWorld(0.5 * (wall.a + wall.b));
}

/// Whether a contact on the wall with this normal, from the wall outward, is one that collide() would report.
bool wallAccepts(const WallPart& wall, const Vec2& reference, const Vec2& onWall, const Vec2& outward) {
    const WallSide side = sideFacing(wall, reference);
    for (const WallEnd* end : {&side.start, &side.end}) {
        if (onWall == end->point) {
            return end->kind == WallEnd::Kind::Free || cornerAllows(side, *end, outward);
        }
    }
    return !wall.oneWay || side.normal.dot(outward) > 0;
}

struct Cast {
    Caster a, b;
    double targetGap;
    bool asPoints; // walls are reduced to a free end: nothing to check about their sides

    bool accepted(const Transform& poseA, const Transform& poseB, const ClosestPoints& closest) const {
        if (asPoints) {
            return true;
        }
        if (const auto* wall = std::get_if<WallPart>(&a.part)) {
            return wallAccepts(moved(*wall, poseA), referencePoint(b.part, poseB), closest.onA, closest.normal);
        }
        if (const auto* wall = std::get_if<WallPart>(&b.part)) {
            return wallAccepts(moved(*wall, poseB), referencePoint(a.part, poseA), closest.onB, -closest.normal);
        }
        return true;
    }

    /// Metres of approach along the normal in a whole motion.
    double approach(const Vec2& onA, const Vec2& onB, const Vec2& normal, double fraction) const {
        return normal.dot(a.velocityOf(onA, fraction) - b.velocityOf(onB, fraction));
    }

    /// Parts whose cores overlap: whether they go deeper still.
    bool deepens(const Transform& poseA, const Transform& poseB, double fraction) const {
        if (asPoints) {
            return false;
        }
        const Manifold manifold = collide(a.part, poseA, b.part, poseB, 0);
        for (int i = 0; i < manifold.count; ++i) {
            const Vec2& point = manifold.points[static_cast<std::size_t>(i)].point;
            if (approach(point, point, manifold.normal, fraction) > 1e-9) {
                return true;
            }
        }
        return false;
    }

    std::optional<double> run() const {
        const Vec2 relative = a.motion.translation - b.motion.translation;
        const double turning = a.turningSpeed() + b.turningSpeed();
        const double fastest = relative.norm() + turning;
        if (!(fastest > 0)) {
            return std::nullopt;
        }
        const double radii = a.core.radius + b.core.radius;
        const double tolerance = 1e-3 * targetGap;
        double fraction = 0;
        double before = 0;
        bool wasApart = false;
        bool slidesIn = false; // past the end of a wall that another continues
        for (int step = 0; step < maxSteps && fraction <= 1; ++step) {
            const Transform poseA = a.motion.at(fraction);
            const Transform poseB = b.motion.at(fraction);
            const ClosestPoints closest = closestOfCores(a.coreAt(poseA), b.coreAt(poseB));
            if (closest.distance <= 0) {
                if ((wasApart && !slidesIn) || deepens(poseA, poseB, fraction)) {
                    return before;
                }
                if (turning == 0) {
                    return std::nullopt;
                }
            } else {
                wasApart = true;
            }
            const double gap = closest.distance - radii;
            const bool near = closest.distance > 0 && gap <= targetGap + tolerance;
            if (near) {
                const double speed = approach(closest.onA, closest.onB, closest.normal, fraction);
                const bool comes = speed > 1e-9 * fastest;
                slidesIn = comes && !accepted(poseA, poseB, closest);
                if (comes && !slidesIn) {
                    return fraction;
                }
                if (!comes && turning == 0) {
                    return std::nullopt; // the distance of convex things in straight motion has one minimum
                }
            }
            // Along a fixed normal nothing comes nearer faster than this.
            const double closing = closest.distance > 0 ? closest.normal.dot(relative) + turning : fastest;
            if (closing <= 0) {
                return std::nullopt;
            }
            const double patience = step < patientSteps ? 0.25 * targetGap : std::max(0.25 * targetGap, fastest / 256);
            before = fraction;
            fraction += std::max((gap - targetGap) / closing, patience / fastest);
        }
        return std::nullopt;
    }
};

Core pointCore(const Vec2& point) {
    Core core;
    core.count = 1;
    core.points[0] = point;
    return core;
}

bool isInFront(const WallPart& wall, const Transform& wallPose, const Vec2& reference) {
    return sideFacing(wall, wallPose.toLocal(reference)).above(wallPose.toLocal(reference)) >= -onTheFace;
}

/// A one-way wall seen from behind: its free ends only. `cast.a` is the wall's side.
std::optional<double> castAgainstEnds(Cast cast, const WallPart& wall) {
    std::optional<double> first;
    cast.asPoints = true;
    for (const bool atA : {true, false}) {
        if (atA ? wall.joinedAtA : wall.joinedAtB) {
            continue;
        }
        cast.a.use(pointCore(atA ? wall.a : wall.b));
        const auto hit = cast.run();
        if (hit && (!first || *hit < *first)) {
            first = hit;
        }
    }
    return first;
}

} // namespace

Transform Sweep::at(double fraction) const {
    Transform pose = start;
    if (turn != 0) {
        const SinCos angle = sinCos(turn * fraction);
        pose.rotation = Rot{angle.cos, angle.sin} * start.rotation;
    }
    pose.position = start.toWorld(pivot) + fraction * translation - pose.rotation * pivot;
    return pose;
}

// NOLINTNEXTLINE(readability-function-size): two parts on their ways, and how near
std::optional<double> timeOfImpact(const Part& a, const Sweep& motionA, const Part& b, const Sweep& motionB,
                                   double targetGap) {
    const Cast cast{{a, motionA}, {b, motionB}, targetGap, false};
    const auto* wallA = std::get_if<WallPart>(&a);
    const auto* wallB = std::get_if<WallPart>(&b);
    if (wallA != nullptr && wallB != nullptr) {
        return std::nullopt;
    }
    if (wallA != nullptr && wallA->oneWay && !isInFront(*wallA, motionA.start, referencePoint(b, motionB.start))) {
        return castAgainstEnds(cast, *wallA);
    }
    if (wallB != nullptr && wallB->oneWay && !isInFront(*wallB, motionB.start, referencePoint(a, motionA.start))) {
        return castAgainstEnds({cast.b, cast.a, targetGap, true}, *wallB);
    }
    return cast.run();
}

// NOLINTNEXTLINE(readability-function-size): two parts on their ways, and how near
std::optional<double> timeOfImpactAtOpenWall(const Part& a, const Sweep& motionA, const Part& b, const Sweep& motionB,
                                             double targetGap) {
    if (const auto* wall = std::get_if<WallPart>(&a)) {
        return castAgainstEnds({{a, motionA}, {b, motionB}, targetGap, true}, *wall);
    }
    return castAgainstEnds({{b, motionB}, {a, motionA}, targetGap, true}, std::get<WallPart>(b));
}

} // namespace spacetow
