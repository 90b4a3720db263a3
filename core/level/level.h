#pragma once
// The level document as a value: what the editor shows, the file spells and play starts from. Metres, radians, y up.
// Objects are held as shared immutable pieces, so that a copy of a level costs pointers only.

#include "core/level/level_shape.h"
#include "core/level/object_list.h"
#include "core/level/tag_table.h"
#include "core/physics/def/body.h"
#include "core/physics/def/connector.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace spacetow {

/// A rigid body. Mass properties come from the shapes unless a mass is given.
struct BodyObject {
    BodyKind kind = BodyKind::Static;
    ShapeList shapes; // local coordinates, at least one
    Vec2 position{0, 0};
    double angle = 0;
    Vec2 velocity{0, 0};
    double angularVelocity = 0;
    std::optional<double> mass; // kg
    double density = 1;         // kg/m²
    double restitution = 0;
    double friction = 0.3;
    double linearDamping = 0;  // 1/s
    double angularDamping = 0; // 1/s
    Filter filter;
    bool tangible = true;
    bool frozen = false;

    bool operator==(const BodyObject&) const = default;
};

/// Outline of the ship about its centre of mass, nose up, anticlockwise; the third corner is the notch at the stern.
/// No corner is further than 0.2604 m from the centre.
std::array<Vec2, 4> shipOutline();

/// Where the ship starts.
struct ShipObject {
    Vec2 position{0, 0}; // of its centre of mass
    double angle = 0;

    bool operator==(const ShipObject&) const = default;
};

/// Where the payload waits: a ball.
struct PayloadObject {
    Vec2 position{0, 0};
    double radius = 0.2; // m
    double mass = 0.25;  // kg
    double restitution = 0.5;
    double linearDamping = 0.3; // 1/s

    bool operator==(const PayloadObject&) const = default;
};

/// The payload wins by crossing this segment, from either side.
struct FinishObject {
    Vec2 a{0, 0};
    Vec2 b{1, 0};

    bool operator==(const FinishObject&) const = default;
};

/// A damped spring between two bodies, named by their keys.
struct ConnectorObject {
    Key a = 0, b = 0;
    Vec2 anchorA{0, 0}, anchorB{0, 0}; // local coordinates of each body
    std::optional<double> length;      // m; without it the distance at the start
    double stiffness = 100;            // N/m
    double damping = 0;                // N s/m
    bool slack = false;
    bool bodiesCollide = false;
    TruncationRule truncation = TruncationRule::None; // never Custom
    double limit = 0;                                 // N
    double proportion = 0.5;

    bool operator==(const ConnectorObject&) const = default;
};

/// Objects that belong together: those that name it as their parent. It has no place of its own.
struct GroupObject {
    bool layer = false;                 // a group at the top that the outliner shows as a layer
    std::optional<std::uint32_t> color; // 0xRRGGBB, of its mark in the outliner and of what is selected in it

    bool operator==(const GroupObject&) const = default;
};

using ObjectData = std::variant<BodyObject, ShipObject, PayloadObject, FinishObject, ConnectorObject, GroupObject>;

struct Object {
    Key key = 0;
    std::string name; // for people; may be empty or shared
    ObjectData data;
    /// Fields of the file that this version does not know, kept for the next save: JSON object text whose names are
    /// JSON pointers within this object ({"/glow": 1, "/shapes/0/glow": 2}); empty for none.
    std::string unknownFields;
    Key parent = 0; // the group that it is in; 0 at the top
    // For the editor alone: what is hidden or locked is played all the same. A group passes both on to its members.
    bool visible = true;
    bool locked = false; // is not picked, moved or deleted

    bool operator==(const Object&) const = default;
};

/// A line without an end that points snap to. Not part of the game.
struct Guide {
    Vec2 point{0, 0};
    double angle = 0; // rad, of its direction; 0 is horizontal
    std::string name;

    bool operator==(const Guide&) const = default;
};

/// What lint finds and the author has seen and wants to see no more: the code of the problem, of one object.
struct HiddenProblem {
    std::string rule;
    Key object = 0; // 0 for the level itself

    bool operator==(const HiddenProblem&) const = default;
};

/// Whatever else a level names is shown as a plain one.
inline constexpr std::array<std::string_view, 2> shippedBackgrounds{"stars", "plain"};

/// The rope that tows the payload: stiff, but never pulling harder than the limit.
struct RopeRules {
    double stiffness = 50'000;                               // N/m
    double damping = 100;                                    // N s/m
    TruncationRule truncation = TruncationRule::PartialTanh; // never Custom
    double limit = 150;                                      // N
    double proportion = 0.75;                                // of the limit, up to which the tension is exact

    bool operator==(const RopeRules&) const = default;
};

/// The rules of a game of SpaceTow in this level, and how the ship flies. The figures of a new level were chosen by
/// playing.
struct Rules {
    int lives = 3;         // attempts, ≥ 1
    double towRange = 1.5; // m, between the centres of ship and payload
    bool flipGravityOnTow = false;
    std::string background = "stars"; // name of a shipped background
    double thrust = 2.375;            // N, along the nose: two and a half times the ship's weight in a new level
    double steering = 6;              // rad/s², while a direction is held
    double shipMass = 1;              // kg
    double shipRestitution = 0.3;
    double shipLinearDamping = 0.15; // 1/s
    double shipAngularDamping = 2.5; // 1/s
    RopeRules rope;

    bool operator==(const Rules&) const = default;
};

struct Level {
    std::string name;
    std::string author;
    std::string description;
    Vec2 gravity{0, -0.95}; // m/s²
    double updateSeconds = 0.02;
    int iterations = 100;
    int substeps = 2;
    bool sleeping = true; // bodies that have come to rest are left alone until something touches them
    Rules rules;
    TagTable tags;
    std::vector<Guide> guides;
    std::vector<HiddenProblem> hiddenProblems;
    ObjectList objects;
    std::string unknownFields; // as in Object, of the level itself; tags are counted by their index

    bool operator==(const Level&) const = default;
};

/// A key that no object of the level has, chosen by `seed` (any number; equal seeds, equal keys).
Key freshKey(const Level& level, std::uint64_t seed);

/// The single object of this kind, or null when there is none; the first of several.
template <class T>
const Object* firstOf(const Level& level) {
    for (const Object& object : level.objects) {
        if (std::holds_alternative<T>(object.data)) {
            return &object;
        }
    }
    return nullptr;
}

} // namespace spacetow
