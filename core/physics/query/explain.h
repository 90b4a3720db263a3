#pragma once
// Why a body moves as it does: who pushes and pulls it, what it touches, its energy and momentum; the same of
// connectors, and the sums of a world. All of it is read after an update and changes nothing. SI units, radians.

#include "core/physics/world/world.h"

#include <optional>
#include <vector>

namespace spacetow {

/// Two bodies that touch, or did so within the last update. Impulses are those of that update: all of them when the
/// world records impulses, else those of the last iteration times the number of iterations.
struct ContactReading {
    BodyId a, b;              // a was added to the world before b
    bool solid = true;        // false when one of them is intangible, or none can be moved
    bool touching = true;     // false: only within the update
    Vec2 point{0, 0};         // world, in the middle of what touches
    Vec2 normal{0, 1};        // unit, from a to b; of sensors without meaning
    double normalImpulse = 0; // N s, along the normal on b, and against it on a
    double friction = 0;      // N s on b, to the left of the normal
    Vec2 impulse{0, 0};       // N s on b, of both
    double turnA = 0;         // N m s on a about its centre of mass
    double turnB = 0;         // likewise on b
};

/// In which the impulses of contacts were given, s: how long the last update was.
double impulseSeconds(const World& world);

/// Of one body with all others. One look at each pair of the world.
std::vector<ContactReading> contactsOf(const World& world, BodyId body);

struct ForceReading {
    Vec2 force{0, 0};  // N
    double torque = 0; // N m, about the centre of mass
};

/// What acts on a body, by where it comes from. At the end of the last update, but for contacts: their impulses, spread
/// over all of it.
struct BodyForces {
    ForceReading gravity;
    ForceReading applied;    // by the owner of the world: thrust, say; during all of the update
    ForceReading connectors; // of the last sub-step
    ForceReading fields;
    ForceReading contacts;
    ForceReading damping;

    ForceReading sum() const;
};

struct BodyEnergy {
    double kinetic = 0;   // J, of moving and turning
    double potential = 0; // J, in gravity, at the world's origin 0
};

/// Of a body that no force moves all is zero but what it touches.
struct BodyReading {
    BodyForces forces;
    BodyEnergy energy;
    Vec2 momentum{0, 0};        // kg m/s
    double spin = 0;            // kg m²/s about its own centre of mass
    double angularMomentum = 0; // kg m²/s about the world's origin
    TagMask touchedTags;        // of all that it touched in the last iteration
};
BodyReading explained(const World& world, BodyId body);

struct ConnectorReading {
    double distance = 0; // m, between the anchors
    double length = 0;   // m, natural
    double tension = 0;  // N, positive when it pulls
    double energy = 0;   // J, that it took to stretch it so far
};
ConnectorReading explained(const World& world, ConnectorId connector);

/// What there is, and how much of it the engine works on.
struct WorldCounters {
    int statics = 0, kinematics = 0, dynamics = 0; // bodies
    int awake = 0, asleep = 0;                     // of those that may move
    int pairs = 0;                                 // of parts that may meet
    int contacts = 0;                              // pairs that touch
    int treeCells = 0;                             // leaves of the quadtrees
    int islands = 0;                               // components of the contact graph, of bodies that are awake
    int connectors = 0;
};

struct WorldReading {
    double kinetic = 0, potential = 0, elastic = 0; // J; their sum is World::energy
    Vec2 momentum{0, 0};                            // kg m/s, of dynamic bodies
    double motion = 0;                              // kg m/s: the momenta of all, whatever their directions
    double angularMomentum = 0;                     // kg m²/s, likewise, about the origin

    double energy() const { return kinetic + potential + elastic; }
};
WorldReading totals(const World& world);
/// Linear in what is in the world.
WorldCounters counters(const World& world);

} // namespace spacetow
