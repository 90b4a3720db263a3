#pragma once
// Forces that depend on where a body is and how it moves: magnets, gravity wells, wind, buoyancy, controllers. They are
// computed anew before every sub-step, as those of connectors are; what is applied to a body by hand is constant during
// an update.

#include "core/base/handles.h"
#include "core/math/transform.h"
#include "core/physics/def/body.h"

#include <functional>
#include <optional>

namespace spacetow {

using FieldId = Id<struct FieldTag>;

/// One body in the middle of an update. World coordinates, SI units, radians.
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

/// Each kick of a sub-step asks for the force twice: at the velocity before it, and half-way through it. What depends
/// on the velocity is explicit and stays stable for c·h/m < 2, with h the length of a sub-step: damping that is stiffer
/// than this belongs to the body or to a connector, which take it implicitly.
struct ForceFieldDef {
    /// A pure function of its argument: copies of a world share it, and the same futures follow only from the same
    /// function. A value that is not finite is refused: it does not act, and is reported.
    std::function<FieldForce(const FieldSample&)> force;
    std::optional<BodyId> body;               // the only one that feels it; the field is removed together with it
    TagMask tags = TagMask::all();            // otherwise: who has one of these tags feels it
    ForceSource source = ForceSource::Engine; // Manual: kinematic bodies feel it as well
};

} // namespace spacetow
