#pragma once
// Explanations: the forces on a body, its contacts, energy and momentum; connectors; sums over a world. Call these
// functions after an update; they do not change the world. SI units, radians.

#include "core/physics/world/world.h"

#include <optional>
#include <vector>

namespace spacetow {

/// Two bodies that touch, or touched during the last update. Impulses are the sums over that update if the world
/// records impulses, else those of the last iteration times the number of iterations.
struct ContactReading {
    BodyId a, b;              // a is the one that was added to the world first
    bool solid = true;        // false when a or b is intangible, or neither can move
    bool touching = true;     // false: they touched during the update, and no longer do
    Vec2 point{0, 0};         // world, the mean of the contact points
    Vec2 normal{0, 1};        // unit, from a to b; undefined for sensors
    double normalImpulse = 0; // N s, along `normal` on b, opposite on a
    double friction = 0;      // N s on b, positive to the left of `normal`
    Vec2 impulse{0, 0};       // N s on b: normal impulse and friction
    double turnA = 0;         // N m s: angular impulse on a about its centre of mass
    double turnB = 0;         // N m s: the same for b
};

/// The time over which the impulses of contacts acted, s: the length of the last update.
double impulseSeconds(const World& world);

/// The contacts of one body. Linear in the pairs of the world.
std::vector<ContactReading> contactsOf(const World& world, BodyId body);

struct ForceReading {
    Vec2 force{0, 0};  // N
    double torque = 0; // N m, about the centre of mass
};

/// The forces on a body by source, at the end of the last update. The force of contacts is their impulse over the last
/// update, divided by the length of that update.
struct BodyForces {
    ForceReading gravity;
    ForceReading applied;    // by World::applyForce and applyTorque, for example thrust
    ForceReading connectors; // of the last sub-step
    ForceReading contacts;
    ForceReading damping;

    ForceReading sum() const;
};

struct BodyEnergy {
    double kinetic = 0;   // J, translation and rotation
    double potential = 0; // J, in gravity; 0 at the world's origin
};

/// For static and kinematic bodies all members but `touchedTags` are zero.
struct BodyReading {
    BodyForces forces;
    BodyEnergy energy;
    Vec2 momentum{0, 0};        // kg m/s
    double spin = 0;            // kg m²/s about its own centre of mass
    double angularMomentum = 0; // kg m²/s about the world's origin
    TagMask touchedTags;        // of all bodies that this one touched in the last iteration
};
BodyReading explained(const World& world, BodyId body);

struct ConnectorReading {
    double distance = 0; // m, between the anchors
    double length = 0;   // m, natural
    double tension = 0;  // N, positive when it pulls
    double energy = 0;   // J, elastic
};
ConnectorReading explained(const World& world, ConnectorId connector);

/// Sizes of the world and of its working sets.
struct WorldCounters {
    int statics = 0, kinematics = 0, dynamics = 0; // bodies
    int awake = 0, asleep = 0;                     // of bodies that are not static
    int pairs = 0;                                 // of parts, in the pair table
    int contacts = 0;                              // pairs of parts that touch
    int treeCells = 0;                             // leaves of the quadtrees
    int islands = 0; // components of the contact graph with awake bodies; a kinematic body is one
    int connectors = 0;
};

struct WorldReading {
    double kinetic = 0;         // J
    double potential = 0;       // J, in the gravity of the world's parameters
    double elastic = 0;         // J, of connectors
    Vec2 momentum{0, 0};        // kg m/s, of dynamic bodies
    double motion = 0;          // kg m/s: the sum of the magnitudes of all momenta
    double angularMomentum = 0; // kg m²/s, of dynamic bodies, about the origin

    double energy() const { return kinetic + potential + elastic; }
};
/// Linear in bodies that are not static, and connectors.
WorldReading totals(const World& world);
/// Linear in bodies that are not static, pairs and tree cells.
WorldCounters counters(const World& world);

} // namespace spacetow
