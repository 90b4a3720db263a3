#pragma once
// Areas, masses and moments of inertia of shapes, by exact formulas.

#include "core/geometry/shape.h"

#include <span>

namespace spacetow {

struct MassProperties {
    double area = 0;               // m²; 0 for edges and lines
    double mass = 0;               // kg
    Vec2 center{0, 0};             // of mass, local coordinates
    double inertia = 0;            // kg m², about the centre
    double inertiaAboutOrigin = 0; // kg m², about the local origin

    /// The same body with another mass; `mass` must be positive.
    MassProperties withMass(double newMass) const;
};

/// `density` in kg/m². An edge or line is a thin rod with the mass of a strip 1 m wide. The orientation of a polygon
/// does not matter; a polygon without area has no mass.
MassProperties massOf(const Shape& shape, double density);

/// The mass properties of a body that consists of all parts.
MassProperties sum(std::span<const MassProperties> parts);

} // namespace spacetow
