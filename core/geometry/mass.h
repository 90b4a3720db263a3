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

/// `density` in kg/m². Edges and lines are thin rods of 1 kg a metre times the density. The orientation of a polygon
/// does not matter; one that encloses nothing has no mass.
MassProperties massOf(const Shape& shape, double density);

/// Of a body made from all of these.
MassProperties sum(std::span<const MassProperties> parts);

} // namespace spacetow
