#pragma once
// Makes the record of a body from its definition: validation, convex parts about the centre of mass, mass properties.

#include "core/base/result.h"
#include "core/geometry/mass.h"
#include "core/physics/state/world_data.h"

#include <optional>
#include <span>

namespace spacetow {

struct MadeBody {
    BodyRecord record;
    BodyMotion motion; // inverse masses are not set yet
    BodyStep step;
};

/// Mass properties of a body that is not static; none when mass or inertia is not finite or not positive.
std::optional<MassProperties> usableMass(std::span<const Shape> shapes, double density, std::optional<double> mass);

/// The error of a material, whatever the shapes; none if there is no error. badMass() is the error of a material that
/// gives the shapes no usable mass.
std::optional<Error> checkMaterial(const BodyMaterial& material);
Error badMass(const BodyMaterial& material);

/// Sets restitution, friction and dampings, but not mass and inertia.
void setSurface(BodyRecord& record, const BodyMaterial& material);

/// Errors: the codes of World::addBody.
Result<MadeBody> makeBody(const BodyDef& def);

} // namespace spacetow
