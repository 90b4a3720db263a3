#pragma once
// The definition of a rigid body, and a reading of its state. SI units, radians, y up.

#include "core/base/handles.h"
#include "core/geometry/shape.h"
#include "core/math/transform.h"
#include "core/physics/def/tags.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace spacetow {

using BodyId = Id<struct BodyTag>;

/// Static bodies never move. Kinematic bodies obey their velocity and manual forces alone, dynamic ones contacts too.
enum class BodyKind : std::uint8_t { Static, Kinematic, Dynamic };

/// Who applies a force. A kinematic body accepts manual forces only, a static body accepts none.
enum class ForceSource : std::uint8_t { Manual, Engine };

struct BodyDef {
    BodyKind kind = BodyKind::Dynamic;
    std::vector<Shape> shapes;  // local coordinates; at least one, unless the body is static
    Vec2 position{0, 0};        // m, of the local origin
    double angle = 0;           // rad
    Vec2 velocity{0, 0};        // m/s, of the centre of mass
    double angularVelocity = 0; // rad/s
    std::optional<double> mass; // kg, > 0; by default area times density
    double density = 1;         // kg/m², > 0; an edge or line has the mass of a strip 1 m wide
    double restitution = 0;     // 0 … 1; a contact has the mean of both bodies
    double friction = 0.3;      // ≥ 0; a contact has the geometric mean of both bodies
    double linearDamping = 0;   // 1/s, ≥ 0
    double angularDamping = 0;  // 1/s, ≥ 0
    Filter filter;
    bool tangible = true; // an intangible body is a sensor: events report its touches, contacts ignore it
    bool positionFrozen = false;
    bool rotationFrozen = false;
    bool active = true;          // an inactive body does not move, collide or accept forces
    bool reportsTouches = false; // whether Events::tagsTouched has entries of this body
    std::uint64_t user = 0;      // set by the owner of the world; the engine never reads it
};

/// The part of BodyDef that World::setMaterial can change. Units and ranges as in BodyDef.
struct BodyMaterial {
    std::optional<double> mass;
    double density = 1;
    double restitution = 0;
    double friction = 0.3;
    double linearDamping = 0;
    double angularDamping = 0;
};

inline BodyMaterial materialOf(const BodyDef& def) {
    return {def.mass, def.density, def.restitution, def.friction, def.linearDamping, def.angularDamping};
}

/// The state of one body. `pose` places the local origin; `velocity` is that of the centre of mass.
struct BodyState {
    BodyKind kind;
    Transform pose;
    double angle;           // rad, in (−π, π]
    Vec2 velocity;          // m/s
    double angularVelocity; // rad/s
    Vec2 massCenter;        // world, m
    double mass;            // kg; infinite for static and kinematic bodies
    double inertia;         // kg m², about the centre of mass; infinite where the mass is
    Filter filter;
    TagMask touchedTags; // of all bodies that this one touched in the last iteration
    bool tangible;
    bool active;
    bool asleep;
    bool positionFrozen;
    bool rotationFrozen;
    std::uint64_t user;
};

} // namespace spacetow
