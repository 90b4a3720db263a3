#pragma once
// Small levels for tests of the game, and the pressing of keys.

#include "core/game/session.h"
#include "core/level/level.h"

namespace spacetow::test {

constexpr Key shipKey = 1, payloadKey = 2, finishKey = 3;

/// Without gravity and walls: the ship at the origin, the payload one metre below, the finish two metres above across
/// twenty metres. Ten iterations an update.
Level openSpace();
/// openSpace with the payload elsewhere.
Level openSpaceWithPayloadAt(const Vec2& position);
/// A static one-way wall, solid for what comes from the left of a→b.
void addWall(Level& level, const Vec2& a, const Vec2& b);
/// A dynamic ball with the wall tag.
void addBall(Level& level, const Vec2& position, double radius, const Vec2& velocity);

/// openSpace with a wall above the ship: holding thrust crashes into it.
Level spaceWithCeiling();

constexpr Controls idle{};
constexpr Controls left{.left = true};
constexpr Controls right{.right = true};
constexpr Controls thrust{.thrust = true};
constexpr Controls tow{.tow = true};

void hold(Session& session, const Controls& controls, int updates);
/// One update with the keys down after one without, so that it is a fresh press.
void press(Session& session, const Controls& controls);
/// Holds the keys until the phase comes; false when it has not come after `updates`.
bool holdUntil(Session& session, const Controls& controls, Phase phase, int updates = 2000);

/// A session of openSpace in which the ship has just taken the payload in tow.
Session towing(const Level& level);

/// Statics, kinematics, dynamics.
std::vector<BodyPicture> allBodies(const Snapshot& picture);
/// How many bodies of the role are in the picture.
std::size_t count(const Session& session, BodyRole role);
/// The sound began with the last update.
bool heard(const Session& session, Sound sound);

} // namespace spacetow::test
