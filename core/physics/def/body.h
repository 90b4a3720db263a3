#pragma once
// What a rigid body is made from, and what can be read of it. SI units, radians, y up.

#include "core/base/handles.h"
#include "core/geometry/shape.h"
#include "core/math/transform.h"
#include "core/physics/def/tags.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace spacetow {

using BodyId = Id<struct BodyTag>;

/// Static bodies never move; kinematic ones move as told and are pushed by nothing; dynamic ones obey forces.
enum class BodyKind : std::uint8_t { Static, Kinematic, Dynamic };

/// Who applies a force. Kinematic bodies accept manual ones only, static bodies none.
enum class ForceSource : std::uint8_t { Manual, Engine };

struct BodyDef {
    BodyKind kind = BodyKind::Dynamic;
    std::vector<Shape> shapes;  // local coordinates; at least one, unless the body is static
    Vec2 position{0, 0};        // m, of the local origin
    double angle = 0;           // rad
    Vec2 velocity{0, 0};        // m/s, of the centre of mass
    double angularVelocity = 0; // rad/s
    std::optional<double> mass; // kg, > 0; without it the area times the density
    double density = 1;         // kg/m², > 0; edges and lines count as 1 kg a metre times the density
    double restitution = 0;     // 0 … 1
    double friction = 0.3;      // ≥ 0
    double linearDamping = 0;   // 1/s, ≥ 0
    double angularDamping = 0;  // 1/s, ≥ 0
    Filter filter;
    bool tangible = true; // an intangible body is felt (events) but exerts no force
    bool positionFrozen = false;
    bool rotationFrozen = false;
    bool active = true;          // an inactive body neither moves, collides nor feels forces
    bool reportsTouches = false; // adds the tags touched in each iteration to the events
    std::uint64_t user = 0;      // for the owner of the world; never read by it
};

/// A reading of one body. Positions are of the local origin, velocities of the centre of mass.
struct BodyState {
    BodyKind kind;
    Transform pose;
    double angle;           // rad, in (−π, π]
    Vec2 velocity;          // m/s
    double angularVelocity; // rad/s
    Vec2 massCenter;        // world, m
    double mass;            // kg; infinite for static and kinematic bodies
    double inertia;         // kg m², about the centre of mass; infinite likewise
    Filter filter;
    TagMask touchedTags; // of everything touched in the last iteration
    bool tangible;
    bool active;
    bool asleep;
    bool positionFrozen;
    bool rotationFrozen;
    std::uint64_t user;
};

} // namespace spacetow
