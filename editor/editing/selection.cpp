#include "editor/editing/selection.h"

#include <algorithm>

namespace spacetow {

namespace {

template <class T>
void makeSet(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace

Selection::Selection(std::vector<Key> keys) : m_keys(std::move(keys)) {
    makeSet(m_keys);
}

Selection::Selection(std::vector<Key> keys, std::vector<NodeRef> nodes)
    : m_keys(std::move(keys)), m_nodes(std::move(nodes)) {
    for (const NodeRef& node : m_nodes) {
        m_keys.push_back(node.key);
    }
    makeSet(m_keys);
    makeSet(m_nodes);
}

bool Selection::contains(Key key) const {
    return std::ranges::binary_search(m_keys, key);
}

bool Selection::contains(const NodeRef& node) const {
    return std::ranges::binary_search(m_nodes, node);
}

Selection Selection::with(Key key) const {
    Selection result = withPivot({});
    const auto place = std::ranges::lower_bound(result.m_keys, key);
    if (place == result.m_keys.end() || *place != key) {
        result.m_keys.insert(place, key);
    }
    return result;
}

Selection Selection::without(Key key) const {
    Selection result = withPivot({});
    std::erase(result.m_keys, key);
    std::erase_if(result.m_nodes, [key](const NodeRef& node) { return node.key == key; });
    return result;
}

Selection Selection::toggled(Key key) const {
    return contains(key) ? without(key) : with(key);
}

Selection Selection::withNodes(std::vector<NodeRef> nodes) const {
    Selection result = withPivot({});
    result.m_nodes = std::move(nodes);
    makeSet(result.m_nodes);
    return result;
}

Selection Selection::toggled(const NodeRef& node) const {
    std::vector<NodeRef> nodes = m_nodes;
    if (contains(node)) {
        std::erase(nodes, node);
    } else {
        nodes.push_back(node);
    }
    return withNodes(std::move(nodes));
}

Selection Selection::entering(Key group) const {
    Selection result = *this;
    result.m_entered = group;
    return result;
}

Selection Selection::withPivot(const std::optional<Vec2>& pivot) const {
    Selection result = *this;
    result.m_pivot = pivot;
    return result;
}

Selection Selection::within(const Level& level) const {
    if (empty() && m_entered == 0) {
        return {};
    }
    Selection kept;
    const Object* group = m_entered == 0 ? nullptr : level.objects.find(m_entered);
    if (group != nullptr && std::holds_alternative<GroupObject>(group->data)) {
        kept.m_entered = m_entered;
    }
    for (const int place : level.objects.indicesOf(m_keys)) {
        const Object& object = level.objects[place];
        kept.m_keys.push_back(object.key);
        const auto first = std::ranges::lower_bound(m_nodes, object.key, {}, &NodeRef::key);
        for (auto node = first; node != m_nodes.end() && node->key == object.key; ++node) {
            if (hasNode(object.data, node->shape, node->vertex)) {
                kept.m_nodes.push_back(*node);
            }
        }
    }
    makeSet(kept.m_keys);
    makeSet(kept.m_nodes);
    kept.m_pivot = kept.m_keys == m_keys ? m_pivot : std::nullopt;
    return kept;
}

} // namespace spacetow
