// How edges come to be where they have to be.
#include "core/base/contract.h"
#include "core/geometry/constrained_triangulation.h"

#include <cmath>

namespace spacetow {

ConstrainedTriangulation::Crossed ConstrainedTriangulation::crossedBy(int a, int b) const {
    Crossed crossed;
    const GridPoint& from = point(a);
    const GridPoint& to = point(b);
    const auto turn = [&](int vertex) { return turnOf(from, to, point(vertex)); };
    const auto isAhead = [&](int vertex) {
        const GridPoint& p = point(vertex);
        return (to.x - from.x) * (p.x - from.x) + (to.y - from.y) * (p.y - from.y) > 0;
    };
    int edge = -1;
    for (const int out : edgesFrom(a)) {
        const int right = target(out);
        if (turn(right) == 0 && isAhead(right)) {
            crossed.vertex = right;
            return crossed;
        }
        if (turn(right) < 0 && turn(target(next(out))) > 0) {
            edge = next(out);
        }
    }
    EXPECTS(edge >= 0);
    // Where walls nearly lie on each other, crossings that are rounded would cross again next to where they did, and so
    // on all along the wall. What passes a vertex as closely as the grid rounds leads through it instead (snap
    // rounding: J. D. Hobby, "Practical segment intersection with finite precision output", 1999).
    const auto squared = [](const GridPoint& p, const GridPoint& q) {
        return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
    };
    const std::int64_t length = squared(from, to);
    const auto isPassed = [&](int vertex) {
        const GridPoint& p = point(vertex);
        const auto area = static_cast<double>(turn(vertex));
        return area * area <= static_cast<double>(length) && squared(from, p) < length && squared(p, to) < length;
    };
    for (;;) {
        for (const int end : {origin(edge), target(edge)}) {
            if (isPassed(end)) {
                crossed.vertex = end;
                return crossed;
            }
        }
        if (isConstraint(edge)) {
            crossed.edge = edge;
            return crossed;
        }
        crossed.way.emplace_back(origin(edge), target(edge));
        const int beyond = twin(edge);
        const int apex = origin(previous(beyond));
        if (turn(apex) == 0) {
            crossed.vertex = apex;
            return crossed;
        }
        // From the right of the way to its left.
        edge = turn(apex) > 0 ? next(beyond) : previous(beyond);
    }
}

bool ConstrainedTriangulation::constrain(int a, int b, const SideLabels& labels) {
    m_work.assign(1, {a, b, labels});
    return work();
}

int ConstrainedTriangulation::bend(int edge, const GridPoint& via) {
    m_work.clear();
    const int vertex = reroute(edge, via);
    work();
    return vertex;
}

bool ConstrainedTriangulation::isVisible(int a, int b) const {
    if (const int edge = edgeBetween(a, b); edge >= 0) {
        return !isConstraint(edge);
    }
    const Crossed crossed = crossedBy(a, b);
    return crossed.edge < 0 && crossed.vertex == b;
}

/// Does what there is to do for the constraints in `m_work`.
bool ConstrainedTriangulation::work() {
    const int mostCrossings = 20 * vertexCount() + 10000;
    while (!m_work.empty()) {
        const Constraint todo = m_work.back();
        m_work.pop_back();
        if (todo.a == todo.b) {
            continue;
        }
        if (const int edge = edgeBetween(todo.a, todo.b); edge >= 0) {
            label(edge, todo.labels);
            continue;
        }
        const Crossed crossed = crossedBy(todo.a, todo.b);
        if (crossed.edge >= 0) {
            if (++m_crossings > mostCrossings) {
                m_work.clear();
                return false;
            }
            cross(todo, crossed.edge);
        } else if (crossed.vertex != todo.b) {
            m_work.push_back({crossed.vertex, todo.b, todo.labels});
            m_work.push_back({todo.a, crossed.vertex, todo.labels});
        } else if (!clear(todo, {crossed.way.begin(), crossed.way.end()})) {
            m_work.clear();
            return false;
        }
    }
    return true;
}

/// Both constraints lead through the point where they cross, which is rounded: the one in place is made anew as well.
void ConstrainedTriangulation::cross(const Constraint& constraint, int edge) {
    const int u = origin(edge);
    const int w = target(edge);
    const auto fromA = static_cast<double>(turnOf(point(u), point(w), point(constraint.a)));
    const auto fromB = static_cast<double>(turnOf(point(u), point(w), point(constraint.b)));
    const double share = fromA / (fromA - fromB);
    const GridPoint& a = point(constraint.a);
    const GridPoint& b = point(constraint.b);
    const GridPoint at{a.x + std::llround(share * static_cast<double>(b.x - a.x)),
                       a.y + std::llround(share * static_cast<double>(b.y - a.y))};
    const int middle = reroute(edge, at);
    m_work.push_back({constraint.a, middle, constraint.labels});
    m_work.push_back({middle, constraint.b, constraint.labels});
}

/// Takes a constraint out and leaves it to do again through another vertex.
int ConstrainedTriangulation::reroute(int edge, const GridPoint& via) {
    const int u = origin(edge);
    const int w = target(edge);
    const SideLabels standing{labelOf(edge), labelOf(twin(edge))};
    m_label[index(edge)] = m_label[index(twin(edge))] = SideLabels::none;
    const int middle = insert(via);
    m_work.push_back({u, middle, standing});
    m_work.push_back({middle, w, standing});
    return middle;
}

/// Flips free edges until none crosses the way (S. W. Sloan, "A fast algorithm for generating constrained Delaunay
/// triangulations", 1993).
bool ConstrainedTriangulation::clear(const Constraint& constraint, std::deque<std::pair<int, int>> way) {
    const GridPoint& a = point(constraint.a);
    const GridPoint& b = point(constraint.b);
    std::vector<std::pair<int, int>> fresh;
    const std::size_t most = way.size() * way.size() + 1000;
    for (std::size_t steps = 0; !way.empty(); ++steps) {
        if (steps > most) {
            return false;
        }
        const auto [u, w] = way.front();
        way.pop_front();
        const int edge = edgeBetween(u, w);
        const int c = origin(previous(edge));
        const int d = origin(previous(twin(edge)));
        const std::int64_t atU = turnOf(point(c), point(d), point(u));
        const std::int64_t atW = turnOf(point(c), point(d), point(w));
        if (!((atU > 0 && atW < 0) || (atU < 0 && atW > 0))) {
            way.emplace_back(u, w);
            continue;
        }
        flip(edge);
        const std::int64_t atC = turnOf(a, b, point(c));
        const std::int64_t atD = turnOf(a, b, point(d));
        const bool crosses = (atC > 0 && atD < 0) || (atC < 0 && atD > 0);
        (crosses ? static_cast<void>(way.emplace_back(c, d)) : static_cast<void>(fresh.emplace_back(c, d)));
    }
    label(edgeBetween(constraint.a, constraint.b), constraint.labels);
    for (bool changed = true; changed;) {
        changed = false;
        for (auto& [u, w] : fresh) {
            const int edge = edgeBetween(u, w);
            if (!isDelaunay(edge)) {
                const std::pair<int, int> turned{origin(previous(edge)), origin(previous(twin(edge)))};
                flip(edge);
                u = turned.first;
                w = turned.second;
                changed = true;
            }
        }
    }
    return true;
}

} // namespace spacetow
