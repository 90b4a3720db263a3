#include "core/geometry/moving_quadtree.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr int maxDepth = 10; // a million leaves

} // namespace

void MovingQuadtree::reset(const Aabb& bounds, std::uint32_t count) {
    m_depth = 0;
    for (std::uint64_t leaves = 1; leaves < count && m_depth < maxDepth; leaves *= 4) {
        ++m_depth;
    }
    m_side = 1u << m_depth;
    m_bounds = bounds.isEmpty() ? Aabb{{0, 0}, {0, 0}} : bounds;
    const Vec2 size = m_bounds.size();
    for (int axis = 0; axis < 2; ++axis) {
        m_perMeter[axis] = size[axis] > 0 ? m_side / size[axis] : 0;
    }
    m_leaves.assign(std::size_t{m_side} * m_side, none);
    m_entries.clear();
}

std::uint32_t MovingQuadtree::cellAlong(int axis, double coordinate) const {
    const double cell = (coordinate - m_bounds.min[axis]) * m_perMeter[axis];
    return static_cast<std::uint32_t>(std::clamp(cell, 0.0, m_side - 1.0));
}

void MovingQuadtree::insert(std::uint32_t number, const Aabb& box) {
    const std::uint32_t left = column(box.min.x());
    const std::uint32_t right = column(box.max.x());
    const std::uint32_t top = row(box.max.y());
    for (std::uint32_t y = row(box.min.y()); y <= top; ++y) {
        for (std::uint32_t x = left; x <= right; ++x) {
            std::uint32_t& leaf = m_leaves[std::size_t{y} * m_side + x];
            m_entries.push_back({number, leaf, box});
            leaf = static_cast<std::uint32_t>(m_entries.size() - 1);
        }
    }
}

void MovingQuadtree::insertAndQuery(std::uint32_t number, const Aabb& box, std::vector<std::uint32_t>& out) {
    const std::uint32_t left = column(box.min.x());
    const std::uint32_t right = column(box.max.x());
    const std::uint32_t bottom = row(box.min.y());
    const std::uint32_t top = row(box.max.y());
    for (std::uint32_t y = bottom; y <= top; ++y) {
        for (std::uint32_t x = left; x <= right; ++x) {
            std::uint32_t& leaf = m_leaves[std::size_t{y} * m_side + x];
            for (std::uint32_t i = leaf; i != none; i = m_entries[i].next) {
                const Entry& entry = m_entries[i];
                // Boxes that share several leaves are paired in the one of their common lower corner.
                if (entry.box.overlaps(box) && column(std::max(entry.box.min.x(), box.min.x())) == x &&
                    row(std::max(entry.box.min.y(), box.min.y())) == y) {
                    out.push_back(entry.number);
                }
            }
            m_entries.push_back({number, leaf, box});
            leaf = static_cast<std::uint32_t>(m_entries.size() - 1);
        }
    }
}

std::vector<Aabb> MovingQuadtree::cells() const {
    std::vector<Aabb> result;
    const Vec2 size = m_bounds.size() / m_side;
    for (std::uint32_t y = 0; y < m_side; ++y) {
        for (std::uint32_t x = 0; x < m_side; ++x) {
            if (!m_leaves.empty() && m_leaves[std::size_t{y} * m_side + x] != none) {
                const Vec2 corner = m_bounds.min + Vec2(x * size.x(), y * size.y());
                result.push_back({corner, corner + size});
            }
        }
    }
    return result;
}

} // namespace spacetow
