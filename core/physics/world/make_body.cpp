#include "core/physics/world/make_body.h"

#include "core/geometry/convex_parts.h"
#include "core/geometry/moved.h"
#include "core/geometry/polygon.h"
#include "core/physics/def/codes.h"

#include <algorithm>
#include <optional>

namespace spacetow {

namespace {

// Largest coordinate, m: at 1e9 m the resolution of a double is 1e-7 m, well below the slop.
constexpr double farthest = 1e9;

using Checks = std::initializer_list<std::pair<const char*, bool>>;

/// Returns an error that names the first field whose check is false; none if all are true.
std::optional<Error> firstWrong(PhysicsCode code, Checks checks) {
    const auto* wrong = std::find_if(checks.begin(), checks.end(), [](const auto& check) { return !check.second; });
    return wrong == checks.end() ? std::nullopt : std::optional(Error{code, {wrong->first}});
}

std::optional<Error> checkMotion(const BodyDef& d) {
    if (auto error = firstWrong("not-finite", {{"position", isFinite(d.position)},
                                               {"angle", std::isfinite(d.angle)},
                                               {"velocity", isFinite(d.velocity)},
                                               {"angular velocity", std::isfinite(d.angularVelocity)}})) {
        return error;
    }
    return firstWrong("out-of-range", {{"position", d.position.cwiseAbs().maxCoeff() <= farthest}});
}

struct IsGoodShape {
    bool operator()(const Circle& c) const { return isFinite(c.center) && std::isfinite(c.radius) && c.radius > 0; }
    bool operator()(const Edge& e) const {
        return isFinite(e.a) && isFinite(e.b) && e.a != e.b && !std::isnan(e.depth) && e.depth >= 0;
    }
    bool operator()(const Line& l) const { return isFinite(l.a) && isFinite(l.b) && l.a != l.b; }
    bool operator()(const Polygon& p) const {
        return std::all_of(p.vertices.begin(), p.vertices.end(), [](const Vec2& v) { return isFinite(v); }) &&
               p.vertices.size() >= 3 && signedArea(p.vertices) > 0 && isSimple(p.vertices);
    }
};

/// Radius of a circle inside the part about its own centre: how far the part may jump without leaving itself.
double innerRadius(const Part& part) {
    if (const auto* circle = std::get_if<Circle>(&part)) {
        return circle->radius;
    }
    if (const auto* convex = std::get_if<ConvexPart>(&part)) {
        double radius = std::numeric_limits<double>::infinity();
        for (int i = 0; i < convex->count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            radius = std::min(radius, (convex->corners[k] - convex->center).dot(convex->normals[k]));
        }
        return radius;
    }
    return 0;
}

double outerRadius(const Part& part) {
    if (const auto* circle = std::get_if<Circle>(&part)) {
        return circle->center.norm() + circle->radius;
    }
    if (const auto* wall = std::get_if<WallPart>(&part)) {
        return std::max(wall->a.norm(), wall->b.norm());
    }
    double radius = 0;
    const auto& convex = std::get<ConvexPart>(part);
    for (int i = 0; i < convex.count; ++i) {
        radius = std::max(radius, convex.corners[static_cast<std::size_t>(i)].norm());
    }
    return radius;
}

/// Whether x and 1/x are finite: forces are divided by masses, impulses multiplied by inverse masses.
bool hasInverse(double x) {
    return std::isfinite(x) && std::isfinite(1 / x);
}

bool setMass(BodyRecord& record, const BodyDef& def) {
    const std::optional<MassProperties> total = usableMass(def.shapes, def.density, def.mass);
    if (total) {
        record.localCenter = total->center;
        record.mass = total->mass;
        record.inertia = total->inertia;
    }
    return total.has_value();
}

void setParts(BodyRecord& record, const BodyDef& def) {
    auto parts = std::make_shared<std::vector<Part>>();
    const Transform aboutCenter{-record.localCenter, {}};
    for (const Shape& shape : def.shapes) {
        for (const Part& part : partsOf(shape)) {
            parts->push_back(std::visit([&](const auto& p) -> Part { return moved(p, aboutCenter); }, part));
        }
    }
    std::vector<Part*> all;
    record.innerRadius = parts->empty() ? 0 : std::numeric_limits<double>::infinity();
    for (Part& part : *parts) {
        all.push_back(&part);
        record.innerRadius = std::min(record.innerRadius, innerRadius(part));
        record.outerRadius = std::max(record.outerRadius, outerRadius(part));
    }
    joinParts(all);
    record.parts = std::move(parts);
}

BodyStep stepOf(const BodyRecord& record) {
    BodyStep step;
    step.innerRadius = record.innerRadius;
    step.outerRadius = record.outerRadius;
    if (record.parts->size() == 1) {
        const auto* circle = std::get_if<Circle>(&record.parts->front());
        step.isCircle = circle != nullptr && circle->center.x() == 0 && circle->center.y() == 0;
    }
    return step;
}

} // namespace

std::optional<MassProperties> usableMass(std::span<const Shape> shapes, double density, std::optional<double> mass) {
    std::vector<MassProperties> parts;
    parts.reserve(shapes.size());
    for (const Shape& shape : shapes) {
        parts.push_back(massOf(shape, density));
    }
    MassProperties total = sum(parts);
    if (mass && hasInverse(total.mass)) {
        total = total.withMass(*mass);
    }
    const bool usable = isFinite(total.center) && hasInverse(total.mass) && hasInverse(total.inertia);
    return usable ? std::optional(total) : std::nullopt;
}

std::optional<Error> checkMaterial(const BodyMaterial& m) {
    if (auto error = firstWrong("not-finite", {{"mass", !m.mass || std::isfinite(*m.mass)},
                                               {"density", std::isfinite(m.density)},
                                               {"restitution", std::isfinite(m.restitution)},
                                               {"friction", std::isfinite(m.friction)},
                                               {"linear damping", std::isfinite(m.linearDamping)},
                                               {"angular damping", std::isfinite(m.angularDamping)}})) {
        return error;
    }
    if (auto error = firstWrong("out-of-range", {{"restitution", m.restitution >= 0 && m.restitution <= 1},
                                                 {"friction", m.friction >= 0},
                                                 {"linear damping", m.linearDamping >= 0},
                                                 {"angular damping", m.angularDamping >= 0}})) {
        return error;
    }
    return (m.mass && *m.mass <= 0) || m.density <= 0 ? std::optional(badMass(m)) : std::nullopt;
}

Error badMass(const BodyMaterial& material) {
    return {PhysicsCode("bad-mass"), {material.mass ? "mass" : "density"}};
}

void setSurface(BodyRecord& record, const BodyMaterial& material) {
    record.restitution = material.restitution;
    record.friction = material.friction;
    record.linearDamping = material.linearDamping;
    record.angularDamping = material.angularDamping;
}

Result<MadeBody> makeBody(const BodyDef& def) {
    const BodyMaterial material = materialOf(def);
    for (std::optional<Error> error : {checkMotion(def), checkMaterial(material)}) {
        if (error) {
            return *std::move(error);
        }
    }
    if (def.shapes.empty() && def.kind != BodyKind::Static) {
        return Error{PhysicsCode("no-shape"), {"shapes"}};
    }
    for (const Shape& shape : def.shapes) {
        if (!std::visit(IsGoodShape{}, shape)) {
            return Error{PhysicsCode("bad-shape"), {"shapes"}};
        }
    }
    MadeBody made;
    BodyRecord& r = made.record;
    r.kind = def.kind;
    r.shapes = std::make_shared<const std::vector<Shape>>(def.shapes);
    if (def.kind != BodyKind::Static && !setMass(r, def)) {
        return badMass(material);
    }
    setParts(r, def);
    made.step = stepOf(r);
    setSurface(r, material);
    r.filter = def.filter;
    r.tangible = def.tangible;
    r.active = def.active;
    r.positionFrozen = def.positionFrozen;
    r.rotationFrozen = def.rotationFrozen;
    r.reportsTouches = def.reportsTouches;
    r.user = def.user;
    made.motion.rotation = Rot::fromAngle(def.angle);
    made.motion.center = def.position + made.motion.rotation * r.localCenter;
    if (def.kind != BodyKind::Static) {
        made.motion.velocity = def.positionFrozen ? Vec2(0, 0) : def.velocity;
        made.motion.angularVelocity = def.rotationFrozen ? 0 : def.angularVelocity;
    }
    return made;
}

} // namespace spacetow
