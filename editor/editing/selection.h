#pragma once
// The selected objects: a sorted set of keys.

#include "core/level/level.h"

#include <vector>

namespace spacetow {

class Selection {
  public:
    Selection() = default;
    explicit Selection(std::vector<Key> keys);

    const std::vector<Key>& keys() const { return m_keys; }
    bool empty() const { return m_keys.empty(); }
    int size() const { return static_cast<int>(m_keys.size()); }
    bool contains(Key key) const;

    Selection with(Key key) const;
    Selection without(Key key) const;
    Selection toggled(Key key) const;
    /// Without the keys that the level does not have.
    Selection within(const Level& level) const;

    bool operator==(const Selection&) const = default;

  private:
    std::vector<Key> m_keys; // ascending
};

} // namespace spacetow
