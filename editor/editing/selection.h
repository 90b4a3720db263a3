#pragma once
// What is selected: objects, and nodes of them. Beside it stands what belongs to the selection: the group that was
// entered, and the pivot about which it turns.

#include "core/level/nodes.h"

#include <optional>
#include <vector>

namespace spacetow {

class Selection {
  public:
    Selection() = default;
    explicit Selection(std::vector<Key> keys);
    /// The objects of the nodes are selected too.
    Selection(std::vector<Key> keys, std::vector<NodeRef> nodes);

    const std::vector<Key>& keys() const { return m_keys; }
    bool empty() const { return m_keys.empty(); }
    int size() const { return static_cast<int>(m_keys.size()); }
    bool contains(Key key) const;

    const std::vector<NodeRef>& nodes() const { return m_nodes; }
    bool contains(const NodeRef& node) const;

    /// The nodes of other objects stay selected; the pivot, which belonged to what was selected before, goes.
    Selection with(Key key) const;
    Selection without(Key key) const;
    Selection toggled(Key key) const;
    /// The same objects with these nodes, which must be nodes of them.
    Selection withNodes(std::vector<NodeRef> nodes) const;
    Selection toggled(const NodeRef& node) const;

    /// The group whose members a click selects; 0 for the top.
    Key entered() const { return m_entered; }
    Selection entering(Key group) const;

    /// World, m. Without one, what turns the selection takes the middle of its bounds.
    const std::optional<Vec2>& pivot() const { return m_pivot; }
    Selection withPivot(const std::optional<Vec2>& pivot) const;

    /// Without the objects and nodes that the level does not have.
    Selection within(const Level& level) const;

    bool operator==(const Selection&) const = default;

  private:
    std::vector<Key> m_keys;      // ascending
    std::vector<NodeRef> m_nodes; // ascending, of objects in m_keys
    Key m_entered = 0;
    std::optional<Vec2> m_pivot;
};

} // namespace spacetow
