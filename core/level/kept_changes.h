#pragma once
// What has been changed in a level, as a list of which each entry can be kept or left out by itself: what a user would
// call one change. Built on core/level/compare.h, whose words tell each of them.

#include "core/level/compare.h"

#include <span>
#include <vector>

namespace spacetow {

struct LevelChange {
    LevelDifference what; // this one alone: of the level, or of one object
    Key object = 0;       // 0: the level itself
    bool guides = false;  // all guides together, for their order counts
    /// Places in the list of those that have to be kept with it, ascending: a connector needs the bodies that it holds,
    /// a body the group that it is in. Theirs have to be looked up as well, see `keptTogether`.
    std::vector<int> needs;
};

/// Empty exactly when the levels are equal. What belongs together is one: both coordinates of a point, place and angle,
/// the two ends of a connector. First those of the level, then as `differenceBetween` has the objects.
std::vector<LevelChange> changesBetween(const Level& before, const Level& after);

/// The places and those of all that they need, ascending.
std::vector<int> keptTogether(std::span<const LevelChange> changes, std::span<const int> places);

/// `before` with those of its changes to `after` that are named by their places, and with what these need. With all of
/// them it is `after`, with none `before`. Shares with `before` what is not changed.
Level withKept(const Level& before, const Level& after, std::span<const LevelChange> changes,
               std::span<const int> places);

/// The same one change after the other. A level costs what its change does, and that of the order where it has one, not
/// what all those before it do.
class ChangesKept {
  public:
    /// All of them must outlive it; the changes are those between the levels.
    ChangesKept(const Level& before, const Level& after, std::span<const LevelChange> changes);

    /// `withKept` of this place and all that were kept before.
    Level with(int place);

  private:
    void take(int place);

    const Level& m_before;
    const Level& m_after;
    std::span<const LevelChange> m_changes;
    Level m_taken; // with the fields of what is kept; objects come, go and change places at last
    std::vector<bool> m_isKept;
    std::vector<int> m_kept;
};

} // namespace spacetow
