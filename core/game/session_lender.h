#pragma once
// Copies of a session for other threads. Freeing a large one takes as long as copying it, so that whoever looks at it
// last only gives it back, and the thread that made it frees it.

#include "core/game/session.h"

#include <memory>
#include <mutex>
#include <vector>

namespace spacetow {

class SessionLender {
  public:
    /// Can be held for as long as one likes, also when the lender is gone.
    std::shared_ptr<const Session> copyOf(const Session& session);
    /// Frees what has been given back.
    void collect();

  private:
    struct Returned {
        std::mutex mutex;
        std::size_t lent = 0; // that have not been freed yet
        std::vector<std::unique_ptr<const Session>> sessions;
    };
    std::shared_ptr<Returned> m_returned{std::make_shared<Returned>()};
};

} // namespace spacetow
