#pragma once
// The objects of a level as the outliner lists them: a tree of groups and members in drawing order. Knows what has to
// be listed anew when another level takes the place of the one before, and no view.

#include "core/level/level.h"
#include "editor/panels/object_filter.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace spacetow {

struct OutlinerNode {
    Key key = 0; // 0 for the root
    OutlinerNode* parent = nullptr;
    std::vector<OutlinerNode*> members; // in drawing order: the last one is listed first
    int order = -1;                     // in the level; −1 when it is no longer there
    int place = 0;                      // among the members of its parent, while that has counted them
    unsigned stamp = 0;                 // of the arrangement that has it
    bool hasCounted = true;
    bool isNew = false; // it is not listed yet
};

/// Where everything belongs in the level that is shown now.
struct OutlinerArrangement {
    std::unordered_map<OutlinerNode*, std::vector<OutlinerNode*>> members; // of all that have any, or had
    std::vector<OutlinerNode*> changed;                                    // listed before and now, but look different
    std::vector<OutlinerNode*> gone;
};

class OutlinerTree {
  public:
    OutlinerNode& root() { return m_root; }
    /// Null when it is not listed.
    OutlinerNode* find(Key key) const;
    OutlinerNode* at(int order) const { return m_order[static_cast<std::size_t>(order)]; }
    /// Its number among the rows of its parent, from the top.
    int rowOf(const OutlinerNode& node) const;

    /// Takes over the objects of `after` that the filter finds, and the groups these are in. `before` are those that
    /// were taken over last. What is gone stays until `forget`; the members of nodes are left as they are, but for
    /// those of new nodes, which have their new members.
    OutlinerArrangement arrange(const ObjectList& before, const Level& after, const ObjectFilter& filter);
    void forget(const std::vector<OutlinerNode*>& gone);

  private:
    OutlinerNode* nodeOf(Key key);
    void listMembers(const Level& after, OutlinerArrangement& arrangement);

    OutlinerNode m_root;
    std::unordered_map<Key, std::unique_ptr<OutlinerNode>> m_nodes;
    std::vector<OutlinerNode*> m_order; // of the objects of the level; null for what is not listed
    unsigned m_stamp = 0;
};

/// Whether the outliner shows both in the same way.
bool looksAlike(const Object& one, const Object& other);

} // namespace spacetow
