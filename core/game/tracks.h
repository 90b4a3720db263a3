#pragma once
// Where ship and payload have been, or in a level without a ship the first of the bodies that move.

#include "core/game/session.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace spacetow {

/// Of the centre of mass, metres.
struct TracedPath {
    Key object = 0;
    std::vector<Vec2> points;
};

/// A future that did not come to pass.
struct Ghost {
    std::int64_t from = 0; // updates after which it was given up
    std::vector<TracedPath> paths;
};

class Tracks {
  public:
    static constexpr std::size_t mostBodies = 64;     // of a sandbox, and as many that are added while it runs
    static constexpr double tolerance = 0.01;         // m, of thinned paths
    static constexpr std::size_t mostPoints = 12'000; // of one body; of more, every other one goes

    /// The object that somebody looks at, 0 for none: it is followed in any case, from the next update on.
    void setFocus(Key object);
    /// After this update.
    void add(const Session& session);
    void forgetBefore(std::int64_t update);
    void forgetAfter(std::int64_t update);
    /// Of the updates from this one on; one path more for each time that a body was away. Those that go nowhere are
    /// left out.
    std::vector<TracedPath> pathsFrom(std::int64_t update) const;
    std::size_t bytes() const;

  private:
    struct Track {
        Key object;
        std::int64_t first;      // update of the first point
        std::deque<Vec2> points; // one a stride; not finite while it was away
    };

    void choose(const Session& session);
    void follow(Key object, std::int64_t update);
    void doubleStride();

    std::vector<Track> m_tracks;
    Key m_focus = 0;
    std::int64_t m_stride = 1;            // updates; there are points of its multiples
    std::shared_ptr<const Level> m_level; // for which they were chosen
};

} // namespace spacetow
