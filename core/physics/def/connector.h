#pragma once
// A damped spring between two anchor points. SI units.

#include "core/base/handles.h"
#include "core/physics/def/body.h"
#include "core/physics/def/truncation.h"

#include <optional>

namespace spacetow {

using ConnectorId = Id<struct ConnectorTag>;

/// tension = f(stiffness · (d − length)) + damping · ḋ, where f is the truncation and d the distance between the
/// anchors. The forces at the two anchors are equal and opposite.
struct ConnectorDef {
    BodyId a, b;
    Vec2 anchorA{0, 0}, anchorB{0, 0}; // local coordinates of a and of b
    std::optional<double> length;      // m, ≥ 0; by default the distance when the connector is added
    double stiffness = 100;            // N/m, ≥ 0
    double damping = 0;                // N s/m, ≥ 0
    bool slack = false;                // a rope: no tension while d ≤ length
    bool bodiesCollide = false;        // whether a and b may collide while connected
    Truncation truncation;
};

struct ConnectorState {
    BodyId a, b;
    Vec2 anchorA, anchorB; // world
    double length;         // m, natural
    double tension;        // N, of the last sub-step; positive when the connector pulls
};

} // namespace spacetow
