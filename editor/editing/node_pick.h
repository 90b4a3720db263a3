#pragma once
// Nodes and segments of the objects whose nodes are edited: under the pointer, in a box. World coordinates, m.

#include "core/math/aabb.h"
#include "editor/editing/document.h"
#include "editor/editing/input.h"
#include "editor/editing/pick.h"

#include <optional>
#include <vector>

namespace spacetow {

/// The objects in edit: those that are selected, and the members of groups that are, ascending. What is hidden or
/// locked is not among them.
std::vector<Key> keysInEdit(const Edit& edit);
/// Whether the object has nodes at all.
bool hasNodes(const ObjectData& data);
/// The nearest node within `tolerance` of the point, else the nearest segment. Looks at what is near only.
std::optional<Hit> nodeHit(const Level& level, const PickQuery& query);
/// Ascending.
std::vector<NodeRef> nodesIn(const Level& level, std::span<const Key> keys, const Aabb& box);
/// The nodes at both ends of a segment that was hit, ascending.
std::vector<NodeRef> endsOf(const Level& level, const Hit& segment);
/// Where a node put on the segment lands: on it, as near as can be to where the point snaps; nothing at its ends.
std::optional<Vec2> placeOn(const Level& level, const Hit& segment, const Vec2& snapped);

inline NodeRef nodeOf(const Hit& hit) {
    return {hit.key, hit.shape, hit.index};
}
/// The nodes and all others at the same places, ascending.
std::vector<NodeRef> withCompany(const Level& level, const std::vector<NodeRef>& nodes);
Aabb boundsOfNodes(const Level& level, std::span<const NodeRef> nodes);

} // namespace spacetow
