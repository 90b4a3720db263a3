#include "editor/panels/form_rows.h"

#include <QCoreApplication>

#include <array>
#include <numbers>
#include <string_view>

namespace spacetow {

namespace {

#define TEXT(words) QT_TRANSLATE_NOOP("Inspector", words)

constexpr std::array kinds{TEXT("Static"), TEXT("Kinematic"), TEXT("Dynamic")};
constexpr std::array truncations{TEXT("No tension"), TEXT("Unlimited"), TEXT("Cut off"), TEXT("Tanh"),
                                 TEXT("Partial tanh")};

constexpr const char* object = TEXT("General");
constexpr const char* place = TEXT("Position");
constexpr const char* shape = TEXT("Shape");
constexpr const char* motion = TEXT("Motion");
constexpr const char* matter = TEXT("Matter");
constexpr const char* connection = TEXT("Connector");
constexpr const char* collisions = TEXT("Collisions");
constexpr const char* level = TEXT("General");
constexpr const char* rules = TEXT("Rules of the game");
constexpr const char* physics = TEXT("Physics");

// clang-format off
constexpr std::array rowsOfObjects{
    FormRow{object, TEXT("Name"), "name", RowKind::Text},
    FormRow{object, TEXT("Kind"), "kind", RowKind::Choice, 0, "", kinds},
    FormRow{place, TEXT("Position"), "position.x", RowKind::Number, 0.05},
    FormRow{place, "", "position.y", RowKind::Number, 0.05},
    FormRow{place, TEXT("Angle"), "angle", RowKind::Number, 5},
    FormRow{place, TEXT("From"), "a.x", RowKind::Number, 0.05},
    FormRow{place, "", "a.y", RowKind::Number, 0.05},
    FormRow{place, TEXT("To"), "b.x", RowKind::Number, 0.05},
    FormRow{place, "", "b.y", RowKind::Number, 0.05},
    FormRow{shape, TEXT("Radius"), "radius", RowKind::Number, 0.05},
    FormRow{shape, TEXT("Depth"), "depth", RowKind::Number, 0.05, TEXT("no back")},
    FormRow{shape, TEXT("Closed: the last point joins the first"), "closed", RowKind::Switch},
    FormRow{matter, TEXT("Mass"), "mass", RowKind::Number, 0.1, TEXT("from shape")},
    FormRow{matter, TEXT("Density"), "density", RowKind::Number, 0.1},
    FormRow{matter, TEXT("Restitution"), "restitution", RowKind::Number, 0.05},
    FormRow{matter, TEXT("Friction"), "friction", RowKind::Number, 0.05},
    FormRow{motion, TEXT("Velocity"), "velocity.x", RowKind::Number, 0.1},
    FormRow{motion, "", "velocity.y", RowKind::Number, 0.1},
    FormRow{motion, TEXT("Spin"), "angularVelocity", RowKind::Number, 5},
    FormRow{motion, TEXT("Linear damping"), "linearDamping", RowKind::Number, 0.05},
    FormRow{motion, TEXT("Angular damping"), "angularDamping", RowKind::Number, 0.05},
    FormRow{motion, TEXT("Frozen: held in place"), "frozen", RowKind::Switch},
    FormRow{connection, TEXT("Anchor on first"), "anchorA.x", RowKind::Number, 0.05},
    FormRow{connection, "", "anchorA.y", RowKind::Number, 0.05},
    FormRow{connection, TEXT("Anchor on second"), "anchorB.x", RowKind::Number, 0.05},
    FormRow{connection, "", "anchorB.y", RowKind::Number, 0.05},
    FormRow{connection, TEXT("Length"), "length", RowKind::Number, 0.05, TEXT("as placed")},
    FormRow{connection, TEXT("Stiffness"), "stiffness", RowKind::Number, 10},
    FormRow{connection, TEXT("Damping"), "damping", RowKind::Number, 0.5},
    FormRow{connection, TEXT("Tension"), "truncation", RowKind::Choice, 0, "", truncations},
    FormRow{connection, TEXT("Limit"), "limit", RowKind::Number, 10},
    FormRow{connection, TEXT("Untouched part"), "proportion", RowKind::Number, 0.05},
    FormRow{connection, TEXT("Slack: pulls only"), "slack", RowKind::Switch},
    FormRow{connection, TEXT("Its two bodies may collide"), "bodiesCollide", RowKind::Switch},
    FormRow{collisions, TEXT("Tangible: others bounce off it"), "tangible", RowKind::Switch},
    FormRow{collisions, TEXT("Is"), "tags", RowKind::Tags},
    FormRow{collisions, TEXT("Touches"), "touches", RowKind::Touches},
};

constexpr std::array rowsOfLevel{
    FormRow{level, TEXT("Name"), "name", RowKind::Text},
    FormRow{level, TEXT("Author"), "author", RowKind::Text},
    FormRow{level, TEXT("Description"), "description", RowKind::LongText},
    FormRow{level, TEXT("Background"), "background", RowKind::Background},
    FormRow{rules, TEXT("Lives"), "lives", RowKind::Number, 1},
    FormRow{rules, TEXT("Tow range"), "towRange", RowKind::Number, 0.1},
    FormRow{rules, TEXT("Towing turns gravity round"), "flipGravityOnTow", RowKind::Switch},
    FormRow{physics, TEXT("Gravity"), "gravity.x", RowKind::Number, 0.05},
    FormRow{physics, "", "gravity.y", RowKind::Number, 0.05},
    FormRow{physics, TEXT("Update"), "updateSeconds", RowKind::Number, 0.005},
    FormRow{physics, TEXT("Iterations"), "iterations", RowKind::Number, 1},
    FormRow{physics, TEXT("Sub-steps"), "substeps", RowKind::Number, 1},
};
// clang-format on

constexpr double degrees = 180 / std::numbers::pi;

bool isAngle(std::string_view unit) {
    return unit == "rad" || unit == "rad/s";
}

} // namespace

std::span<const FormRow> objectRows() {
    return rowsOfObjects;
}

std::span<const FormRow> levelRows() {
    return rowsOfLevel;
}

double shownPerStored(const char* unit) {
    return isAngle(unit) ? degrees : 1;
}

const char* shownUnit(const char* unit) {
    return std::string_view(unit) == "rad" ? "°" : std::string_view(unit) == "rad/s" ? "°/s" : unit;
}

} // namespace spacetow
