#pragma once
// Records of connectors, and deferred changes. SI units.

#include "core/math/vec.h"
#include "core/physics/def/body.h"
#include "core/physics/def/truncation.h"
#include "core/physics/lanes/wide.h"

#include <cstdint>

namespace spacetow {

/// A connector, see ConnectorDef, and its last tension.
struct ConnectorRecord {
    std::uint32_t generation = 0; // grows with every removal, so that old ids become invalid
    bool used = false;
    std::uint64_t serial = 0; // order of creation, counted for bodies and connectors together
    Slot a = 0, b = 0;
    Vec2 anchorA{0, 0}, anchorB{0, 0}; // m, local coordinates, from the centre of mass
    double length = 0;                 // m, natural
    double stiffness = 0;              // N/m
    double damping = 0;                // N s/m
    bool slack = false;                // a rope: it pulls only
    bool bodiesCollide = false;
    Truncation truncation;
    double tension = 0; // N, of the last kick; positive when the connector pulls
};

/// The elastic energy of the connector, J: the work of its truncated tension. `distance` is the distance of the
/// anchors, m.
inline double storedEnergy(const ConnectorRecord& connector, double distance) {
    const double stretch = distance - connector.length;
    const bool isLoose = connector.stiffness == 0 || (connector.slack && stretch < 0);
    return isLoose ? 0 : truncatedWork(connector.truncation, connector.stiffness * stretch) / connector.stiffness;
}

/// A change of a body that waits until no stage of the update is running.
struct PendingChange {
    enum class Kind : std::uint8_t { Remove, Active, Tangible, Frozen } kind;
    BodyId body;
    bool first = false, second = false; // the new values; Active, Tangible: `first`; Frozen: position and rotation
};

} // namespace spacetow
