#include "core/level/leak_mesh.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

Vec2 vecOf(const GridPoint& p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

Vec2 between(const GridPoint& from, const GridPoint& to) {
    return {static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)};
}

} // namespace

LeakMesh::LeakMesh(const std::vector<LeakWall>& walls, const Vec2& ship, double width, const std::stop_token& stop)
    : m_shut(walls.size(), 0) {
    Aabb box;
    box.include(ship);
    for (const LeakWall& wall : walls) {
        box.include(wall.a);
        box.include(wall.b);
    }
    const double size = std::max(box.size().maxCoeff(), 1.0);
    const double side = 2 * size + 2; // m; of the square, with the level in its middle
    m_unit = side / static_cast<double>(ConstrainedTriangulation::size);
    m_low = box.center() - Vec2(side, side) / 2;
    m_width = width / m_unit;
    addWalls(walls, stop);
    if (m_isSound) {
        addNearestPoints(stop);
    }
    if (m_isSound && !stop.stop_requested()) {
        closeShortRuns();
        closeGaps();
        findStart(ship);
    }
    m_isSound = m_isSound && !stop.stop_requested();
}

GridPoint LeakMesh::grid(const Vec2& place) const {
    const Vec2 p = (place - m_low) / m_unit;
    const std::int64_t most = ConstrainedTriangulation::size - 1;
    return {std::clamp<std::int64_t>(std::llround(p.x()), 1, most),
            std::clamp<std::int64_t>(std::llround(p.y()), 1, most)};
}

Vec2 LeakMesh::at(int vertex) const {
    return m_low + m_unit * vecOf(m_net.point(vertex));
}

bool LeakMesh::isOutside(int triangle) const {
    for (int i = 0; i < 3; ++i) {
        if (m_net.origin(3 * triangle + i) < ConstrainedTriangulation::corners) {
            return true;
        }
    }
    return false;
}

bool LeakMesh::lets(int edge) const {
    const int twin = m_net.twin(edge);
    if (twin < 0) {
        return false;
    }
    const int here = m_net.labelOf(edge);
    if (here >= 0 && !(isClosureLabel(here) && m_open[static_cast<std::size_t>(here - gapLabel() - 1)])) {
        return false;
    }
    const int wall = wallFromBehind(edge);
    return wall < 0 || !m_shut[static_cast<std::size_t>(wall)];
}

int LeakMesh::wallFromBehind(int edge) const {
    const int twin = m_net.twin(edge);
    const int there = twin >= 0 ? m_net.labelOf(twin) : SideLabels::none;
    return !isWall(m_net.labelOf(edge)) && isWall(there) ? there : -1;
}

int LeakMesh::wallOn(int edge) const {
    return isWall(m_net.labelOf(edge)) ? m_net.labelOf(edge) : wallFromBehind(edge);
}

int LeakMesh::close(int a, int b) {
    if (a == b || !m_net.isVisible(a, b)) {
        return -1;
    }
    const int closure = static_cast<int>(m_open.size());
    const int label = gapLabel() + 1 + closure;
    m_open.push_back(0);
    const bool stands = m_net.constrain(a, b, {label, label});
    m_start = m_net.triangleAt(m_startAt) / 3;
    m_open.back() = stands ? 0 : 1;
    return stands ? closure : -1;
}

void LeakMesh::addWalls(const std::vector<LeakWall>& walls, const std::stop_token& stop) {
    std::vector<GridPoint> points;
    points.reserve(2 * walls.size());
    for (const LeakWall& wall : walls) {
        points.push_back(grid(wall.a));
        points.push_back(grid(wall.b));
    }
    const std::vector<int> vertices = m_net.insertAll(points, stop);
    for (std::size_t i = 0; i < walls.size() && m_isSound; ++i) {
        const int label = static_cast<int>(i);
        const SideLabels labels{label, walls[i].oneWay ? SideLabels::none : label};
        m_isSound =
            !(i % 256 == 0 && stop.stop_requested()) && m_net.constrain(vertices[2 * i], vertices[2 * i + 1], labels);
    }
}

void LeakMesh::addNearestPoints(const std::stop_token& stop) {
    std::vector<Bend> bends;
    const int count = m_net.vertexCount();
    for (int vertex = ConstrainedTriangulation::corners; vertex < count; ++vertex) {
        if (vertex % 1024 == 0 && stop.stop_requested()) {
            return;
        }
        lookAround(vertex, m_width, bends);
    }
    // Those of one wall in their order, so that each cuts off its beginning.
    std::ranges::sort(bends, [](const Bend& a, const Bend& b) {
        return a.u != b.u ? a.u < b.u : (a.w != b.w ? a.w < b.w : a.along < b.along);
    });
    int last = -1; // the vertex that was made before
    for (std::size_t i = 0; i < bends.size(); ++i) {
        const Bend& bend = bends[i];
        const bool goesOn = last >= 0 && i > 0 && bend.u == bends[i - 1].u && bend.w == bends[i - 1].w;
        if (goesOn && bend.at == bends[i - 1].at) {
            continue;
        }
        const int edge = m_net.edgeBetween(goesOn ? last : bend.u, bend.w);
        last = edge >= 0 && m_net.isConstraint(edge) ? m_net.bend(edge, bend.at) : -1;
    }
}

std::vector<int> LeakMesh::addNearestTo(int vertex, double metres) {
    constexpr std::size_t few = 4;
    std::vector<Bend> bends;
    lookAround(vertex, metres / m_unit, bends);
    const GridPoint eye = m_net.point(vertex);
    std::ranges::sort(bends, {}, [&eye](const Bend& bend) { return between(eye, bend.at).squaredNorm(); });
    std::vector<int> vertices;
    for (std::size_t i = 0; i < std::min(few, bends.size()); ++i) {
        const int edge = m_net.edgeBetween(bends[i].u, bends[i].w);
        if (edge >= 0 && m_net.isConstraint(edge)) {
            vertices.push_back(m_net.bend(edge, bends[i].at));
        }
    }
    m_start = m_net.triangleAt(m_startAt) / 3;
    return vertices;
}

/// Looks for the walls that have their nearest point to a vertex, within `reach`, between their ends.
void LeakMesh::lookAround(int vertex, double reach, std::vector<Bend>& bends) const {
    std::vector<Cone> cones;
    for (const int out : m_net.edgesFrom(vertex)) {
        const int opposite = ConstrainedTriangulation::next(out);
        cones.push_back({opposite, m_net.origin(opposite), m_net.target(opposite)});
    }
    const GridPoint& eye = m_net.point(vertex);
    const auto isLeft = [&](int of, int point) {
        return cross(between(eye, m_net.point(of)), between(eye, m_net.point(point))) > 0;
    };
    for (int steps = 0; !cones.empty() && steps < 1000; ++steps) {
        const Cone cone = cones.back();
        cones.pop_back();
        const Vec2 a = between(eye, m_net.point(m_net.origin(cone.edge)));
        const Vec2 along = between(m_net.point(m_net.origin(cone.edge)), m_net.point(m_net.target(cone.edge)));
        const double t = std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0);
        if ((a + t * along).squaredNorm() >= reach * reach || m_net.twin(cone.edge) < 0) {
            continue;
        }
        if (m_net.labelOf(cone.edge) >= 0) {
            Bend bend{};
            if (t > 0 && t < 1 && isNearest(vertex, cone.edge, bend)) {
                bends.push_back(bend);
            }
            continue;
        }
        const int beyond = m_net.twin(cone.edge);
        const int apex = m_net.origin(ConstrainedTriangulation::previous(beyond));
        if (isLeft(cone.right, apex)) {
            cones.push_back(
                {ConstrainedTriangulation::next(beyond), cone.right, isLeft(cone.left, apex) ? cone.left : apex});
        }
        if (isLeft(apex, cone.left)) {
            cones.push_back(
                {ConstrainedTriangulation::previous(beyond), isLeft(cone.right, apex) ? apex : cone.right, cone.left});
        }
    }
}

bool LeakMesh::isNearest(int vertex, int edge, Bend& bend) const {
    constexpr double least = 4; // grid, from the ends: nearer than this the end stands for it
    const GridPoint& eye = m_net.point(vertex);
    const GridPoint& from = m_net.point(m_net.origin(edge));
    const Vec2 along = between(from, m_net.point(m_net.target(edge)));
    const double t = between(from, eye).dot(along) / along.squaredNorm();
    const Vec2 foot = t * along;
    bend = {
        m_net.origin(edge), m_net.target(edge), {from.x + std::llround(foot.x()), from.y + std::llround(foot.y())}, t};
    if (std::min(t, 1 - t) * along.norm() < least) {
        return false;
    }
    // A wall that leads from here nearer to the other one is nearer to it.
    const Vec2 way = between(eye, bend.at);
    for (const int out : m_net.edgesFrom(vertex)) {
        if (m_net.isConstraint(out) && between(eye, m_net.point(m_net.target(out))).dot(way) > 1e-9 * way.norm()) {
            return false;
        }
    }
    // Both ends of an edge see it from their sides: one order for both.
    if (bend.u > bend.w) {
        std::swap(bend.u, bend.w);
        bend.along = 1 - t;
    }
    return stops(vertex, way);
}

/// Points of one-way walls stop only what comes from in front, except where they end.
bool LeakMesh::isHard(int vertex) const {
    int outgoing = 0;
    int incoming = 0;
    for (const int edge : m_net.edgesFrom(vertex)) {
        const bool left = isWall(m_net.labelOf(edge));
        const bool right = isWall(m_net.labelOf(m_net.twin(edge)));
        if (left && right) {
            return true;
        }
        outgoing += left ? 1 : 0;
        incoming += right ? 1 : 0;
    }
    return outgoing != incoming;
}

bool LeakMesh::stops(int vertex, const Vec2& direction) const {
    if (isHard(vertex)) {
        return true;
    }
    int seen = 0;
    int count = 0;
    Vec2 in(0, 0);
    Vec2 out(0, 0);
    for (const int edge : m_net.edgesFrom(vertex)) {
        const bool left = isWall(m_net.labelOf(edge));
        const bool right = isWall(m_net.labelOf(m_net.twin(edge)));
        if (left || right) {
            const Vec2 away = between(m_net.point(vertex), m_net.point(m_net.target(edge)));
            const Vec2 along = left ? away : -away;
            (left ? out : in) = along;
            ++count;
            seen += cross(along, direction) >= 0 ? 1 : 0;
        }
    }
    const bool isHollow = count == 2 && cross(in, out) >= 0;
    return isHollow ? seen == 2 : seen > 0;
}

/// One-way walls between ends that the ship does not fit through: behind, it is as if they were shut.
void LeakMesh::closeShortRuns() {
    const auto oneWayFrom = [this](int vertex) {
        for (const int edge : m_net.edgesFrom(vertex)) {
            if (isWall(m_net.labelOf(edge)) && m_net.labelOf(m_net.twin(edge)) < 0) {
                return edge;
            }
        }
        return -1;
    };
    std::vector<int> run;
    for (int vertex = ConstrainedTriangulation::corners; vertex < m_net.vertexCount(); ++vertex) {
        if (!isHard(vertex)) {
            continue;
        }
        for (const int first : m_net.edgesFrom(vertex)) {
            double length = 0;
            run.clear();
            int edge = first;
            if (!isWall(m_net.labelOf(first)) || m_net.labelOf(m_net.twin(first)) >= 0) {
                continue;
            }
            while (edge >= 0 && length < 2 * m_width) {
                run.push_back(edge);
                const int end = m_net.target(edge);
                length += between(m_net.point(m_net.origin(edge)), m_net.point(end)).norm();
                if (isHard(end)) {
                    break;
                }
                edge = oneWayFrom(end);
            }
            const int end = m_net.target(run.back());
            if (isHard(end) && between(m_net.point(vertex), m_net.point(end)).norm() < m_width) {
                for (const int piece : run) {
                    m_net.label(m_net.twin(piece), {gapLabel(), SideLabels::none});
                }
            }
        }
    }
}

void LeakMesh::closeGaps() {
    std::vector<int> gaps;
    for (int edge = 0; edge < m_net.edgeCount(); ++edge) {
        const int a = m_net.origin(edge);
        const int b = m_net.target(edge);
        if (edge > m_net.twin(edge) || std::min(a, b) < ConstrainedTriangulation::corners || m_net.isConstraint(edge)) {
            continue;
        }
        const Vec2 way = between(m_net.point(a), m_net.point(b));
        if (way.squaredNorm() < m_width * m_width && stops(a, way) && stops(b, -way)) {
            gaps.push_back(edge);
        }
    }
    for (const int edge : gaps) {
        m_net.label(edge, {gapLabel(), gapLabel()});
    }
}

/// The triangle of the ship. Where gaps have cut off a corner that is too small for it, which it then only reaches
/// into, the place next to that.
void LeakMesh::findStart(const Vec2& ship) {
    const double least = 0.5 * m_width * m_width; // grid², of a place for a ship
    std::vector<int> reached{triangleAt(ship)};
    std::vector<char> isReached(static_cast<std::size_t>(m_net.edgeCount() / 3), 0);
    isReached[static_cast<std::size_t>(reached.front())] = 1;
    double area = 0;
    bool isNext = false;
    m_start = reached.front();
    m_startAt = grid(ship);
    for (std::size_t i = 0; area < least; ++i) {
        if (i == reached.size()) {
            // All is seen: over the gaps now.
            for (std::size_t k = 0, end = reached.size(); k < end; ++k) {
                for (int edge = 3 * reached[k]; edge < 3 * reached[k] + 3; ++edge) {
                    const int twin = m_net.twin(edge);
                    if (m_net.labelOf(edge) == gapLabel() && twin >= 0 && wallFromBehind(edge) < 0 &&
                        !isReached[static_cast<std::size_t>(twin / 3)]) {
                        isReached[static_cast<std::size_t>(twin / 3)] = 1;
                        reached.push_back(twin / 3);
                    }
                }
            }
            if (i == reached.size()) {
                break;
            }
            area = 0;
            isNext = true;
        }
        const int t = reached[i];
        if (isNext) {
            m_start = t;
            const GridPoint& b = m_net.point(m_net.origin(3 * t + 1));
            const GridPoint& c = m_net.point(m_net.origin(3 * t + 2));
            const GridPoint& d = m_net.point(m_net.origin(3 * t));
            m_startAt = {(b.x + c.x + d.x) / 3, (b.y + c.y + d.y) / 3};
        }
        const GridPoint& a = m_net.point(m_net.origin(3 * t));
        area += 0.5 * cross(between(a, m_net.point(m_net.origin(3 * t + 1))),
                            between(a, m_net.point(m_net.origin(3 * t + 2))));
        for (int edge = 3 * t; edge < 3 * t + 3; ++edge) {
            const int twin = m_net.twin(edge);
            if (lets(edge) && !isReached[static_cast<std::size_t>(twin / 3)]) {
                isReached[static_cast<std::size_t>(twin / 3)] = 1;
                reached.push_back(twin / 3);
            }
        }
    }
}

} // namespace spacetow
