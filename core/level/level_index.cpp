#include "core/level/level_index.h"

#include "core/base/overloaded.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr std::size_t many = 32; // vertices of a shape that is worth a tree
constexpr double mitre = 2.5;    // how much further than its depth the back of a wall reaches at corners

/// How far beyond its bounds there is something of the object.
double reachBeyond(const ObjectData& data, const Aabb& bounds) {
    const auto* body = std::get_if<BodyObject>(&data);
    if (body == nullptr || bounds.isEmpty()) {
        return 0;
    }
    double reach = 0;
    if (body->kind == BodyKind::Kinematic) {
        reach = std::max({0.0, (body->position - bounds.max).maxCoeff(), (bounds.min - body->position).maxCoeff()});
    }
    for (const LevelShape& shape : body->shapes) {
        const auto* chain = std::get_if<EdgeChain>(&shape);
        if (chain != nullptr && (chain->closed || std::isfinite(chain->depth))) {
            reach = std::max(reach, mitre * chain->depth);
        }
    }
    return reach;
}

int segmentsOf(const ObjectData& data) {
    const auto* body = std::get_if<BodyObject>(&data);
    int segments = 0;
    for (std::size_t i = 0; body != nullptr && i < body->shapes.size(); ++i) {
        segments += std::max(1, level_index::pathOf(body->shapes[i], {}).segments());
    }
    return std::max(1, segments);
}

const ShapeList* shapeListOf(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body == nullptr ? nullptr : &body->shapes;
}

std::shared_ptr<const std::vector<SegmentTree>> treesOf(const Object& object) {
    const ShapeList* shapes = shapeListOf(object);
    const auto isLarge = [](const LevelShape& shape) { return level_index::pathOf(shape, {}).points.size() >= many; };
    if (shapes == nullptr || std::ranges::none_of(*shapes, isLarge)) {
        return nullptr;
    }
    auto trees = std::make_shared<std::vector<SegmentTree>>();
    for (const LevelShape& shape : *shapes) {
        const level_index::Path path = level_index::pathOf(shape, {});
        trees->emplace_back(path.points, path.closed);
    }
    return trees;
}

} // namespace

namespace level_index {

Path pathOf(const LevelShape& shape, const Transform& pose) {
    return std::visit(Overloaded{[&](const EdgeChain& chain) {
                                     return Path{chain.vertices, chain.closed, pose};
                                 },
                                 [&](const LineChain& chain) {
                                     return Path{chain.vertices, chain.closed, pose};
                                 },
                                 [&](const Polygon& polygon) {
                                     return Path{polygon.vertices, true, pose};
                                 },
                                 [](const Circle&) { return Path(); }},
                      shape);
}

Aabb toLocal(const Aabb& box, const Path& path, const SegmentTree& tree) {
    Aabb local;
    for (const Vec2& corner : {box.min, box.max, Vec2(box.min.x(), box.max.y()), Vec2(box.max.x(), box.min.y())}) {
        local.include(path.pose.toLocal(corner));
    }
    // What is rounded on its way to the world must not be missed.
    constexpr double ulps = 1e-14;
    double largest = path.pose.position.cwiseAbs().maxCoeff();
    for (const Aabb& each : {box, local, tree.bounds()}) {
        largest = std::max({largest, each.min.cwiseAbs().maxCoeff(), each.max.cwiseAbs().maxCoeff()});
    }
    return local.grown(ulps * largest);
}

} // namespace level_index

void LevelIndex::Block::bound() {
    bounds = {};
    reaching = {};
    for (const Entry& entry : entries) {
        bounds.include(entry.box);
        if (!entry.box.isEmpty()) {
            reaching.include(entry.box.grown(entry.reach));
        }
    }
}

/// Makes the blocks of an index out of those of the one before.
class LevelIndex::Maker {
  public:
    Maker(const ObjectList& objects, const LevelIndex* before) : m_objects(objects), m_before(before) {}

    std::vector<std::shared_ptr<const Block>> blocks() {
        std::vector<std::shared_ptr<const Block>> blocks;
        for (int b = 0; b < m_objects.blocks(); ++b) {
            if (m_before != nullptr && m_objects.sharesBlock(b, m_before->m_objects)) {
                blocks.push_back(m_before->m_blocks[static_cast<std::size_t>(b)]);
            } else {
                blocks.push_back(block(b));
            }
        }
        return blocks;
    }

  private:
    std::shared_ptr<const Block> block(int number) {
        auto block = std::make_shared<Block>();
        const int first = number * ObjectList::blockSize;
        const int end = std::min(first + ObjectList::blockSize, m_objects.size());
        block->entries.reserve(static_cast<std::size_t>(end - first));
        for (int i = first; i < end; ++i) {
            const ObjectData& data = m_objects[i].data;
            if (std::holds_alternative<GroupObject>(data)) {
                block->groups.push_back(i);
            } else if (std::holds_alternative<ConnectorObject>(data)) {
                block->connectors.push_back(i);
            }
            block->entries.push_back(entry(i));
        }
        block->bound();
        return block;
    }
    Entry entry(int index) {
        const Object& object = m_objects[index];
        const int old = placeBefore(index);
        if (old >= 0 && &m_before->m_objects[old] == &object) {
            return m_before->entry(old);
        }
        Entry made{ownBounds(object.data), 0, segmentsOf(object.data), {}};
        made.reach = reachBeyond(object.data, made.box);
        const ShapeList* shapes = shapeListOf(object);
        const ShapeList* oldShapes = old >= 0 ? shapeListOf(m_before->m_objects[old]) : nullptr;
        const bool onlyMoved =
            oldShapes != nullptr && shapes != nullptr && m_before->entry(old).trees && *shapes == *oldShapes;
        made.trees = onlyMoved ? m_before->entry(old).trees : treesOf(object);
        return made;
    }
    /// Where the object was before, or −1. Neighbours have mostly gone the same way.
    int placeBefore(int index) {
        if (m_before == nullptr) {
            return -1;
        }
        const ObjectList& before = m_before->m_objects;
        const Key key = m_objects[index].key;
        const int guess = index + m_shift;
        if (guess >= 0 && guess < before.size() && before[guess].key == key) {
            return guess;
        }
        const int found = before.indexOf(key);
        m_shift = found >= 0 ? found - index : m_shift;
        return found;
    }

    const ObjectList& m_objects;
    const LevelIndex* m_before;
    int m_shift = 0;
};

LevelIndex::LevelIndex(ObjectList objects, const LevelIndex* before)
    : m_objects(std::move(objects)), m_blocks(Maker(m_objects, before).blocks()) {
    for (const std::shared_ptr<const Block>& block : m_blocks) {
        m_groups.insert(m_groups.end(), block->groups.begin(), block->groups.end());
        m_connectors.insert(m_connectors.end(), block->connectors.begin(), block->connectors.end());
    }
    placeConnectors(before);
    for (const std::shared_ptr<const Block>& block : m_blocks) {
        m_bounds.include(block->bounds);
    }
}

int LevelIndex::segmentsNear(int object, const Aabb& box) const {
    const Entry& known = entry(object);
    if (!known.trees || box.contains(known.box)) {
        return known.segments;
    }
    int count = 0;
    visitPaths(object, [&](int shape, const level_index::Path& path) {
        level_index::visitStretches(path, treeOf(object, shape), box,
                                    [&count](int first, int end) { count += end - first; });
    });
    return std::max(1, count);
}

void LevelIndex::placeConnectors(const LevelIndex* before) {
    const std::optional<std::vector<Key>> changed = m_connectors.empty() ? std::nullopt : keysChanged(before);
    const auto hasChanged = [&](Key key) { return !changed || std::ranges::binary_search(*changed, key); };
    const auto finish = [](Block* block) {
        if (block != nullptr) {
            block->bound();
        }
    };
    std::shared_ptr<Block> copy;
    int copied = -1; // number of the block
    for (const int place : m_connectors) {
        const auto& connector = std::get<ConnectorObject>(m_objects[place].data);
        const bool stays = !entry(place).box.isEmpty() && !hasChanged(connector.a) && !hasChanged(connector.b);
        if (stays && !hasChanged(m_objects[place].key)) {
            continue;
        }
        const int number = place / ObjectList::blockSize;
        if (number != copied) {
            finish(copy.get());
            copied = number;
            copy = std::make_shared<Block>(*m_blocks[static_cast<std::size_t>(number)]);
            m_blocks[static_cast<std::size_t>(number)] = copy;
        }
        Aabb box;
        if (const auto ends = endsOf(connector, m_objects)) {
            box.include(ends->front());
            box.include(ends->back());
        }
        copy->entries[static_cast<std::size_t>(place % ObjectList::blockSize)].box = box;
    }
    finish(copy.get());
}

/// Of all objects that are not as before, ascending; nothing when they are many.
std::optional<std::vector<Key>> LevelIndex::keysChanged(const LevelIndex* before) const {
    constexpr std::size_t few = 256;
    std::vector<Key> keys;
    if (before == nullptr) {
        return {};
    }
    m_objects.visitDifferences(before->m_objects, [&](int index) {
        for (const ObjectList* list : {&m_objects, &before->m_objects}) {
            if (index < list->size() && keys.size() <= few) {
                keys.push_back((*list)[index].key);
            }
        }
    });
    if (keys.size() > few) {
        return {};
    }
    std::ranges::sort(keys);
    return keys;
}

} // namespace spacetow
