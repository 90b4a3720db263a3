#pragma once
// Shows over a level what is different from another one: green what has come, red what has gone, amber what has
// changed, with the outline it had, dashed. Each has a sign beside it, for people who see fewer colours.

#include "core/level/compare.h"
#include "editor/canvas/stage.h"

#include <memory>
#include <utility>
#include <vector>

namespace spacetow {

/// What the canvas needs to know of a comparison; immutable, made by any thread.
class ShownDifference {
  public:
    ShownDifference(std::shared_ptr<const Level> before, const LevelDifference& difference);

    const Level& before() const { return *m_before; }
    /// Of the object with this key; none for one that is not different.
    const ObjectChange* changeOf(Key key) const;
    bool empty() const { return m_changes.empty(); }

  private:
    std::shared_ptr<const Level> m_before;
    std::vector<std::pair<Key, ObjectChange>> m_changes; // ascending by key
};

/// Only what is in view costs time.
void paintDifference(const Stage& stage, const Level& after, const ShownDifference& difference);

} // namespace spacetow
