#include "core/geometry/wall_back_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

constexpr std::uint32_t itemsInLeaf = 4;
constexpr double wallSlack = 1e-5;      // m: more than that of the regions
constexpr double directionSlack = 1e-6; // quarter turns: more than rounding
// Nodes are looked into twice as readily as items are found, so that what is found is no matter of how the tree came
// out.
constexpr double nodeSlack = 2;
constexpr double fullTurn = 4;

/// How far anticlockwise a direction is from +x, in something like quarter turns: 0 … 4. Grows with the angle, and
/// opposite directions are 2 apart.
double turnOf(const Vec2& v) {
    const double sum = std::abs(v.x()) + std::abs(v.y());
    const double x = v.x() / sum;
    return v.y() >= 0 ? 1 - x : 3 + x;
}

/// From one direction on to another, anticlockwise.
double turnBetween(double from, double to) {
    return to >= from ? to - from : to - from + fullTurn;
}

} // namespace

void WallBackTree::Arc::include(const Arc& other) {
    const double fromHere = std::max(length, turnBetween(begin, other.begin) + other.length);
    const double fromThere = std::max(other.length, turnBetween(other.begin, begin) + length);
    begin = fromHere <= fromThere ? begin : other.begin;
    length = std::min({fromHere, fromThere, fullTurn});
}

bool WallBackTree::Arc::overlaps(const Arc& other) const {
    return turnBetween(begin, other.begin) <= length || turnBetween(other.begin, begin) <= other.length;
}

/// A region as wide as its wall has limits that are parallel but for rounding.
WallBackTree::Arc WallBackTree::waysOf(const WallBack& region, double slack) {
    const double begin = turnOf(region.first);
    const double length = turnBetween(begin, turnOf(region.last));
    const double sooner = begin - slack * directionSlack;
    return {sooner >= 0 ? sooner : sooner + fullTurn, (length > 3 ? 0 : length) + 2 * slack * directionSlack};
}

/// Whether one of these ways may lead from one of the walls into the box.
bool WallBackTree::mayMeet(const Aabb& walls, const Arc& ways, const Aabb& box, double slack) {
    const Aabb between = Aabb{box.min - walls.max, box.max - walls.min}.grown(slack * wallSlack);
    if (between.contains(Vec2(0, 0))) {
        return true;
    }
    // From outside of it a box is less than half a turn wide.
    const double begin = turnOf(between.min);
    double least = 0;
    double most = 0;
    for (const Vec2& corner :
         {Vec2(between.max.x(), between.min.y()), between.max, Vec2(between.min.x(), between.max.y())}) {
        const double turn = turnBetween(begin, turnOf(corner));
        const double offset = turn <= fullTurn / 2 ? turn : turn - fullTurn;
        least = std::min(least, offset);
        most = std::max(most, offset);
    }
    const double lowest = begin + least;
    return ways.overlaps({lowest >= 0 ? lowest : lowest + fullTurn, most - least});
}

WallBackTree::WallBackTree(std::vector<Item> items) : m_items(std::move(items)) {
    if (!m_items.empty()) {
        build(0, static_cast<std::uint32_t>(m_items.size()));
    }
}

void WallBackTree::build(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes.emplace_back();
    const auto begin = m_items.begin() + first;
    Node node{begin->wall, waysOf(begin->region, nodeSlack), first, count, 0};
    for (auto item = begin + 1; item != begin + count; ++item) {
        node.walls.include(item->wall);
        node.ways.include(waysOf(item->region, nodeSlack));
    }
    if (count > itemsInLeaf) {
        const Vec2 size = node.walls.size();
        const int axis = size.x() >= size.y() ? 0 : 1;
        const auto place = [axis](const Item& item) { return item.wall.min[axis] + item.wall.max[axis]; };
        const std::uint32_t half = count / 2;
        std::nth_element(begin, begin + half, begin + count, [&](const Item& a, const Item& b) {
            return place(a) != place(b) ? place(a) < place(b) : a.number < b.number;
        });
        build(first, half);
        node.right = static_cast<std::uint32_t>(m_nodes.size());
        build(first + half, count - half);
    }
    m_nodes[index] = node;
}

void WallBackTree::query(const Aabb& box, std::vector<std::uint32_t>& out) const {
    if (m_nodes.empty() || box.isEmpty()) {
        return;
    }
    std::array<std::uint32_t, 64> stack; // halving leaves less than that of any number
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::uint32_t index = stack[--size];
        const Node& node = m_nodes[index];
        if (!mayMeet(node.walls, node.ways, box, nodeSlack)) {
            continue;
        }
        if (node.right != 0) {
            stack[size++] = node.right;
            stack[size++] = index + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Item& item = m_items[i];
            if (!item.wall.overlaps(box) && item.region.meets(box) &&
                mayMeet(item.wall, waysOf(item.region, 1), box, 1)) {
                out.push_back(item.number);
            }
        }
    }
}

} // namespace spacetow
