#pragma once
// The fields of a level file, each said once: name, unit, range and whether it may be left out. Reading, writing,
// checking and the test of the documentation all walk through these descriptions with a visitor of their own.
//
// A visitor has: number, integer, optionalNumber, optionalColor, depth, flag, text, choice, point, points, tags,
// touches, key, optionalKey, shapes — each taking (const Field&, the value, its default where there is one).

#include "core/level/level.h"

#include <array>
#include <limits>
#include <string_view>

namespace spacetow {

enum class Presence : std::uint8_t {
    Required, // must be there
    Written,  // has a default, but is always written
    Optional, // left out when it equals its default
};

struct Field {
    const char* name;
    const char* unit = "";
    double min = 0;
    double max = 0;
    Presence presence = Presence::Optional;
    bool openMin = false; // the least value itself is not allowed
};

namespace limits {
constexpr double coordinate = 1e6;  // m
constexpr double speed = 1e4;       // m/s
constexpr double spin = 1e4;        // rad/s
constexpr double angle = 1e3;       // rad
constexpr double mass = 1e9;        // kg
constexpr double damping = 1e3;     // 1/s
constexpr double gravity = 1e3;     // m/s²
constexpr double stiffness = 1e9;   // N/m
constexpr double force = 1e9;       // N
constexpr int vertices = 1'000'000; // of the whole file
constexpr int polygonVertices = 1024;
} // namespace limits

/// Spellings of an enumeration, in the order of its values; empty for values that have none.
template <std::size_t n>
using Spellings = std::array<std::string_view, n>;

constexpr Spellings<3> bodyKindNames{"static", "kinematic", "dynamic"};
constexpr Spellings<5> truncationNames{"zero", "none", "clamp", "tanh", "partial-tanh"};
constexpr Spellings<6> objectTypeNames{"body", "ship", "payload", "finish", "connector", "group"};
constexpr Spellings<4> shapeTypeNames{"edges", "lines", "polygon", "circle"};

namespace fields {

constexpr Field positive(const char* name, const char* unit, double max) {
    return {name, unit, 0, max, Presence::Optional, true};
}
constexpr Field between(const char* name, const char* unit, double min, double max) {
    return {name, unit, min, max};
}
constexpr Field symmetric(const char* name, const char* unit, double max) {
    return {name, unit, -max, max};
}
constexpr Field with(Presence presence, Field field) {
    field.presence = presence;
    return field;
}
constexpr Field plain(const char* name, Presence presence = Presence::Optional) {
    return {name, "", 0, 0, presence};
}

constexpr Field required(Field field) {
    return with(Presence::Required, field);
}
constexpr Field written(Field field) {
    return with(Presence::Written, field);
}

} // namespace fields

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const BodyObject& defaults) {
    using namespace fields;
    v.choice(plain("kind"), object.kind, defaults.kind, bodyKindNames);
    v.point(written(symmetric("position", "m", limits::coordinate)), object.position, defaults.position);
    v.number(symmetric("angle", "rad", limits::angle), object.angle, defaults.angle);
    v.point(symmetric("velocity", "m/s", limits::speed), object.velocity, defaults.velocity);
    v.number(symmetric("angularVelocity", "rad/s", limits::spin), object.angularVelocity, defaults.angularVelocity);
    v.optionalNumber(positive("mass", "kg", limits::mass), object.mass);
    v.number(positive("density", "kg/m²", limits::mass), object.density, defaults.density);
    v.number(between("restitution", "", 0, 1), object.restitution, defaults.restitution);
    v.number(between("friction", "", 0, 100), object.friction, defaults.friction);
    v.number(between("linearDamping", "1/s", 0, limits::damping), object.linearDamping, defaults.linearDamping);
    v.number(between("angularDamping", "1/s", 0, limits::damping), object.angularDamping, defaults.angularDamping);
    v.tags(plain("tags", Presence::Written), object.filter.tags, defaults.filter.tags);
    v.touches(plain("touches"), object.filter.touches);
    v.flag(plain("tangible"), object.tangible, defaults.tangible);
    v.flag(plain("frozen"), object.frozen, defaults.frozen);
    v.shapes(plain("shapes", Presence::Required), object.shapes);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const ShipObject& defaults) {
    using namespace fields;
    v.point(written(symmetric("position", "m", limits::coordinate)), object.position, defaults.position);
    v.number(symmetric("angle", "rad", limits::angle), object.angle, defaults.angle);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const PayloadObject& defaults) {
    using namespace fields;
    v.point(written(symmetric("position", "m", limits::coordinate)), object.position, defaults.position);
    v.number(positive("radius", "m", limits::coordinate), object.radius, defaults.radius);
    v.number(positive("mass", "kg", limits::mass), object.mass, defaults.mass);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const FinishObject& defaults) {
    using namespace fields;
    v.point(required(symmetric("a", "m", limits::coordinate)), object.a, defaults.a);
    v.point(required(symmetric("b", "m", limits::coordinate)), object.b, defaults.b);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const ConnectorObject& defaults) {
    using namespace fields;
    v.key(plain("a", Presence::Required), object.a);
    v.key(plain("b", Presence::Required), object.b);
    v.point(symmetric("anchorA", "m", limits::coordinate), object.anchorA, defaults.anchorA);
    v.point(symmetric("anchorB", "m", limits::coordinate), object.anchorB, defaults.anchorB);
    v.optionalNumber(between("length", "m", 0, limits::coordinate), object.length);
    v.number(between("stiffness", "N/m", 0, limits::stiffness), object.stiffness, defaults.stiffness);
    v.number(between("damping", "N s/m", 0, limits::stiffness), object.damping, defaults.damping);
    v.flag(plain("slack"), object.slack, defaults.slack);
    v.flag(plain("bodiesCollide"), object.bodiesCollide, defaults.bodiesCollide);
    v.choice(plain("truncation"), object.truncation, defaults.truncation, truncationNames);
    v.number(between("limit", "N", 0, limits::force), object.limit, defaults.limit);
    v.number(between("proportion", "", 0, 1), object.proportion, defaults.proportion);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const GroupObject& defaults) {
    using namespace fields;
    v.flag(plain("layer"), object.layer, defaults.layer);
    v.optionalColor(plain("color"), object.color);
}

/// The fields that every kind of object has; "key" and "type" are read and written apart.
template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const Object& defaults) {
    using namespace fields;
    v.text(plain("name"), object.name, defaults.name);
    v.optionalKey(plain("parent"), object.parent);
    v.flag(plain("visible"), object.visible, defaults.visible);
    v.flag(plain("locked"), object.locked, defaults.locked);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& guide, const Guide& defaults) {
    using namespace fields;
    v.point(required(symmetric("point", "m", limits::coordinate)), guide.point, defaults.point);
    v.number(symmetric("angle", "rad", limits::angle), guide.angle, defaults.angle);
    v.text(plain("name"), guide.name, defaults.name);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& shape, const EdgeChain& defaults) {
    using namespace fields;
    v.flag(plain("closed"), shape.closed, defaults.closed);
    v.depth(written(between("depth", "m", 0, limits::coordinate)), shape.depth, defaults.depth);
    v.points(required(symmetric("vertices", "m", limits::coordinate)), shape.vertices);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& shape, const LineChain& defaults) {
    using namespace fields;
    v.flag(plain("closed"), shape.closed, defaults.closed);
    v.points(required(symmetric("vertices", "m", limits::coordinate)), shape.vertices);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& shape, const Polygon&) {
    using namespace fields;
    v.points(required(symmetric("vertices", "m", limits::coordinate)), shape.vertices);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& shape, const Circle& defaults) {
    using namespace fields;
    v.point(symmetric("center", "m", limits::coordinate), shape.center, defaults.center);
    v.number(required(positive("radius", "m", limits::coordinate)), shape.radius, defaults.radius);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& rules, const Rules& defaults) {
    using namespace fields;
    v.integer(written(between("lives", "", 1, 99)), rules.lives, defaults.lives);
    v.number(written(positive("towRange", "m", limits::coordinate)), rules.towRange, defaults.towRange);
    v.flag(written(plain("flipGravityOnTow")), rules.flipGravityOnTow, defaults.flipGravityOnTow);
    v.text(written(plain("background")), rules.background, defaults.background);
}

/// The simple fields of the level itself; "schema", "rules", "tags", "guides" and "objects" are structures of their
/// own.
template <class Visitor, class T>
void visitFields(Visitor& v, T& level, const Level& defaults) {
    using namespace fields;
    v.text(written(plain("name")), level.name, defaults.name);
    v.text(plain("author"), level.author, defaults.author);
    v.text(plain("description"), level.description, defaults.description);
    v.point(written(symmetric("gravity", "m/s²", limits::gravity)), level.gravity, defaults.gravity);
    v.number(written(positive("updateSeconds", "s", 0.1)), level.updateSeconds, defaults.updateSeconds);
    v.integer(written(between("iterations", "", 1, 1000)), level.iterations, defaults.iterations);
    v.integer(written(between("substeps", "", 1, 100)), level.substeps, defaults.substeps);
}

/// Of an object, a shape, the rules or a level: `visitFields` with the defaults of its own type.
template <class Visitor, class T>
void visitFields(Visitor& v, T& value) {
    static const std::remove_const_t<T> defaults; // with {} g++ 12 takes the text in it for uninitialised at -O3
    visitFields(v, value, defaults);
}

} // namespace spacetow
