#pragma once
// Where the bodies of a run have been lately, for the overlay of their trails. As many points a body as can be drawn
// in every frame, however many bodies there are.

#include "core/game/session.h"
#include "core/physics/query/debug_draw.h"

#include <span>
#include <vector>

namespace spacetow {

class TrailKeeper {
  public:
    /// The state after an update; the same one twice counts once. A run that has gone back begins anew.
    void note(const Session& session);
    void forget();
    std::span<const DebugTrail> trails() const { return m_trails; }

  private:
    std::vector<BodyId> m_bodies; // whose they are
    std::vector<DebugTrail> m_trails;
    std::int64_t m_update = -1; // noted last
};

} // namespace spacetow
