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
    /// The state after an update; the same one twice counts once. Of a run that has gone back, what came later goes.
    void note(const Session& session);
    void forget();
    std::span<const DebugTrail> trails() const { return m_trails; }

  private:
    void forgetAfter(std::int64_t update);

    std::vector<BodyId> m_bodies; // whose they are
    std::vector<DebugTrail> m_trails;
    std::vector<std::int64_t> m_updates; // that have been noted, as far back as the longest trail
};

} // namespace spacetow
