#pragma once
// A bounding volume hierarchy over the solid regions behind edges of infinite depth. AABBs of such regions would cover
// half of the level and overlap each other. A node has instead the AABB of its edges and an arc of the directions in
// which their regions extend. Compare L. Shirman, S. Abi-Ezzi, "The Cone of Normals Technique" (1993).

#include "core/geometry/wall_back.h"

#include <cstdint>
#include <vector>

namespace spacetow {

class WallBackTree {
  public:
    struct Item {
        std::uint32_t number; // the result of a query
        WallBack region;
        Aabb wall; // AABB of the edge itself
    };

    WallBackTree() = default;
    /// Equal items give equal trees. O(n log n).
    explicit WallBackTree(std::vector<Item> items);

    /// Appends the numbers of the items whose region overlaps the box but whose wall does not, each once and always in
    /// the same order. The result depends on the items alone, not on the tree.
    void query(const Aabb& box, std::vector<std::uint32_t>& out) const;

  private:
    /// An arc of directions, anticlockwise, in quarter turns.
    struct Arc {
        double begin = 0, length = 0;

        void include(const Arc& other);
        bool overlaps(const Arc& other) const;
    };
    struct Node {
        Aabb walls;
        Arc ways;
        std::uint32_t first = 0, count = 0; // of its items
        std::uint32_t right = 0;            // its second child; the first one follows it; 0 for leaves
    };

    static Arc waysOf(const WallBack& region, double slack);
    static bool mayMeet(const Aabb& walls, const Arc& ways, const Aabb& box, double slack);
    void build(std::uint32_t first, std::uint32_t count);

    std::vector<Item> m_items;
    std::vector<Node> m_nodes;
};

} // namespace spacetow
