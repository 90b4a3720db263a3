#include "core/geometry/constrained_triangulation.h"

#include "core/base/contract.h"
#include "core/base/random.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// Whether d is clearly in the circle through a, b and c. Rounding may answer no where it is a near thing, never yes,
/// so that flips come to an end.
bool isInCircle(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
    const auto ax = static_cast<double>(a.x - d.x);
    const auto ay = static_cast<double>(a.y - d.y);
    const auto bx = static_cast<double>(b.x - d.x);
    const auto by = static_cast<double>(b.y - d.y);
    const auto cx = static_cast<double>(c.x - d.x);
    const auto cy = static_cast<double>(c.y - d.y);
    const double a2 = ax * ax + ay * ay;
    const double b2 = bx * bx + by * by;
    const double c2 = cx * cx + cy * cy;
    const double value = a2 * (bx * cy - by * cx) - b2 * (ax * cy - ay * cx) + c2 * (ax * by - ay * bx);
    const double sum = a2 * (std::abs(bx * cy) + std::abs(by * cx)) + b2 * (std::abs(ax * cy) + std::abs(ay * cx)) +
                       c2 * (std::abs(ax * by) + std::abs(ay * bx));
    return value > 1e-14 * sum;
}

std::uint64_t spread(std::uint64_t v) {
    v = (v | v << 16u) & 0x0000ffff0000ffffu;
    v = (v | v << 8u) & 0x00ff00ff00ff00ffu;
    v = (v | v << 4u) & 0x0f0f0f0f0f0f0f0fu;
    v = (v | v << 2u) & 0x3333333333333333u;
    return (v | v << 1u) & 0x5555555555555555u;
}

/// Neighbours first, in rounds of which each is twice as large as the one before: no point has far to go then, and no
/// triangle is cut too often (Amenta, Choi and Rote, "Incremental constructions con BRIO", 2003).
std::vector<int> goodOrder(const std::vector<GridPoint>& points) {
    Random random(1);
    std::vector<std::pair<std::uint64_t, int>> places;
    places.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::uint64_t round = 15;
        while (round > 0 && (random.next() & 1u) != 0) {
            --round;
        }
        const auto x = static_cast<std::uint64_t>(points[i].x);
        const auto y = static_cast<std::uint64_t>(points[i].y);
        places.emplace_back(round << 58u | spread(x) | spread(y) << 1u, static_cast<int>(i));
    }
    std::ranges::sort(places);
    std::vector<int> order;
    order.reserve(points.size());
    for (const auto& place : places) {
        order.push_back(place.second);
    }
    return order;
}

} // namespace

ConstrainedTriangulation::ConstrainedTriangulation()
    : m_points{{0, 0}, {size, 0}, {size, size}, {0, size}},
      m_edgeFrom{0, 1, 2, 5}, m_origin{0, 1, 2, 0, 2, 3}, m_twin{-1, -1, 3, 2, -1, -1}, m_label(6, SideLabels::none) {}

std::vector<int> ConstrainedTriangulation::insertAll(const std::vector<GridPoint>& points,
                                                     const std::stop_token& stop) {
    std::vector<int> vertices(points.size(), 0);
    int done = 0;
    for (const int i : goodOrder(points)) {
        if (++done % 1024 == 0 && stop.stop_requested()) {
            break;
        }
        vertices[index(i)] = insert(points[index(i)]);
    }
    return vertices;
}

void ConstrainedTriangulation::set(int edge, int origin, int twin, int label) {
    m_origin[index(edge)] = origin;
    m_twin[index(edge)] = twin;
    m_label[index(edge)] = label;
    if (twin >= 0) {
        m_twin[index(twin)] = edge;
    }
    m_edgeFrom[index(origin)] = edge;
}

int ConstrainedTriangulation::triangleAt(const GridPoint& point) const {
    // From triangle to triangle towards the point. With constraints that may go in a circle, unless the edge to begin
    // with changes.
    int edge = m_last;
    for (unsigned step = 0;; ++step) {
        int out = -1;
        int e = edge;
        for (unsigned i = 0; i < (step * 2654435761u >> 16u) % 3; ++i) {
            e = next(e);
        }
        for (int i = 0; i < 3 && out < 0; ++i, e = next(e)) {
            if (turnOf(this->point(origin(e)), this->point(target(e)), point) < 0) {
                out = e;
            }
        }
        if (out < 0) {
            m_last = edge;
            return edge;
        }
        edge = twin(out);
        EXPECTS(edge >= 0);
    }
}

int ConstrainedTriangulation::insert(const GridPoint& point) {
    EXPECTS(point.x > 0 && point.y > 0 && point.x < size && point.y < size);
    const int found = triangleAt(point);
    int on = -1;
    for (const int e : {found, next(found), previous(found)}) {
        if (this->point(origin(e)) == point) {
            return origin(e);
        }
        if (turnOf(this->point(origin(e)), this->point(target(e)), point) == 0) {
            on = e;
        }
    }
    const int vertex = vertexCount();
    m_points.push_back(point);
    m_edgeFrom.push_back(-1);
    if (on >= 0) {
        splitEdge(on, vertex);
    } else {
        splitTriangle(found, vertex);
    }
    return vertex;
}

void ConstrainedTriangulation::splitTriangle(int edge, int vertex) {
    const int ab = edge;
    const int bc = next(edge);
    const int ca = previous(edge);
    const int a = origin(ab);
    const int b = origin(bc);
    const int c = origin(ca);
    const int first = edgeCount();
    const int twinBc = twin(bc);
    const int labelBc = labelOf(bc);
    const int twinCa = twin(ca);
    const int labelCa = labelOf(ca);
    m_origin.resize(index(first + 6));
    m_twin.resize(index(first + 6));
    m_label.resize(index(first + 6));
    const int none = SideLabels::none;
    set(first, b, twinBc, labelBc);     // b c v
    set(first + 3, c, twinCa, labelCa); // c a v
    set(first + 1, c, -1, none);
    set(first + 2, vertex, -1, none);
    set(first + 4, a, -1, none);
    set(first + 5, vertex, first + 1, none);
    set(bc, b, first + 2, none); // a b v
    set(ca, vertex, first + 4, none);
    std::vector<int> around{ab, first, first + 3};
    makeDelaunay(around);
}

void ConstrainedTriangulation::splitEdge(int edge, int vertex) {
    const int ab = edge;
    const int bc = next(ab);
    const int ca = previous(ab);
    const int ba = twin(ab);
    EXPECTS(ba >= 0);
    const int ad = next(ba);
    const int db = previous(ba);
    const int a = origin(ab);
    const int b = origin(ba);
    const int c = origin(ca);
    const int d = origin(db);
    const int left = labelOf(ab);
    const int right = labelOf(ba);
    const int first = edgeCount();
    const int twinBc = twin(bc);
    const int labelBc = labelOf(bc);
    const int twinAd = twin(ad);
    const int labelAd = labelOf(ad);
    m_origin.resize(index(first + 6));
    m_twin.resize(index(first + 6));
    m_label.resize(index(first + 6));
    const int none = SideLabels::none;
    set(first + 1, b, twinBc, labelBc); // v b c
    set(first + 2, c, -1, none);
    set(bc, vertex, first + 2, none);   // a v c
    set(first + 4, a, twinAd, labelAd); // v a d
    set(first + 5, d, -1, none);
    set(ad, vertex, first + 5, none); // b v d
    set(first, vertex, ba, left);
    set(first + 3, vertex, ab, right);
    m_origin[index(ab)] = a;
    m_origin[index(ba)] = b;
    std::vector<int> around{ca, first + 1, db, first + 4};
    makeDelaunay(around);
}

/// Of the two triangles beside the edge, the two that the other diagonal makes. The edge must be free.
void ConstrainedTriangulation::flip(int edge) {
    const int e = edge;
    const int en = next(e);
    const int f = twin(e);
    const int fn = next(f);
    const int a = origin(e);
    const int b = origin(f);
    const int c = origin(previous(e));
    const int d = origin(previous(f));
    const int twinFn = twin(fn);
    const int labelFn = labelOf(fn);
    const int twinEn = twin(en);
    const int labelEn = labelOf(en);
    set(e, a, twinFn, labelFn);
    set(f, b, twinEn, labelEn);
    set(en, d, fn, SideLabels::none);
    set(fn, c, en, SideLabels::none);
}

bool ConstrainedTriangulation::isDelaunay(int edge) const {
    const int other = twin(edge);
    if (other < 0 || isConstraint(edge)) {
        return true;
    }
    return !isInCircle(point(origin(edge)), point(target(edge)), point(origin(previous(edge))),
                       point(origin(previous(other))));
}

/// `around`: the edges opposite to a new vertex.
void ConstrainedTriangulation::makeDelaunay(std::vector<int>& around) {
    while (!around.empty()) {
        const int edge = around.back();
        around.pop_back();
        if (!isDelaunay(edge)) {
            const int other = previous(twin(edge));
            flip(edge);
            around.push_back(edge);
            around.push_back(other);
        }
    }
}

std::vector<int> ConstrainedTriangulation::edgesFrom(int vertex) const {
    std::vector<int> edges;
    const int first = m_edgeFrom[index(vertex)];
    int edge = first;
    do {
        edges.push_back(edge);
        edge = twin(previous(edge));
    } while (edge >= 0 && edge != first);
    return edges;
}

int ConstrainedTriangulation::edgeBetween(int a, int b) const {
    const int first = m_edgeFrom[index(a)];
    int edge = first;
    do {
        if (target(edge) == b) {
            return edge;
        }
        edge = twin(previous(edge));
    } while (edge >= 0 && edge != first);
    if (edge < 0) { // a corner of the square: the other way round
        for (edge = twin(first); edge >= 0; edge = twin(edge)) {
            edge = next(edge);
            if (target(edge) == b) {
                return edge;
            }
        }
    }
    return -1;
}

void ConstrainedTriangulation::label(int edge, const SideLabels& labels) {
    const auto add = [this](int side, int label) {
        if (side >= 0 && labelOf(side) < 0) {
            m_label[index(side)] = label;
        }
    };
    add(edge, labels.left);
    add(twin(edge), labels.right);
}

} // namespace spacetow
