#pragma once
// Which bodies accept which forces.

#include "core/physics/state/world_data.h"

namespace spacetow {

inline bool accepts(const BodyRecord& record, ForceSource source) {
    return record.active &&
           (record.kind == BodyKind::Dynamic || (record.kind == BodyKind::Kinematic && source == ForceSource::Manual));
}

} // namespace spacetow
