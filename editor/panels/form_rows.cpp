#include "editor/panels/form_rows.h"

#include <QCoreApplication>

#include <array>
#include <charconv>
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
constexpr const char* shipFigures = QT_TRANSLATE_NOOP("Inspector", "Ship");
constexpr const char* ropeFigures = QT_TRANSLATE_NOOP("Inspector", "Tow rope");
constexpr const char* physics = QT_TRANSLATE_NOOP("Inspector", "Physics");

// clang-format off
constexpr std::array rowsOfObjects{
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Name"), "name", RowKind::Text, QT_TRANSLATE_NOOP("Inspector", "For people; several objects may share one")},
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Kind"), "kind", RowKind::Choice, QT_TRANSLATE_NOOP("Inspector", "Static bodies never move, kinematic ones move as told and are pushed by nothing, dynamic ones obey forces"), 0, "", kinds},
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Group"), "parent", RowKind::Group, QT_TRANSLATE_NOOP("Inspector", "Name or key of the group that it is in; nothing for none")},
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Color"), "color", RowKind::Color, QT_TRANSLATE_NOOP("Inspector", "Of the group's mark and of what is selected in it")},
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Layer: a group at the top"), "layer", RowKind::Switch},
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Visible in the editor"), "visible", RowKind::Switch},
    FormRow{object, QT_TRANSLATE_NOOP("Inspector", "Locked: cannot be picked or moved"), "locked", RowKind::Switch},
    FormRow{place, QT_TRANSLATE_NOOP("Inspector", "Position"), "position.x", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Where the origin of the object is"), 0.05},
    FormRow{place, "", "position.y", RowKind::Number, "", 0.05},
    FormRow{place, QT_TRANSLATE_NOOP("Inspector", "Angle"), "angle", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Anticlockwise. Plain numbers are degrees; write “rad” after radians"), 5},
    FormRow{place, QT_TRANSLATE_NOOP("Inspector", "From"), "a.x", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "One end of the finish"), 0.05},
    FormRow{place, "", "a.y", RowKind::Number, "", 0.05},
    FormRow{place, QT_TRANSLATE_NOOP("Inspector", "To"), "b.x", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "The other end of the finish"), 0.05},
    FormRow{place, "", "b.y", RowKind::Number, "", 0.05},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Center"), "center.x", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Middle of the circle in the coordinates of its body"), 0.05},
    FormRow{shape, "", "center.y", RowKind::Number, "", 0.05},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Radius"), "radius", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "From the middle to the rim"), 0.05},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Width"), "width", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Of the rectangle, along its own side; the middle stays where it is"), 0.05},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Height"), "height", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Of the rectangle, along its own side; the middle stays where it is"), 0.05},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Points"), "vertices", RowKind::Points, QT_TRANSLATE_NOOP("Inspector", "How many corners the shape has; move them on the canvas")},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Depth"), "depth", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "How far behind the line counts as inside the wall; nothing for a wall without a back"), 0.05, QT_TRANSLATE_NOOP("Inspector", "no back")},
    FormRow{shape, QT_TRANSLATE_NOOP("Inspector", "Closed: the last point joins the first"), "closed", RowKind::Switch},
    FormRow{matter, QT_TRANSLATE_NOOP("Inspector", "Mass"), "mass", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Nothing: area times density"), 0.1, QT_TRANSLATE_NOOP("Inspector", "from shape")},
    FormRow{matter, QT_TRANSLATE_NOOP("Inspector", "Density"), "density", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Counts while no mass is given; a metre of wall weighs 1 kg times the density"), 0.1},
    FormRow{matter, QT_TRANSLATE_NOOP("Inspector", "Restitution"), "restitution", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Share of the speed that is left after a bounce"), 0.05},
    FormRow{matter, QT_TRANSLATE_NOOP("Inspector", "Friction"), "friction", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Coefficient of friction: force along a surface per force on it"), 0.05},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Velocity"), "velocity.x", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Of the center of mass at the start"), 0.1},
    FormRow{motion, "", "velocity.y", RowKind::Number, "", 0.1},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Spin"), "angularVelocity", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Turning at the start, anticlockwise"), 5},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Linear damping"), "linearDamping", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Share of the velocity that is lost each second"), 0.05},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Angular damping"), "angularDamping", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Share of the spin that is lost each second"), 0.05},
    FormRow{motion, QT_TRANSLATE_NOOP("Inspector", "Frozen: held in place"), "frozen", RowKind::Switch},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "First body"), "a", RowKind::Body, QT_TRANSLATE_NOOP("Inspector", "Name or key of the body that it holds")},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Second body"), "b", RowKind::Body, QT_TRANSLATE_NOOP("Inspector", "Name or key of the other body that it holds")},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Anchor on first"), "anchorA.x", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Where it holds the first body, in the coordinates of that"), 0.05},
    FormRow{connection, "", "anchorA.y", RowKind::Number, "", 0.05},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Anchor on second"), "anchorB.x", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Where it holds the second body, in the coordinates of that"), 0.05},
    FormRow{connection, "", "anchorB.y", RowKind::Number, "", 0.05},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Length"), "length", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "At which it neither pulls nor pushes; nothing: the distance at the start"), 0.05, QT_TRANSLATE_NOOP("Inspector", "as placed")},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Stiffness"), "stiffness", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Force per metre of stretch"), 10},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Damping"), "damping", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Force against the speed of stretching"), 0.5},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Tension"), "truncation", RowKind::Choice, QT_TRANSLATE_NOOP("Inspector", "How the force of the spring is limited"), 0, "", truncations},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Limit"), "limit", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Most tension, where it is limited"), 10},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Untouched part"), "proportion", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Share of the limit below which “partial tanh” changes nothing"), 0.05},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Slack: pulls only"), "slack", RowKind::Switch},
    FormRow{connection, QT_TRANSLATE_NOOP("Inspector", "Its two bodies may collide"), "bodiesCollide", RowKind::Switch},
    FormRow{collisions, QT_TRANSLATE_NOOP("Inspector", "Tangible: others bounce off it"), "tangible", RowKind::Switch},
    FormRow{collisions, QT_TRANSLATE_NOOP("Inspector", "Is"), "tags", RowKind::Tags, QT_TRANSLATE_NOOP("Inspector", "Tags that say what it is")},
    FormRow{collisions, QT_TRANSLATE_NOOP("Inspector", "Touches"), "touches", RowKind::Touches, QT_TRANSLATE_NOOP("Inspector", "Two bodies meet when each touches a tag that the other has")},
};

constexpr std::array rowsOfLevel{
    FormRow{level, QT_TRANSLATE_NOOP("Inspector", "Name"), "name", RowKind::Text, QT_TRANSLATE_NOOP("Inspector", "Of the level, as players see it")},
    FormRow{level, QT_TRANSLATE_NOOP("Inspector", "Author"), "author", RowKind::Text, QT_TRANSLATE_NOOP("Inspector", "Who made it")},
    FormRow{level, QT_TRANSLATE_NOOP("Inspector", "Description"), "description", RowKind::LongText},
    FormRow{level, QT_TRANSLATE_NOOP("Inspector", "Background"), "background", RowKind::Background},
    FormRow{rules, QT_TRANSLATE_NOOP("Inspector", "Lives"), "lives", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Attempts"), 1},
    FormRow{rules, QT_TRANSLATE_NOOP("Inspector", "Tow range"), "towRange", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Greatest distance of ship and payload at which the rope can be attached"), 0.1},
    FormRow{rules, QT_TRANSLATE_NOOP("Inspector", "Towing turns gravity round"), "flipGravityOnTow", RowKind::Switch},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Gravity"), "gravity.x", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Acceleration of everything that falls"), 0.05},
    FormRow{physics, "", "gravity.y", RowKind::Number, "", 0.05},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Update"), "updateSeconds", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Time that one update simulates"), 0.005},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Iterations"), "iterations", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Passes of motion and collision in one update; more are more exact and slower"), 1},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Sub-steps"), "substeps", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Steps of motion in one iteration"), 1},
    FormRow{physics, QT_TRANSLATE_NOOP("Inspector", "Bodies at rest sleep"), "sleeping", RowKind::Switch},
    FormRow{shipFigures, QT_TRANSLATE_NOOP("Inspector", "Thrust"), "thrust", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Force along the nose of the ship"), 0.1},
    FormRow{shipFigures, QT_TRANSLATE_NOOP("Inspector", "Steering"), "steering", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "How fast the ship begins to turn while a direction is held"), 10},
    FormRow{shipFigures, QT_TRANSLATE_NOOP("Inspector", "Mass"), "shipMass", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Of the ship alone"), 0.1},
    FormRow{shipFigures, QT_TRANSLATE_NOOP("Inspector", "Restitution"), "shipRestitution", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Share of the speed that is left after a bounce"), 0.05},
    FormRow{shipFigures, QT_TRANSLATE_NOOP("Inspector", "Linear damping"), "shipLinearDamping", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Share of the velocity that is lost each second"), 0.05},
    FormRow{shipFigures, QT_TRANSLATE_NOOP("Inspector", "Angular damping"), "shipAngularDamping", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Share of the spin that is lost each second"), 0.1},
    FormRow{ropeFigures, QT_TRANSLATE_NOOP("Inspector", "Stiffness"), "stiffness", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Force per metre of stretch"), 1000},
    FormRow{ropeFigures, QT_TRANSLATE_NOOP("Inspector", "Damping"), "damping", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Force against the speed of stretching"), 10},
    FormRow{ropeFigures, QT_TRANSLATE_NOOP("Inspector", "Tension"), "truncation", RowKind::Choice, QT_TRANSLATE_NOOP("Inspector", "How the force of the spring is limited"), 0, "", truncations},
    FormRow{ropeFigures, QT_TRANSLATE_NOOP("Inspector", "Limit"), "limit", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Most tension, where it is limited"), 10},
    FormRow{ropeFigures, QT_TRANSLATE_NOOP("Inspector", "Untouched part"), "proportion", RowKind::Number, QT_TRANSLATE_NOOP("Inspector", "Share of the limit below which “partial tanh” changes nothing"), 0.05},
};
// clang-format on

constexpr double pi = std::numbers::pi;
constexpr double half = 180; // degrees

bool isAngle(std::string_view unit) {
    return unit == "rad" || unit == "rad/s" || unit == "rad/s²";
}

/// The number with so many significant digits.
double withDigits(double number, int digits) {
    std::array<char, 40> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::scientific, digits - 1).ptr;
    std::from_chars(text.data(), end, number);
    return number;
}

} // namespace

QString rowText(const char* words) {
    return *words == '\0' ? QString() : QCoreApplication::translate("Inspector", words);
}

std::span<const FormRow> objectRows() {
    return rowsOfObjects;
}

std::span<const FormRow> levelRows() {
    return rowsOfLevel;
}

const char* shownUnit(const char* unit) {
    const std::string_view stored = unit;
    return stored == "rad" ? "°" : stored == "rad/s" ? "°/s" : stored == "rad/s²" ? "°/s²" : unit;
}

double storedNumber(double shown, const char* unit) {
    return isAngle(unit) ? shown * pi / half : shown;
}

double shownNumber(double stored, const char* unit) {
    if (!isAngle(unit)) {
        return stored;
    }
    const double degrees = stored * half / pi;
    for (const int digits : {15, 16, 17}) {
        const double shorter = withDigits(degrees, digits);
        if (storedNumber(shorter, unit) == stored) {
            return shorter;
        }
    }
    return degrees;
}

} // namespace spacetow
