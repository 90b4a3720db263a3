#pragma once
// A damped spring between two anchor points (report, page 9).

#include "core/base/handles.h"
#include "core/physics/def/body.h"
#include "core/physics/def/truncation.h"

#include <optional>

namespace spacetow {

using ConnectorId = Id<struct ConnectorTag>;

/// tension = f(stiffness · (d − length)) + damping · (rate of d), where f is the truncation and d the distance of
/// the anchors; equal and opposite at both anchors.
struct ConnectorDef {
    BodyId a, b;
    Vec2 anchorA{0, 0}, anchorB{0, 0}; // local coordinates of each body
    std::optional<double> length;      // m, ≥ 0; without it the distance at the moment of connecting
    double stiffness = 100;            // N/m, ≥ 0
    double damping = 0;                // N s/m, ≥ 0
    bool slack = false;                // pulls only: no tension while d ≤ length
    bool bodiesCollide = false;        // whether the two bodies may touch while connected
    Truncation truncation;
};

struct ConnectorState {
    BodyId a, b;
    Vec2 anchorA, anchorB; // world
    double length;         // m, natural
    double tension;        // N, of the last sub-step; positive when it pulls
};

} // namespace spacetow
