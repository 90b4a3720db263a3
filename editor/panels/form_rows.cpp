#include "editor/panels/form_rows.h"

#include <QCoreApplication>

#include <array>
#include <numbers>
#include <string_view>

namespace spacetow {

namespace {

constexpr std::array kinds{QT_TRANSLATE_NOOP("Inspector", "Static"), QT_TRANSLATE_NOOP("Inspector", "Kinematic"),
                           QT_TRANSLATE_NOOP("Inspector", "Dynamic")};
constexpr std::array truncations{QT_TRANSLATE_NOOP("Inspector", "No tension"),
                                 QT_TRANSLATE_NOOP("Inspector", "Unlimited"), QT_TRANSLATE_NOOP("Inspector", "Cut off"),
                                 QT_TRANSLATE_NOOP("Inspector", "Tanh"),
                                 QT_TRANSLATE_NOOP("Inspector", "Partial tanh")};

constexpr const char* object = QT_TRANSLATE_NOOP("Inspector", "General");
constexpr const char* place = QT_TRANSLATE_NOOP("Inspector", "Position");
constexpr const char* shape = QT_TRANSLATE_NOOP("Inspector", "Shape");
constexpr const char* motion = QT_TRANSLATE_NOOP("Inspector", "Motion");
constexpr const char* matter = QT_TRANSLATE_NOOP("Inspector", "Matter");
constexpr const char* connection = QT_TRANSLATE_NOOP("Inspector", "Connector");
constexpr const char* collisions = QT_TRANSLATE_NOOP("Inspector", "Collisions");
constexpr const char* level = QT_TRANSLATE_NOOP("Inspector", "General");
constexpr const char* rules = QT_TRANSLATE_NOOP("Inspector", "Rules of the game");
constexpr const char* physics = QT_TRANSLATE_NOOP("Inspector", "Physics");

// clang-format off
constexpr std::array rowsOfObjects{
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Name"), "name", RowKind::Text},
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Kind"), "kind", RowKind::Choice, 0, "", kinds},
    FormRow{place, QT_TRANSLATE_NOOP("Inspector", "Position"), "position.x", RowKind::Number, 0.05},
    FormRow{place, "", "position.y", RowKind::Number, 0.05},
    FormRow{place, QT_TRANSLATE_NOOP("Inspector", "Angle"), "angle", RowKind::Number, 5},
    FormRow{place, QT_TRANSLATE_NOOP("Inspector", "From"), "a.x", RowKind::Number, 0.05},
    FormRow{place, "", "a.y", RowKind::Number, 0.05},
    FormRow{place, QT_TRANSLATE_NOOP("Inspector", "To"), "b.x", RowKind::Number, 0.05},
    FormRow{place, "", "b.y", RowKind::Number, 0.05},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Radius"), "radius", RowKind::Number, 0.05},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Depth"), "depth", RowKind::Number, 0.05, QT_TRANSLATE_NOOP("Inspector", "no back")},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Closed: the last point joins the first"), "closed", RowKind::Switch},
    FormRow{matter, QT_TRANSLATE_NOOP("Inspector", "Mass"), "mass", RowKind::Number, 0.1, QT_TRANSLATE_NOOP("Inspector", "from shape")},
    FormRow{matter, QT_TRANSLATE_NOOP("Inspector", "Density"), "density", RowKind::Number, 0.1},
    FormRow{matter, QT_TRANSLATE_NOOP("Inspector", "Restitution"), "restitution", RowKind::Number, 0.05},
    FormRow{matter, QT_TRANSLATE_NOOP("Inspector", "Friction"), "friction", RowKind::Number, 0.05},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Velocity"), "velocity.x", RowKind::Number, 0.1},
    FormRow{motion, "", "velocity.y", RowKind::Number, 0.1},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Spin"), "angularVelocity", RowKind::Number, 5},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Linear damping"), "linearDamping", RowKind::Number, 0.05},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Angular damping"), "angularDamping", RowKind::Number, 0.05},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Frozen: held in place"), "frozen", RowKind::Switch},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Anchor on first"), "anchorA.x", RowKind::Number, 0.05},
    FormRow{connection, "", "anchorA.y", RowKind::Number, 0.05},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Anchor on second"), "anchorB.x", RowKind::Number, 0.05},
    FormRow{connection, "", "anchorB.y", RowKind::Number, 0.05},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Length"), "length", RowKind::Number, 0.05, QT_TRANSLATE_NOOP("Inspector", "as placed")},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Stiffness"), "stiffness", RowKind::Number, 10},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Damping"), "damping", RowKind::Number, 0.5},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Tension"), "truncation", RowKind::Choice, 0, "", truncations},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Limit"), "limit", RowKind::Number, 10},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Untouched part"), "proportion", RowKind::Number, 0.05},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Slack: pulls only"), "slack", RowKind::Switch},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Its two bodies may collide"), "bodiesCollide", RowKind::Switch},
    FormRow{collisions, QT_TRANSLATE_NOOP("Inspector", "Tangible: others bounce off it"), "tangible", RowKind::Switch},
    FormRow{collisions, QT_TRANSLATE_NOOP("Inspector", "Is"), "tags", RowKind::Tags},
    FormRow{collisions, QT_TRANSLATE_NOOP("Inspector", "Touches"), "touches", RowKind::Touches},
};

constexpr std::array rowsOfLevel{
    FormRow{level, QT_TRANSLATE_NOOP("Inspector", "Name"), "name", RowKind::Text},
    FormRow{level, QT_TRANSLATE_NOOP("Inspector", "Author"), "author", RowKind::Text},
    FormRow{level, QT_TRANSLATE_NOOP("Inspector", "Description"), "description", RowKind::LongText},
    FormRow{level, QT_TRANSLATE_NOOP("Inspector", "Background"), "background", RowKind::Background},
    FormRow{rules, QT_TRANSLATE_NOOP("Inspector", "Lives"), "lives", RowKind::Number, 1},
    FormRow{rules, QT_TRANSLATE_NOOP("Inspector", "Tow range"), "towRange", RowKind::Number, 0.1},
    FormRow{rules, QT_TRANSLATE_NOOP("Inspector", "Towing turns gravity round"), "flipGravityOnTow", RowKind::Switch},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Gravity"), "gravity.x", RowKind::Number, 0.05},
    FormRow{physics, "", "gravity.y", RowKind::Number, 0.05},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Update"), "updateSeconds", RowKind::Number, 0.005},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Iterations"), "iterations", RowKind::Number, 1},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Sub-steps"), "substeps", RowKind::Number, 1},
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
