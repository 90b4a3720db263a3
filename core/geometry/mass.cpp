#include "core/geometry/mass.h"

#include "core/base/contract.h"
#include "core/geometry/polygon.h"

#include <numbers>

namespace spacetow {

namespace {

/// Parallel axis theorem.
MassProperties about(double area, double mass, const Vec2& center, double inertia) {
    return {area, mass, center, inertia, inertia + mass * center.squaredNorm()};
}

MassProperties rod(const Vec2& a, const Vec2& b, double density) {
    const double length = (b - a).norm();
    const double mass = length * density;
    return about(0, mass, 0.5 * (a + b), mass * length * length / 12);
}

struct MassMaker {
    double density;

    MassProperties operator()(const Circle& circle) const {
        const double area = std::numbers::pi * circle.radius * circle.radius;
        const double mass = area * density;
        return about(area, mass, circle.center, 0.5 * mass * circle.radius * circle.radius);
    }
    MassProperties operator()(const Edge& edge) const { return rod(edge.a, edge.b, density); }
    MassProperties operator()(const Line& line) const { return rod(line.a, line.b, density); }
    MassProperties operator()(const Polygon& polygon) const {
        const std::vector<Vec2>& vertices = polygon.vertices;
        if (vertices.empty()) {
            return {};
        }
        const double signedSize = signedArea(vertices);
        const Vec2 center = centroid(vertices);
        double twelfths = 0;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Vec2 p = vertices[i] - center;
            const Vec2 q = vertices[(i + 1) % vertices.size()] - center;
            twelfths += cross(p, q) * (p.dot(p) + p.dot(q) + q.dot(q));
        }
        const double sign = signedSize < 0 ? -1 : 1;
        const double area = sign * signedSize;
        return about(area, area * density, center, sign * density * twelfths / 12);
    }
};

} // namespace

MassProperties MassProperties::withMass(double newMass) const {
    EXPECTS(mass > 0);
    const double ratio = newMass / mass;
    return {area, newMass, center, inertia * ratio, inertiaAboutOrigin * ratio};
}

MassProperties massOf(const Shape& shape, double density) {
    return std::visit(MassMaker{density}, shape);
}

MassProperties sum(std::span<const MassProperties> parts) {
    MassProperties total;
    Vec2 weighted(0, 0);
    for (const MassProperties& part : parts) {
        total.area += part.area;
        total.mass += part.mass;
        weighted += part.mass * part.center;
    }
    if (total.mass > 0) {
        total.center = weighted / total.mass;
    }
    for (const MassProperties& part : parts) {
        total.inertia += part.inertia + part.mass * (part.center - total.center).squaredNorm();
    }
    total.inertiaAboutOrigin = total.inertia + total.mass * total.center.squaredNorm();
    return total;
}

} // namespace spacetow
