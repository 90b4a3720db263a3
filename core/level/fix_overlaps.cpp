// Takes away walls that lie on others.
#include "core/level/edits.h"
#include "core/level/fix_edits.h"
#include "core/level/level_index.h"
#include "core/level/lint_overlaps.h"
#include "core/level/shape_pieces.h"

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

/// What is left of a chain without some of its segments: stretches of the others.
std::vector<LevelShape> remains(const LevelShape& shape, std::span<const int> gone) {
    const std::vector<Vec2>& v = *verticesOf(shape);
    const int count = static_cast<int>(v.size());
    const int segments = isClosed(shape) ? count : count - 1;
    std::vector<LevelShape> pieces;
    // A closed chain is gone round from behind one that goes.
    const int begin = isClosed(shape) ? gone.front() + 1 : 0;
    std::vector<Vec2> run;
    for (int i = 0; i < segments; ++i) {
        const int segment = (begin + i) % segments;
        if (!std::ranges::binary_search(gone, segment)) {
            if (run.empty()) {
                run.push_back(v[static_cast<std::size_t>(segment)]);
            }
            run.push_back(v[static_cast<std::size_t>((segment + 1) % count)]);
        } else if (!run.empty()) {
            pieces.push_back(withVertices(shape, std::exchange(run, {}), false));
        }
    }
    if (!run.empty()) {
        pieces.push_back(withVertices(shape, std::move(run), false));
    }
    return pieces;
}

/// Chains of the object and of all that is near.
std::vector<WallChain> chainsNear(const Level& level, int index) {
    std::vector<WallChain> chains;
    const LevelIndex& places = levelIndex(level);
    places.visitObjects(places.boundsOf(index).grown(lint_limits::together), [&](int place) {
        const auto* body = std::get_if<BodyObject>(&level.objects[place].data);
        if (body != nullptr && body->tangible) {
            addWallChains(chains, level.objects[place], place);
        }
    });
    return chains;
}

} // namespace

Level withoutOverlaps(Level level, Key key) {
    const int index = level.objects.indexOf(key);
    const auto* body = index < 0 ? nullptr : std::get_if<BodyObject>(&level.objects[index].data);
    if (body == nullptr) {
        return level;
    }
    const std::vector<WallChain> chains = chainsNear(level, index);
    std::vector<NodeRef> firsts; // one node of each chain that loses something
    std::vector<std::vector<int>> gone(body->shapes.size());
    for (const WallOverlap& overlap : wallOverlaps(chains)) {
        const WallChain& chain = chains[static_cast<std::size_t>(overlap.chain)];
        // Repeated vertices, which the chain here is without, are cured first.
        if (chain.key == key && chain.vertices() == chain.points.size()) {
            const auto shape = static_cast<std::size_t>(chain.shape);
            gone[shape].insert(gone[shape].end(), overlap.segments.begin(), overlap.segments.end());
            std::ranges::sort(gone[shape]);
            firsts.push_back({key, chain.shape, 0});
        }
    }
    std::ranges::sort(firsts);
    firsts.erase(std::unique(firsts.begin(), firsts.end()), firsts.end());
    return reshaped(std::move(level), firsts,
                    [&gone](const BodyObject& changed, const NodeRef& node, std::span<const NodeRef>) {
                        const auto shape = static_cast<std::size_t>(node.shape);
                        std::vector<ShapePiece> pieces;
                        for (LevelShape& piece : remains(changed.shapes[shape], gone[shape])) {
                            pieces.push_back({std::move(piece), {}});
                        }
                        return std::optional(std::move(pieces));
                    })
        .level;
}

} // namespace spacetow
