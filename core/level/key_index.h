#pragma once
// Looks objects up by key in logarithmic time, for passes over a whole level. Holds pointers into the level: keep it
// no longer than the level lives unchanged.

#include "core/level/level.h"

#include <utility>
#include <vector>

namespace spacetow {

class KeyIndex {
  public:
    explicit KeyIndex(const ObjectList& objects);

    /// The object with this key, the first of several; null when there is none.
    const Object* find(Key key) const;

  private:
    std::vector<std::pair<Key, const Object*>> m_entries; // by key, equal keys in the order of the level
};

} // namespace spacetow
