#pragma once
// From a body's definition to its record: validation, convex parts about the centre of mass, mass properties.

#include "core/physics/world_data.h"

namespace spacetow {

struct MadeBody {
    BodyRecord record;
    BodyMotion motion; // inverse masses not yet set
    BodyStep step;
};

/// Codes as World::addBody.
Result<MadeBody> makeBody(const BodyDef& def);

} // namespace spacetow
