#pragma once
// What is solid behind walls without a back, as a bounding volume hierarchy. Boxes around such regions would cover half
// of the level and each other; a node has instead the box of its walls and the directions in which their regions go on
// from there. Reading material: L. Shirman, S. Abi-Ezzi, "The Cone of Normals Technique" (1993).

#include "core/geometry/wall_back.h"

#include <cstdint>
#include <vector>

namespace spacetow {

class WallBackTree {
  public:
    struct Item {
        std::uint32_t number; // what a query answers with
        WallBack region;
        Aabb wall; // of the segment behind which it lies
    };

    WallBackTree() = default;
    /// The same items give the same tree. O(n log n).
    explicit WallBackTree(std::vector<Item> items);

    /// Appends the numbers of the items whose regions meet the box while their walls' boxes do not, each once and
    /// always in the same order. Which they are depends on the items alone.
    void query(const Aabb& box, std::vector<std::uint32_t>& out) const;

    const std::vector<Item>& items() const { return m_items; }

  private:
    /// Directions anticlockwise from one on, in quarter turns.
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
