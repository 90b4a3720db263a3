#pragma once
// From a body's definition to its record: validation, convex parts about the centre of mass, mass properties.

#include "core/base/result.h"
#include "core/geometry/mass.h"
#include "core/physics/state/world_data.h"

#include <optional>
#include <span>

namespace spacetow {

struct MadeBody {
    BodyRecord record;
    BodyMotion motion; // inverse masses not yet set
    BodyStep step;
};

/// Of a body that is not static; none when mass or inertia is nothing that can be reckoned with.
std::optional<MassProperties> usableMass(std::span<const Shape> shapes, double density, std::optional<double> mass);

/// Codes as World::addBody.
Result<MadeBody> makeBody(const BodyDef& def);

} // namespace spacetow
