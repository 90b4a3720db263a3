#include "core/geometry/moving_quadtree.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// 1 or 0: without a branch, which could not be foretold.
std::size_t overlap(const Aabb& a, const Aabb& b) {
    return static_cast<std::size_t>(a.min.x() <= b.max.x()) & (b.min.x() <= a.max.x()) & (a.min.y() <= b.max.y()) &
           (b.min.y() <= a.max.y());
}

} // namespace

std::uint32_t MovingQuadtree::cellAlong(const Level& level, int axis, double coordinate) const {
    const double cell = (coordinate - m_bounds.min[axis]) * level.perMeter[axis];
    return static_cast<std::uint32_t>(std::clamp(cell, 0.0, level.side - 1.0));
}

/// The cells that may hold the lower corner of a box that overlaps the area.
MovingQuadtree::Range MovingQuadtree::rangeFor(const Level& level, const Aabb& area) const {
    constexpr double rounding = 1e-15;
    std::array<std::uint32_t, 2> first{}, last{};
    for (int axis = 0; axis < 2; ++axis) {
        const double size = level.largest[axis];
        const double lowest = area.min[axis] - size - rounding * (std::abs(area.min[axis]) + size);
        first[static_cast<std::size_t>(axis)] = cellAlong(level, axis, lowest);
        last[static_cast<std::size_t>(axis)] = cellAlong(level, axis, area.max[axis]);
    }
    return {first[0], last[0], first[1], last[1]};
}

MovingQuadtree::Entries MovingQuadtree::entriesIn(const Level& level, std::uint32_t row, const Range& range) const {
    const std::uint32_t* starts = &m_starts[level.first + row * level.side];
    return {starts[range.left], starts[range.right + 1]};
}

int MovingQuadtree::levelFor(const Aabb& box) const {
    const Vec2 size = box.size();
    const Vec2& leaves = m_levels[static_cast<std::size_t>(m_depth)].perMeter;
    double cells = std::max(size.x() * leaves.x(), size.y() * leaves.y());
    int level = m_depth;
    for (; cells > 2 && level > 0; --level) {
        cells *= 0.5;
    }
    return level;
}

/// Which level each box belongs to, and where the cells of the levels lie.
void MovingQuadtree::layOut(std::span<const Aabb> boxes) {
    m_levelOf.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const int of = levelFor(boxes[i]);
        m_levelOf[i] = static_cast<std::uint8_t>(of);
        Level& level = m_levels[static_cast<std::size_t>(of)];
        ++level.count;
        level.largest = level.largest.cwiseMax(boxes[i].size());
    }
    std::uint32_t cells = 0;
    for (Level& level : m_levels) {
        level.first = cells;
        cells += level.count > 0 ? level.side * level.side : 0;
    }
    m_starts.assign(cells + 1, 0);
}

void MovingQuadtree::fill(std::span<const Aabb> boxes) {
    m_bounds = {};
    for (const Aabb& box : boxes) {
        m_bounds.include(box);
    }
    if (m_bounds.isEmpty()) {
        m_bounds = {{0, 0}, {0, 0}};
    }
    m_depth = 0;
    for (std::uint64_t leaves = 1; leaves < boxes.size() && m_depth < maxDepth; leaves *= 4) {
        ++m_depth;
    }
    const Vec2 size = m_bounds.size();
    for (std::size_t i = 0; i < m_levels.size(); ++i) {
        Level& level = m_levels[i];
        level = {};
        level.side = 1u << i;
        for (int axis = 0; axis < 2; ++axis) {
            level.perMeter[axis] = size[axis] > 0 ? level.side / size[axis] : 0;
        }
    }
    layOut(boxes);
    m_cellOf.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Level& level = m_levels[m_levelOf[i]];
        const std::uint32_t column = cellAlong(level, 0, boxes[i].min.x());
        const std::uint32_t row = cellAlong(level, 1, boxes[i].min.y());
        m_cellOf[i] = level.first + row * level.side + column;
        ++m_starts[m_cellOf[i]];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& start : m_starts) {
        end += start;
        start = end;
    }
    m_entries.resize(boxes.size());
    for (std::size_t i = boxes.size(); i-- > 0;) { // backwards, so that what ends a cell becomes its start
        m_entries[--m_starts[m_cellOf[i]]] = {boxes[i], static_cast<std::uint32_t>(i)};
    }
}

void MovingQuadtree::query(const Aabb& area, std::vector<std::uint32_t>& out) const {
    for (const Level& level : m_levels) {
        if (level.count == 0) {
            continue;
        }
        const Range range = rangeFor(level, area);
        for (std::uint32_t row = range.bottom; row <= range.top; ++row) {
            const Entries entries = entriesIn(level, row, range);
            std::size_t size = out.size();
            out.resize(size + entries.end - entries.first);
            for (std::uint32_t i = entries.first; i < entries.end; ++i) {
                out[size] = m_entries[i].number;
                size += overlap(m_entries[i].box, area);
            }
            out.resize(size);
        }
    }
}

void MovingQuadtree::appendOverlapping(const Entry& entry, Entries with, const Found& found) const {
    std::vector<BoxPair>& out = found.all;
    std::size_t size = out.size();
    if (size > found.most) {
        return;
    }
    out.resize(size + with.end - with.first);
    for (std::uint32_t i = with.first; i < with.end; ++i) {
        out[size] = {entry.number, m_entries[i].number};
        size += overlap(m_entries[i].box, entry.box);
    }
    out.resize(size);
}

/// What the boxes of a row overlap of those that come after them on their level.
void MovingQuadtree::appendLater(const Level& level, std::uint32_t row, const Found& found) const {
    const Entries own = entriesIn(level, row, {0, level.side - 1, row, row});
    for (std::uint32_t i = own.first; i < own.end; ++i) {
        const Range range = rangeFor(level, m_entries[i].box);
        appendOverlapping(m_entries[i], {i + 1, entriesIn(level, row, range).end}, found);
        for (std::uint32_t above = row + 1; above <= range.top; ++above) {
            appendOverlapping(m_entries[i], entriesIn(level, above, range), found);
        }
    }
}

void MovingQuadtree::queryAll(std::vector<BoxPair>& out, std::size_t most) const {
    const Found found{out, most};
    for (std::size_t depth = 0; depth < m_levels.size(); ++depth) {
        const Level& level = m_levels[depth];
        if (level.count == 0) {
            continue;
        }
        for (std::uint32_t row = 0; row < level.side; ++row) {
            appendLater(level, row, found);
        }
        const Entries all{m_starts[level.first], m_starts[level.first] + level.count};
        for (std::size_t k = 0; k < depth; ++k) { // its boxes with larger ones
            if (m_levels[k].count == 0) {
                continue;
            }
            for (std::uint32_t i = all.first; i < all.end; ++i) {
                const Range range = rangeFor(m_levels[k], m_entries[i].box);
                for (std::uint32_t row = range.bottom; row <= range.top; ++row) {
                    appendOverlapping(m_entries[i], entriesIn(m_levels[k], row, range), found);
                }
            }
        }
    }
}

std::vector<Aabb> MovingQuadtree::cells() const {
    std::vector<Aabb> result;
    for (std::size_t depth = 0; depth < m_levels.size(); ++depth) {
        const Level& level = m_levels[depth];
        if (level.count == 0) {
            continue;
        }
        std::vector<bool> occupied(std::size_t{level.side} * level.side);
        for (const Entry& entry : m_entries) {
            if (m_levelOf[entry.number] != depth) {
                continue;
            }
            const auto cell = [&](int axis, double at) { return cellAlong(level, axis, at); };
            for (std::uint32_t y = cell(1, entry.box.min.y()); y <= cell(1, entry.box.max.y()); ++y) {
                for (std::uint32_t x = cell(0, entry.box.min.x()); x <= cell(0, entry.box.max.x()); ++x) {
                    occupied[std::size_t{y} * level.side + x] = true;
                }
            }
        }
        const Vec2 size = m_bounds.size() / level.side;
        for (std::size_t i = 0; i < occupied.size(); ++i) {
            if (occupied[i]) {
                const auto column = static_cast<double>(i % level.side);
                const std::size_t row = i / level.side;
                const Vec2 corner = m_bounds.min + Vec2(column * size.x(), static_cast<double>(row) * size.y());
                result.push_back({corner, corner + size});
            }
        }
    }
    return result;
}

} // namespace spacetow
