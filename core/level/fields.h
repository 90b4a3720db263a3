#pragma once
// The fields of a level file, each said once: name, meaning, unit, range and whether it may be left out. Reading,
// writing, checking, the inspector and the documents (describe.h) walk through these with a visitor of their own.
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
    int least = 0;        // entries of a list
    int most = 0;         // likewise; 0 for as many as a file may have
    const char* meaning = "";

    bool operator==(const Field&) const = default;
};

namespace limits {
constexpr double coordinate = 1e6;  // m
constexpr double speed = 1e4;       // m/s
constexpr double spin = 1e4;        // rad/s
constexpr double steering = 1e4;    // rad/s²
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

constexpr Field about(const char* meaning, Field field) {
    field.meaning = meaning;
    return field;
}
constexpr Field counted(Field field, int least, int most) {
    field.least = least;
    field.most = most;
    return field;
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
    v.choice(about("Static bodies never move, kinematic ones move as told and are pushed by nothing, dynamic ones obey "
                   "forces.",
                   plain("kind")),
             object.kind, defaults.kind, bodyKindNames);
    v.point(
        about("Where the origin of its coordinates is, in m.", written(symmetric("position", "m", limits::coordinate))),
        object.position, defaults.position);
    v.number(about("In rad, anticlockwise.", symmetric("angle", "rad", limits::angle)), object.angle, defaults.angle);
    v.point(about("Of the centre of mass, in m/s.", symmetric("velocity", "m/s", limits::speed)), object.velocity,
            defaults.velocity);
    v.number(about("In rad/s, anticlockwise.", symmetric("angularVelocity", "rad/s", limits::spin)),
             object.angularVelocity, defaults.angularVelocity);
    v.optionalNumber(about("In kg; without it, the area times the density.", positive("mass", "kg", limits::mass)),
                     object.mass);
    v.number(
        about("In kg/m²; walls count as 1 kg a metre times the density.", positive("density", "kg/m²", limits::mass)),
        object.density, defaults.density);
    v.number(about("Share of the speed that is left after a bounce.", between("restitution", "", 0, 1)),
             object.restitution, defaults.restitution);
    v.number(about("Coefficient of friction.", between("friction", "", 0, 100)), object.friction, defaults.friction);
    v.number(
        about("Share of the velocity lost each second, in 1/s.", between("linearDamping", "1/s", 0, limits::damping)),
        object.linearDamping, defaults.linearDamping);
    v.number(about("Share of the angular velocity lost each second, in 1/s.",
                   between("angularDamping", "1/s", 0, limits::damping)),
             object.angularDamping, defaults.angularDamping);
    v.tags(about("What the body is: names of tags.", plain("tags", Presence::Written)), object.filter.tags,
           defaults.filter.tags);
    v.touches(about("What it touches: tags, all, or all but some; the shorter list is written.", plain("touches")),
              object.filter.touches);
    v.flag(about("An intangible body is felt, but stops nothing.", plain("tangible")), object.tangible,
           defaults.tangible);
    v.flag(about("A frozen body keeps its place and angle.", plain("frozen")), object.frozen, defaults.frozen);
    v.shapes(about("In the coordinates of the body.", counted(plain("shapes", Presence::Required), 1, 0)),
             object.shapes);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const ShipObject& defaults) {
    using namespace fields;
    v.point(about("Of its centre of mass, in m.", written(symmetric("position", "m", limits::coordinate))),
            object.position, defaults.position);
    v.number(about("In rad, anticlockwise; 0 is nose up.", symmetric("angle", "rad", limits::angle)), object.angle,
             defaults.angle);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const PayloadObject& defaults) {
    using namespace fields;
    v.point(about("Of its centre, in m.", written(symmetric("position", "m", limits::coordinate))), object.position,
            defaults.position);
    v.number(about("In m.", positive("radius", "m", limits::coordinate)), object.radius, defaults.radius);
    v.number(about("In kg.", positive("mass", "kg", limits::mass)), object.mass, defaults.mass);
    v.number(about("Share of the speed that is left after a bounce.", between("restitution", "", 0, 1)),
             object.restitution, defaults.restitution);
    v.number(
        about("Share of the velocity lost each second, in 1/s.", between("linearDamping", "1/s", 0, limits::damping)),
        object.linearDamping, defaults.linearDamping);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const FinishObject& defaults) {
    using namespace fields;
    v.point(about("One end, in m.", required(symmetric("a", "m", limits::coordinate))), object.a, defaults.a);
    v.point(about("The other end, in m.", required(symmetric("b", "m", limits::coordinate))), object.b, defaults.b);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const ConnectorObject& defaults) {
    using namespace fields;
    v.key(about("Key of the one body.", plain("a", Presence::Required)), object.a);
    v.key(about("Key of the other body.", plain("b", Presence::Required)), object.b);
    v.point(
        about("Where it holds the one body, in m, in its coordinates.", symmetric("anchorA", "m", limits::coordinate)),
        object.anchorA, defaults.anchorA);
    v.point(about("Where it holds the other body, in m, in its coordinates.",
                  symmetric("anchorB", "m", limits::coordinate)),
            object.anchorB, defaults.anchorB);
    v.optionalNumber(about("Natural length in m; without it, the distance at the start.",
                           between("length", "m", 0, limits::coordinate)),
                     object.length);
    v.number(about("In N/m.", between("stiffness", "N/m", 0, limits::stiffness)), object.stiffness, defaults.stiffness);
    v.number(about("In N s/m.", between("damping", "N s/m", 0, limits::stiffness)), object.damping, defaults.damping);
    v.flag(about("Whether it only pulls, as a rope does.", plain("slack")), object.slack, defaults.slack);
    v.flag(about("Whether its two bodies may touch each other.", plain("bodiesCollide")), object.bodiesCollide,
           defaults.bodiesCollide);
    v.choice(about("How the tension of the spring is limited.", plain("truncation")), object.truncation,
             defaults.truncation, truncationNames);
    v.number(about("Most tension in N, for clamp, tanh and partial-tanh.", between("limit", "N", 0, limits::force)),
             object.limit, defaults.limit);
    v.number(about("Share of the limit below which partial-tanh changes nothing.", between("proportion", "", 0, 1)),
             object.proportion, defaults.proportion);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const GroupObject& defaults) {
    using namespace fields;
    v.flag(about("A group at the top that is shown as a layer.", plain("layer")), object.layer, defaults.layer);
    v.optionalColor(about("Red, green and blue; without it, the editor chooses.", plain("color")), object.color);
}

/// The fields that every kind of object has; "key" and "type" are read and written apart.
template <class Visitor, class T>
void visitFields(Visitor& v, T& object, const Object& defaults) {
    using namespace fields;
    v.text(about("For people; may be shared.", plain("name")), object.name, defaults.name);
    v.optionalKey(about("Key of the group that it is in; without it, it is at the top.", plain("parent")),
                  object.parent);
    v.flag(about("Hidden objects are not drawn in the editor; they are played all the same. A group hides its members.",
                 plain("visible")),
           object.visible, defaults.visible);
    v.flag(about("Locked objects are not picked, moved or deleted in the editor. A group locks its members.",
                 plain("locked")),
           object.locked, defaults.locked);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& guide, const Guide& defaults) {
    using namespace fields;
    v.point(about("A point of it, in m.", required(symmetric("point", "m", limits::coordinate))), guide.point,
            defaults.point);
    v.number(about("Of its direction, in rad; 0 is horizontal.", symmetric("angle", "rad", limits::angle)), guide.angle,
             defaults.angle);
    v.text(about("For people.", plain("name")), guide.name, defaults.name);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& hidden, const HiddenProblem& defaults) {
    using namespace fields;
    v.text(about("Code of the problem, as `levelc check` prints it.", required(plain("rule"))), hidden.rule,
           defaults.rule);
    v.optionalKey(about("Key of the object that has it; without it, the level itself.", plain("object")),
                  hidden.object);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& shape, const EdgeChain& defaults) {
    using namespace fields;
    v.flag(about("Whether the last vertex joins the first.", plain("closed")), shape.closed, defaults.closed);
    v.depth(about("How far behind the line counts as inside the wall, in m; null for a wall without a back.",
                  written(between("depth", "m", 0, limits::coordinate))),
            shape.depth, defaults.depth);
    v.points(about("Vertices in m, in the coordinates of the body.",
                   counted(required(symmetric("vertices", "m", limits::coordinate)), 2, 0)),
             shape.vertices);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& shape, const LineChain& defaults) {
    using namespace fields;
    v.flag(about("Whether the last vertex joins the first.", plain("closed")), shape.closed, defaults.closed);
    v.points(about("Vertices in m, in the coordinates of the body.",
                   counted(required(symmetric("vertices", "m", limits::coordinate)), 2, 0)),
             shape.vertices);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& shape, const Polygon&) {
    using namespace fields;
    v.points(about("Vertices in m, in the coordinates of the body.",
                   counted(required(symmetric("vertices", "m", limits::coordinate)), 3, limits::polygonVertices)),
             shape.vertices);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& shape, const Circle& defaults) {
    using namespace fields;
    v.point(about("Centre in m, in the coordinates of the body.", symmetric("center", "m", limits::coordinate)),
            shape.center, defaults.center);
    v.number(about("Radius in m.", required(positive("radius", "m", limits::coordinate))), shape.radius,
             defaults.radius);
}

template <class Visitor, class T>
void visitFields(Visitor& v, T& rules, const Rules& defaults) {
    using namespace fields;
    v.integer(about("Attempts.", written(between("lives", "", 1, 99))), rules.lives, defaults.lives);
    v.number(about("Greatest distance of ship and payload at which the rope can be attached, in m.",
                   written(positive("towRange", "m", limits::coordinate))),
             rules.towRange, defaults.towRange);
    v.flag(about("Whether gravity turns round when the payload is towed.", written(plain("flipGravityOnTow"))),
           rules.flipGravityOnTow, defaults.flipGravityOnTow);
    v.text(about("Name of a shipped background.", written(plain("background"))), rules.background, defaults.background);
    v.number(about("Of the ship, along its nose, in N.", between("thrust", "N", 0, limits::force)), rules.thrust,
             defaults.thrust);
    v.number(about("How fast the ship begins to turn while a direction is held, in rad/s².",
                   between("steering", "rad/s²", 0, limits::steering)),
             rules.steering, defaults.steering);
    v.number(about("Of the ship, in kg.", positive("shipMass", "kg", limits::mass)), rules.shipMass, defaults.shipMass);
    v.number(about("Share of the ship's speed that is left after a bounce.", between("shipRestitution", "", 0, 1)),
             rules.shipRestitution, defaults.shipRestitution);
    v.number(about("Share of the ship's velocity lost each second, in 1/s.",
                   between("shipLinearDamping", "1/s", 0, limits::damping)),
             rules.shipLinearDamping, defaults.shipLinearDamping);
    v.number(about("Share of the ship's angular velocity lost each second, in 1/s.",
                   between("shipAngularDamping", "1/s", 0, limits::damping)),
             rules.shipAngularDamping, defaults.shipAngularDamping);
}

/// A structure of its own within the rules, "rope". No field of it is called as one of the level or of its rules.
template <class Visitor, class T>
void visitFields(Visitor& v, T& rope, const RopeRules& defaults) {
    using namespace fields;
    v.number(about("In N/m.", between("stiffness", "N/m", 0, limits::stiffness)), rope.stiffness, defaults.stiffness);
    v.number(about("In N s/m.", between("damping", "N s/m", 0, limits::stiffness)), rope.damping, defaults.damping);
    v.choice(about("How the tension of the rope is limited.", plain("truncation")), rope.truncation,
             defaults.truncation, truncationNames);
    v.number(about("Most tension in N, for clamp, tanh and partial-tanh.", between("limit", "N", 0, limits::force)),
             rope.limit, defaults.limit);
    v.number(about("Share of the limit below which partial-tanh changes nothing.", between("proportion", "", 0, 1)),
             rope.proportion, defaults.proportion);
}

/// The simple fields of the level itself; "schema", "rules" with its rope, "tags", "guides", "hiddenProblems" and
/// "objects" are structures of their own.
template <class Visitor, class T>
void visitFields(Visitor& v, T& level, const Level& defaults) {
    using namespace fields;
    v.text(about("Name of the level.", written(plain("name"))), level.name, defaults.name);
    v.text(about("Who made it.", plain("author")), level.author, defaults.author);
    v.text(about("For people.", plain("description")), level.description, defaults.description);
    v.point(about("In m/s².", written(symmetric("gravity", "m/s²", limits::gravity))), level.gravity, defaults.gravity);
    v.number(about("Simulated by one update, in s.", written(positive("updateSeconds", "s", 0.1))), level.updateSeconds,
             defaults.updateSeconds);
    v.integer(about("Passes of motion and collision in one update.", written(between("iterations", "", 1, 1000))),
              level.iterations, defaults.iterations);
    v.integer(about("Sub-steps of motion in one iteration.", written(between("substeps", "", 1, 100))), level.substeps,
              defaults.substeps);
    v.flag(about("Whether bodies that have come to rest sleep until something touches them.", plain("sleeping")),
           level.sleeping, defaults.sleeping);
}

/// Of an object, a shape, the rules or a level: `visitFields` with the defaults of its own type.
template <class Visitor, class T>
void visitFields(Visitor& v, T& value) {
    static const std::remove_const_t<T> defaults; // with {} g++ 12 takes the text in it for uninitialised at -O3
    visitFields(v, value, defaults);
}

} // namespace spacetow
