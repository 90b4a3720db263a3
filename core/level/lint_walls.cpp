#include "core/level/lint_walls.h"

#include "core/level/nodes.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr double cellSize = 2 * lint_limits::nearly;

/// Cells far apart may share a number; who asks measures.
std::int64_t cellNumber(std::int64_t x, std::int64_t y) {
    return x * 0x1f1f1f1f1f + y;
}

std::int64_t cellOf(double value) {
    return static_cast<std::int64_t>(std::floor(value / cellSize));
}

bool standTogether(const WallChain& a, const WallChain& b) {
    return a.object == b.object || (a.isStill() && b.isStill());
}

} // namespace

std::size_t WallChain::vertices() const {
    return verticesOf(body->shapes[static_cast<std::size_t>(shape)])->size();
}

double WallChain::length() const {
    double sum = 0;
    for (int i = 0; i < segments(); ++i) {
        sum += (end(i) - start(i)).norm();
    }
    return sum;
}

bool WallChain::isStill() const {
    return body->kind == BodyKind::Static || body->frozen ||
           (body->kind == BodyKind::Kinematic && body->velocity == Vec2(0, 0) && body->angularVelocity == 0);
}

bool WallChain::isWall() const {
    return mayTouch(body->filter, {TagMask::bit(shipTag), TagMask::bit(wallTag)});
}

FindingPlace WallChain::place(std::vector<Vec2> marks) const {
    return {object, key, "/shapes/" + std::to_string(shape), std::move(marks)};
}

void addWallChains(std::vector<WallChain>& chains, const Object& object, int place) {
    const auto& body = std::get<BodyObject>(object.data);
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
        const LevelShape& shape = body.shapes[i];
        const auto* edges = std::get_if<EdgeChain>(&shape);
        if (edges == nullptr && !std::holds_alternative<LineChain>(shape)) {
            continue;
        }
        WallChain chain;
        chain.object = place;
        chain.shape = static_cast<int>(i);
        chain.key = object.key;
        chain.body = &body;
        chain.oneWay = edges != nullptr;
        chain.closed = isClosed(shape);
        chain.depth = edges != nullptr ? edges->depth : 0;
        for (const Vec2& vertex : *verticesOf(shape)) {
            const Vec2 at = pose.toWorld(vertex);
            if (chain.points.empty() || chain.points.back() != at) {
                chain.points.push_back(at);
            }
        }
        while (chain.closed && chain.points.size() > 1 && chain.points.front() == chain.points.back()) {
            chain.points.pop_back();
        }
        if (chain.points.size() > 1) {
            chains.push_back(std::move(chain));
        }
    }
}

std::vector<WallChain> wallChains(const Level& level, const Findings& findings) {
    std::vector<WallChain> chains;
    int place = -1;
    for (const Object& object : level.objects) {
        ++place;
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body != nullptr && body->tangible && !findings.isBad(place)) {
            addWallChains(chains, object, place);
        }
    }
    return chains;
}

WallEnds::WallEnds(const std::vector<WallChain>& chains) : m_chains(chains) {
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const WallChain& chain = chains[i];
        if (!chain.closed) {
            const int last = chain.segments() - 1;
            m_ends.push_back({static_cast<int>(i), true, chain.start(0), (chain.end(0) - chain.start(0)).norm()});
            m_ends.push_back(
                {static_cast<int>(i), false, chain.end(last), (chain.end(last) - chain.start(last)).norm()});
        }
    }
    m_cells.reserve(m_ends.size());
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
        const Vec2& at = m_ends[i].at;
        m_cells.emplace_back(cellNumber(cellOf(at.x()), cellOf(at.y())), static_cast<int>(i));
    }
    std::ranges::sort(m_cells);
    m_partners.reserve(m_ends.size());
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
        const std::vector<int> met = around(static_cast<int>(i), lint_limits::together);
        m_partners.push_back(met.size() == 1 ? met.front() : -1);
    }
}

std::vector<int> WallEnds::around(int end, double distance) const {
    constexpr int crowd = 64; // whoever heaps up more ends in one place is not told about each pair
    const WallEndPoint& own = m_ends[static_cast<std::size_t>(end)];
    std::vector<int> found;
    for (std::int64_t x = cellOf(own.at.x() - distance); x <= cellOf(own.at.x() + distance); ++x) {
        for (std::int64_t y = cellOf(own.at.y() - distance); y <= cellOf(own.at.y() + distance); ++y) {
            const std::int64_t cell = cellNumber(x, y);
            auto at = std::ranges::lower_bound(m_cells, cell, {}, &std::pair<std::int64_t, int>::first);
            for (int seen = 0; at != m_cells.end() && at->first == cell && seen < crowd; ++at, ++seen) {
                const WallEndPoint& other = m_ends[static_cast<std::size_t>(at->second)];
                const WallChain& a = m_chains[static_cast<std::size_t>(own.chain)];
                const WallChain& b = m_chains[static_cast<std::size_t>(other.chain)];
                if (at->second != end && (other.at - own.at).norm() <= distance && standTogether(a, b)) {
                    found.push_back(at->second);
                }
            }
        }
    }
    return found;
}

WallTree::WallTree(const std::vector<WallChain>& chains) {
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        if (!chains[i].isStill()) {
            continue;
        }
        for (int s = 0; s < chains[i].segments(); ++s) {
            segments.push_back({static_cast<int>(i), s});
            Aabb box;
            box.include(chains[i].start(s));
            box.include(chains[i].end(s));
            boxes.push_back(box);
        }
    }
    tree = StaticQuadtree(std::move(boxes));
}

void checkWalls(const Level& level, Findings& findings) {
    const Walls walls(wallChains(level, findings));
    for (const auto rule : {checkDirections, checkGaps, checkOverlaps, checkDepths, checkCaves}) {
        if (!findings.isStopped()) {
            rule(level, walls, findings);
        }
    }
}

} // namespace spacetow
