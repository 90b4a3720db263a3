#include "core/geometry/static_quadtree.h"

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

constexpr std::size_t leafCapacity = 16; // with fewer, trees take longer to build and to ask
constexpr int maxDepth = 40;
// A level that keeps more than this share of its boxes in one quadrant has not divided them.
constexpr double poorShare = 0.75;
// Where more than this share straddles the middle, the axis is not divided: it would only hold everything twice.
constexpr double straddlingShare = 0.5;
// Boxes that reach far, as those of walls without a back, lie over each other everywhere: a tree that divided them on
// and on would hold each of 100,000 a hundred and sixty times, and find what is asked for no sooner.
constexpr double mostCopies = 16;

enum class SplitAt : std::uint8_t { Centers, UpperBounds, LowerBounds };

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) {
        return *middle;
    }
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double coordinate(const Aabb& box, SplitAt at, int axis) {
    switch (at) {
    case SplitAt::UpperBounds:
        return box.max[axis];
    case SplitAt::LowerBounds:
        return box.min[axis];
    case SplitAt::Centers:
        break;
    }
    return 0.5 * (box.min[axis] + box.max[axis]);
}

/// Quadrants by bit: 1 is the right half, 2 the upper one. The middle itself belongs to the right and upper halves.
bool reaches(const Aabb& box, const Vec2& middle, unsigned quadrant) {
    const bool x = (quadrant & 1u) != 0 ? box.max.x() >= middle.x() : box.min.x() < middle.x();
    const bool y = (quadrant & 2u) != 0 ? box.max.y() >= middle.y() : box.min.y() < middle.y();
    return x && y;
}

/// The middle of boxes that reach out of a region may lie outside it: one of the halves is empty then.
Aabb quadrantOf(const Aabb& region, const Vec2& middle, unsigned quadrant) {
    Aabb result = region;
    for (int axis = 0; axis < 2; ++axis) {
        if ((quadrant & (axis == 0 ? 1u : 2u)) != 0) {
            result.min[axis] = std::max(region.min[axis], middle[axis]);
        } else {
            result.max[axis] = std::min(region.max[axis], middle[axis]);
        }
    }
    return result;
}

bool holds(const Aabb& region, const Vec2& p) { // half open, so that every point is in one leaf
    return region.min.x() <= p.x() && p.x() < region.max.x() && region.min.y() <= p.y() && p.y() < region.max.y();
}

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

struct StaticQuadtree::Builder {
    StaticQuadtree& tree;
    std::vector<double> values;

    Vec2 middleOf(const std::vector<std::uint32_t>& items, SplitAt at) {
        Vec2 middle;
        for (int axis = 0; axis < 2; ++axis) {
            values.clear();
            for (const std::uint32_t item : items) {
                values.push_back(coordinate(tree.m_boxes[item], at, axis));
            }
            middle[axis] = median(values);
        }
        return middle;
    }

    /// The middle, out of reach along an axis that divides too little.
    Vec2 usefulMiddle(const std::vector<std::uint32_t>& items, SplitAt at) {
        Vec2 middle = middleOf(items, at);
        for (int axis = 0; axis < 2; ++axis) {
            const auto straddling = std::count_if(items.begin(), items.end(), [&](std::uint32_t item) {
                const Aabb& box = tree.m_boxes[item];
                return box.min[axis] < middle[axis] && box.max[axis] >= middle[axis];
            });
            if (static_cast<double>(straddling) > straddlingShare * static_cast<double>(items.size())) {
                middle[axis] = infinity;
            }
        }
        return middle;
    }

    void makeLeaf(std::uint32_t node, const std::vector<std::uint32_t>& items) {
        tree.m_nodes[node].first = static_cast<std::uint32_t>(tree.m_items.size());
        tree.m_nodes[node].count = static_cast<std::uint32_t>(items.size());
        for (const std::uint32_t item : items) {
            tree.m_items.push_back(item);
            tree.m_itemBoxes.push_back(tree.m_boxes[item]);
        }
    }

    struct Branch {
        int depth = 0;
        int poor = 0;      // levels in a row that did not divide the boxes; each tries another kind of split point
        double copies = 1; // of a box, were the tree like this branch everywhere
    };

    void build(std::uint32_t node, const std::vector<std::uint32_t>& items, const Branch& branch) {
        tree.m_depth = std::max(tree.m_depth, branch.depth);
        if (items.size() <= leafCapacity || branch.poor >= 3 || branch.depth >= maxDepth) {
            makeLeaf(node, items);
            return;
        }
        const auto share = [&items](std::size_t part) {
            return static_cast<double>(part) / static_cast<double>(items.size());
        };
        const Vec2 middle = usefulMiddle(items, static_cast<SplitAt>(branch.poor));
        std::size_t all = 0;
        std::array<std::vector<std::uint32_t>, 4> parts;
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant) {
            for (const std::uint32_t item : items) {
                if (reaches(tree.m_boxes[item], middle, quadrant)) {
                    parts[quadrant].push_back(item);
                }
            }
            all += parts[quadrant].size();
        }
        const double copies = branch.copies * share(all);
        if (copies > mostCopies) {
            makeLeaf(node, items);
            return;
        }
        const auto first = static_cast<std::uint32_t>(tree.m_nodes.size());
        tree.m_nodes[node] = {middle, first, 0, false};
        tree.m_nodes.resize(first + 4);
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant) {
            const bool isPoor = share(parts[quadrant].size()) > poorShare;
            build(first + quadrant, parts[quadrant], {branch.depth + 1, isPoor ? branch.poor + 1 : 0, copies});
            parts[quadrant] = {};
        }
    }
};

StaticQuadtree::StaticQuadtree(std::vector<Aabb> boxes) : m_boxes(std::move(boxes)) {
    std::vector<std::uint32_t> items;
    for (std::uint32_t i = 0; i < m_boxes.size(); ++i) {
        if (!m_boxes[i].isEmpty()) {
            items.push_back(i);
            m_bounds.include(m_boxes[i]);
        }
    }
    m_nodes.resize(1);
    Builder{*this, {}}.build(0, items, {});
}

void StaticQuadtree::query(const Aabb& area, std::vector<std::uint32_t>& out) const {
    if (!m_bounds.overlaps(area)) {
        return;
    }
    struct Visit { // without initial values: most of the stack is never used
        std::uint32_t node;
        double left, bottom, right, top;

        Aabb region() const { return {Vec2(left, bottom), Vec2(right, top)}; }
    };
    std::array<Visit, 3 * maxDepth + 4> stack;
    std::size_t size = 0;
    stack[size++] = {0, -infinity, -infinity, infinity, infinity};
    while (size > 0) {
        const Visit visit = stack[--size];
        const Node& node = m_nodes[visit.node];
        if (!node.leaf) {
            for (unsigned quadrant = 0; quadrant < 4; ++quadrant) {
                if (reaches(area, node.middle, quadrant)) {
                    const Aabb part = quadrantOf(visit.region(), node.middle, quadrant);
                    stack[size++] = {node.first + quadrant, part.min.x(), part.min.y(), part.max.x(), part.max.y()};
                }
            }
            continue;
        }
        const Aabb region = visit.region();
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Aabb& box = m_itemBoxes[i];
            // A box in several leaves is found in the one that holds the lower corner of what it shares with the area.
            if (box.overlaps(area) && holds(region, box.min.cwiseMax(area.min))) {
                out.push_back(m_items[i]);
            }
        }
    }
}

std::vector<Aabb> StaticQuadtree::cells() const {
    std::vector<Aabb> result;
    if (m_nodes.empty() || m_bounds.isEmpty()) {
        return result;
    }
    std::vector<std::pair<std::uint32_t, Aabb>> stack{{0, m_bounds}};
    while (!stack.empty()) {
        const auto [index, region] = stack.back();
        stack.pop_back();
        const Node& node = m_nodes[index];
        if (node.leaf) {
            result.push_back(region);
            continue;
        }
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant) {
            const Aabb part = quadrantOf(region, node.middle, quadrant);
            if (!part.isEmpty()) {
                stack.emplace_back(node.first + quadrant, part);
            }
        }
    }
    return result;
}

} // namespace spacetow
