#pragma once
// An immutable picture of a running session: all that painting, sound and the HUD need, and nothing live.

#include "core/game/controls.h"
#include "core/geometry/shape.h"
#include "core/level/level.h"
#include "core/math/transform.h"
#include "core/physics/def/body.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

enum class Phase : std::uint8_t {
    Sandbox,       // the level has no ship: physics alone
    AwaitingInput, // the ship is frozen until a direction is pressed
    Flying,
    Towing,
    Won,
    Crashed,  // a life is lost; any press tries again
    GameOver, // no life is left; any press starts the level over
};

enum class BodyRole : std::uint8_t { Object, Ship, Payload, Finish, Debris };

/// What is constant about a body; shared by all snapshots in which the body does not change.
struct BodyLook {
    std::uint64_t id; // the same for the same body throughout a session
    Key key;          // of its object, 0 for debris
    BodyRole role;
    BodyKind kind;
    bool tangible;
    std::uint32_t tags;
    std::vector<Shape> shapes; // local
};

struct BodyPicture {
    std::shared_ptr<const BodyLook> look;
    Transform pose;
    Vec2 velocity;
    double angularVelocity;
};

struct ConnectorPicture {
    Vec2 a, b;      // world
    double length;  // natural, m
    double tension; // N
};

/// What was heard since the last snapshot, one bit each.
enum class Sound : std::uint32_t {
    Start = 1,
    Thruster = 2,
    TowAttached = 4,
    TowBroken = 8,
    ShipLost = 16,
    PayloadLost = 32,
    Won = 64,
    Respawn = 128,
    GravityFlip = 256,
};

struct Hud {
    int lives;                // attempts left, this one included
    double fuel;              // s of thrust in this attempt
    double time;              // s in this attempt
    bool towInRange;          // pressing the tow key now would attach the rope
    double gravityFlippedFor; // s since gravity was flipped, negative when it is not
};

/// What ended an attempt.
struct Loss {
    bool ship = false, payload = false; // are lost by it
    BodyRole who = BodyRole::Ship;      // that hit something first, or the payload
    BodyRole whom = BodyRole::Object;   // it hit
    Key what = 0;                       // the object that it hit; 0 where that is not known
    std::uint32_t tags = 0;             // of what it hit that are fatal; 0 where it hit nothing

    bool operator==(const Loss&) const = default;
};

using BodyPictures = std::vector<BodyPicture>;

struct Snapshot {
    std::int64_t update = 0; // number of updates since the start
    Phase phase = Phase::Sandbox;
    Hud hud{};
    std::optional<Loss> loss; // while the attempt is over that it ended
    Vec2 camera{0, 0};        // world point in the middle of the view
    Controls controls;        // of the last update
    // Static bodies, in order of creation. The same list for as long as none of them changes; never null.
    std::shared_ptr<const BodyPictures> statics = std::make_shared<const BodyPictures>();
    BodyPictures moving; // kinematic bodies, then dynamic ones, each in order of creation
    std::vector<ConnectorPicture> connectors;
    std::uint32_t sounds = 0; // Sound bits

    std::size_t bodies() const { return statics->size() + moving.size(); }
    /// The first body that is such, of those that move before those that stand; null where none is. Linear.
    template <class Is>
    const BodyPicture* find(const Is& is) const {
        for (const BodyPictures* list : {&moving, statics.get()}) {
            for (const BodyPicture& body : *list) {
                if (is(body)) {
                    return &body;
                }
            }
        }
        return nullptr;
    }
};

/// Whether the ship waits for its pilot, and something else would move meanwhile.
bool wouldMoveUnsteered(const Snapshot& snapshot);
/// Whether the same bodies stand in the same places.
bool standAlike(const BodyPictures& a, const BodyPictures& b);

} // namespace spacetow
