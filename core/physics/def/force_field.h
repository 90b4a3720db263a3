#pragma once
// Forces that depend on the position and velocity of a body: magnets, gravity wells, wind, buoyancy, controllers. The
// forces of fields and connectors are recomputed before every sub-step. Forces that World::applyForce adds are constant
// during an update.

#include "core/base/handles.h"
#include "core/math/transform.h"
#include "core/physics/def/body.h"

#include <functional>
#include <optional>

namespace spacetow {

using FieldId = Id<struct FieldTag>;

/// The state of one body during an update. World coordinates, SI units, radians.
struct FieldSample {
    BodyId body;
    Transform pose; // of the local origin
    Vec2 massCenter;
    Vec2 velocity;          // m/s
    double angularVelocity; // rad/s
    double mass;            // kg
    double inertia;         // kg m², about the centre of mass
};

struct FieldForce {
    Vec2 force{0, 0};  // N, at the centre of mass
    double torque = 0; // N m
};

/// Each kick of a sub-step evaluates the force twice: at the velocity before the kick, and half-way through the kick.
/// Damping is therefore explicit: it is stable for c·h/m < 2, with h the length of a sub-step. Stiffer damping belongs
/// in BodyDef or ConnectorDef, where the integration is implicit.
struct ForceFieldDef {
    /// Must be a pure function: copies of a world share it, and have equal futures only if it is. A value that is not
    /// finite is ignored, and reported as a FieldFaultEvent.
    std::function<FieldForce(const FieldSample&)> force;
    std::optional<BodyId> body;               // if set, the field acts on it alone, and is removed with it
    TagMask tags = TagMask::all();            // else the field acts on bodies that have one of these tags
    ForceSource source = ForceSource::Engine; // Manual: the field acts on kinematic bodies too
};

} // namespace spacetow
