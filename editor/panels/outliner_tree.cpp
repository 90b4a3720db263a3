#include "editor/panels/outliner_tree.h"

#include "core/level/groups.h"

namespace spacetow {

namespace {

/// How many objects at both ends of the lists have the same keys.
struct CommonEnds {
    int front = 0;
    int back = 0;
};

CommonEnds commonEnds(const ObjectList& one, const ObjectList& other) {
    const int shorter = std::min(one.size(), other.size());
    CommonEnds ends;
    while (ends.front < shorter) {
        const bool isStart = ends.front % ObjectList::blockSize == 0;
        if (isStart && ends.front + ObjectList::blockSize <= shorter &&
            one.sharesBlock(ends.front / ObjectList::blockSize, other)) {
            ends.front += ObjectList::blockSize;
        } else if (one[ends.front].key == other[ends.front].key) {
            ++ends.front;
        } else {
            break;
        }
    }
    const auto fromBack = [](const ObjectList& list, int number) -> const Object& {
        return list[list.size() - 1 - number];
    };
    while (ends.back < shorter - ends.front && fromBack(one, ends.back).key == fromBack(other, ends.back).key) {
        ++ends.back;
    }
    return ends;
}

/// Which objects are found, or have something in them that is; empty for all.
std::vector<bool> listedObjects(const Level& level, const ObjectFilter& filter) {
    if (filter.isEmpty()) {
        return {};
    }
    std::vector<bool> listed(static_cast<std::size_t>(level.objects.size()));
    const GroupTree tree(level);
    int place = -1;
    for (const Object& object : level.objects) {
        ++place;
        if (!filter.finds(object)) {
            continue;
        }
        listed[static_cast<std::size_t>(place)] = true;
        for (const Object* group = tree.parentOf(object); group != nullptr; group = tree.parentOf(*group)) {
            const auto at = static_cast<std::size_t>(level.objects.indexOf(group->key));
            if (listed[at]) {
                break;
            }
            listed[at] = true;
        }
    }
    return listed;
}

std::size_t shapeOf(const BodyObject& body) {
    return body.shapes.size() == 1 ? body.shapes.front().index() : std::variant_npos;
}

} // namespace

bool looksAlike(const Object& one, const Object& other) {
    if (one.visible != other.visible || one.locked != other.locked || one.data.index() != other.data.index() ||
        one.name != other.name) {
        return false;
    }
    if (const auto* body = std::get_if<BodyObject>(&one.data)) {
        return shapeOf(*body) == shapeOf(std::get<BodyObject>(other.data));
    }
    const auto* group = std::get_if<GroupObject>(&one.data);
    return group == nullptr || *group == std::get<GroupObject>(other.data);
}

OutlinerNode* OutlinerTree::find(Key key) const {
    const auto found = m_nodes.find(key);
    return found == m_nodes.end() ? nullptr : found->second.get();
}

OutlinerNode* OutlinerTree::nodeOf(Key key) {
    std::unique_ptr<OutlinerNode>& node = m_nodes[key];
    if (!node) {
        node = std::make_unique<OutlinerNode>();
        node->key = key;
        node->isNew = true;
    }
    return node.get();
}

int OutlinerTree::rowOf(const OutlinerNode& node) const {
    OutlinerNode& parent = *node.parent;
    if (!parent.hasCounted) {
        int place = 0;
        for (OutlinerNode* member : parent.members) {
            member->place = place++;
        }
        parent.hasCounted = true;
    }
    return static_cast<int>(parent.members.size()) - 1 - node.place;
}

OutlinerArrangement OutlinerTree::arrange(const ObjectList& before, const Level& after, const ObjectFilter& filter) {
    OutlinerArrangement arrangement;
    const std::vector<bool> listed = listedObjects(after, filter);
    const CommonEnds ends = commonEnds(before, after.objects);
    const int size = after.objects.size();
    std::vector<OutlinerNode*> order(static_cast<std::size_t>(size));
    ++m_stamp;
    for (int i = 0; i < size; ++i) {
        if (!listed.empty() && !listed[static_cast<std::size_t>(i)]) {
            continue;
        }
        const Object& object = after.objects[i];
        const int was = i < ends.front ? i : i >= size - ends.back ? i - size + before.size() : -1;
        OutlinerNode* node = was < 0 ? nullptr : at(was);
        node = node == nullptr ? nodeOf(object.key) : node;
        if (!node->isNew && &before[node->order] != &object && !looksAlike(before[node->order], object)) {
            arrangement.changed.push_back(node);
        }
        node->order = i;
        node->stamp = m_stamp;
        order[static_cast<std::size_t>(i)] = node;
    }
    for (OutlinerNode* node : m_order) {
        if (node != nullptr && node->stamp != m_stamp) {
            node->order = -1;
            arrangement.gone.push_back(node);
        }
    }
    m_order = std::move(order);
    listMembers(after, arrangement);
    return arrangement;
}

void OutlinerTree::listMembers(const Level& after, OutlinerArrangement& arrangement) {
    const GroupTree tree(after);
    auto& members = arrangement.members;
    members[&m_root];
    const auto noteFormer = [&members](OutlinerNode* node) {
        if (!node->members.empty()) {
            members[node];
        }
    };
    for (OutlinerNode* node : arrangement.gone) {
        noteFormer(node);
    }
    const Object* last = nullptr; // most have the same as the one before
    std::vector<OutlinerNode*>* lastMembers = &members[&m_root];
    OutlinerNode* lastNode = &m_root;
    for (OutlinerNode* node : m_order) {
        if (node == nullptr) {
            continue;
        }
        noteFormer(node);
        const Object* parent = tree.hasGroups() ? tree.parentOf(after.objects[node->order]) : nullptr;
        if (parent != last) {
            last = parent;
            lastNode = parent == nullptr ? &m_root : find(parent->key);
            lastMembers = &members[lastNode];
        }
        lastMembers->push_back(node);
        if (node->isNew) {
            node->parent = lastNode;
            if (lastNode->isNew) {
                node->place = static_cast<int>(lastNode->members.size());
                lastNode->members.push_back(node);
            }
        }
    }
}

void OutlinerTree::forget(const std::vector<OutlinerNode*>& gone) {
    for (const OutlinerNode* node : gone) {
        m_nodes.erase(node->key);
    }
}

} // namespace spacetow
