#pragma once
// What acts on bodies, connectors and force fields; and what is asked for while it cannot be done yet.

#include "core/math/vec.h"
#include "core/physics/def/body.h"
#include "core/physics/def/force_field.h"
#include "core/physics/def/truncation.h"
#include "core/physics/lanes/wide.h"

#include <cstdint>
#include <memory>

namespace spacetow {

struct ConnectorRecord {
    std::uint32_t generation = 0;
    bool used = false;
    std::uint64_t serial = 0; // order of creation, of bodies and connectors alike
    Slot a = 0, b = 0;
    Vec2 anchorA{0, 0}, anchorB{0, 0}; // about the centres of mass
    double length = 0;
    double stiffness = 0;
    double damping = 0;
    bool slack = false;
    bool bodiesCollide = false;
    Truncation truncation;
    double tension = 0;
};

/// What the connector holds while its anchors are this far apart, J: the work of its truncated tension.
inline double storedEnergy(const ConnectorRecord& connector, double distance) {
    const double stretch = distance - connector.length;
    const bool isLoose = connector.stiffness == 0 || (connector.slack && stretch < 0);
    return isLoose ? 0 : truncatedWork(connector.truncation, connector.stiffness * stretch) / connector.stiffness;
}

struct FieldRecord {
    std::uint32_t generation = 0;
    std::shared_ptr<const ForceFieldDef> def; // none: not used
};

struct PendingChange {
    enum class Kind : std::uint8_t { Remove, Active, Tangible, Frozen } kind;
    BodyId body;
    bool first = false, second = false;
};

} // namespace spacetow
