#include "core/physics/query/queries.h"

#include "core/base/contract.h"
#include "core/physics/state/world_data.h"

#include <type_traits>

namespace spacetow {

namespace {

template <class Visit>
void forEachTree(const BroadPhase& broadPhase, const Visit& visit) {
    if (broadPhase.statics) {
        visit(broadPhase.statics->tree);
    }
    if (broadPhase.staticChanges) {
        visit(broadPhase.staticChanges->geometry.tree);
    }
    visit(broadPhase.tree);
}

} // namespace

std::vector<QuadtreeCell> occupiedCells(const World& world, const std::optional<Aabb>& area) {
    std::vector<QuadtreeCell> cells;
    std::vector<std::uint32_t> found;
    forEachTree(world.data().broadPhase, [&](const auto& tree) {
        for (const Aabb& cell : tree.cells()) {
            if (area && !cell.overlaps(*area)) {
                continue;
            }
            found.clear();
            tree.query(cell, found);
            constexpr bool moves = std::is_same_v<std::decay_t<decltype(tree)>, MovingQuadtree>;
            cells.push_back({cell, static_cast<int>(found.size()), moves});
        }
    });
    return cells;
}

std::optional<std::uint32_t> islandOf(const World& world, BodyId body) {
    EXPECTS(world.contains(body));
    const WorldData& data = world.data();
    const BodyRecord& record = data.bodies.records[body.index];
    if (record.asleep) {
        return record.island;
    }
    const std::vector<Slot>& roots = data.contactGraph.roots;
    const bool isKnown = body.index < roots.size() && data.bodies.motions[body.index].isMovable() && record.active;
    return isKnown ? std::optional(roots[body.index]) : std::nullopt;
}

} // namespace spacetow
