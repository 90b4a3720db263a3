#pragma once
// A pilot that flies the ship, and the ship with its payload, along waypoints. It presses the same four keys as a
// player and sees what a player sees: positions, speeds and the angle of the ship. It avoids nothing by itself.

#include "core/game/controls.h"
#include "core/game/session.h"

#include <vector>

namespace spacetow {

struct Waypoint {
    Vec2 position{0, 0}; // of the ship's centre of mass
    double speed = 0.8;  // m/s, on the way to it
};

struct FlightPlan {
    std::vector<Waypoint> toPayload; // ends where the rope is to be attached
    std::vector<Waypoint> toFinish;  // of the ship, the payload hanging below or above it
};

/// How the pilot flies; the defaults suit the standard ship.
struct PilotHabits {
    double lookAhead = 0.35;      // m, along the route
    double eagerness = 2.2;       // 1/s, from error in velocity to acceleration
    double maxAcceleration = 0.9; // m/s², beyond hovering
    double swingDamping = 0.9;    // 1/s, from the payload's swing to acceleration
    double attitudeGain = 40;     // 1/s²
    double attitudeDamping = 9;   // 1/s
    double arrival = 0.12;        // m, from the end of the way to the payload before the rope is attached
};

class Autopilot {
  public:
    explicit Autopilot(FlightPlan plan, const PilotHabits& habits = {});

    /// What to hold down during the session's next update. To be called once an update.
    Controls next(const Session& session);

  private:
    Controls fly(const Session& session, const std::vector<Waypoint>& route);
    Vec2 wantedVelocity(const std::vector<Waypoint>& route, const Vec2& position);

    FlightPlan m_plan;
    PilotHabits m_habits;
    Phase m_phase = Phase::Sandbox; // at the last call
    std::size_t m_leg = 0;          // of the route, the leg that ends at this waypoint
    Vec2 m_legStart{0, 0};
    double m_thrustDebt = 0, m_turnDebt = 0; // what was wanted and not given yet, in updates
    Controls m_last;
};

} // namespace spacetow
