#pragma once
// A constrained Delaunay triangulation of points on an integer grid. Orientation tests are exact, so any input is
// valid: coincident points, and constraints that cross, touch or overlap. Where constraints cross, a new vertex is
// inserted on the grid.

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace spacetow {

struct GridPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;

    bool operator==(const GridPoint&) const = default;
};

/// Twice the area of the triangle, exactly; positive when it is anticlockwise.
inline std::int64_t turnOf(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The labels of the two sides of a constraint: numbers ≥ 0 of the caller, or none.
struct SideLabels {
    static constexpr int none = -1;

    int left = none;
    int right = none;
};

/// Half-edge 3t + i leads from corner i of triangle t to the next one; triangles are anticlockwise, so each half-edge
/// has its triangle on its left. An edge with a label on either side is a constraint.
class ConstrainedTriangulation {
  public:
    static constexpr std::int64_t size = std::int64_t{1} << 28; // coordinates are 1 … size − 1
    static constexpr int corners = 4;                           // the first vertices: those of the square around all

    ConstrainedTriangulation();

    /// Inserts the points, in an order that is fast. Returns the vertex of each; equal points share one.
    std::vector<int> insertAll(const std::vector<GridPoint>& points, const std::stop_token& stop = {});
    int insert(const GridPoint& point);
    /// Makes the segment from `a` to `b` a constraint. A side that already has a label keeps it. Returns false if
    /// constraints cross too often to go on.
    bool constrain(int a, int b, const SideLabels& labels);
    /// Bends a constraint through a point beside it, or within rounding on it. Returns the vertex of the point.
    int bend(int edge, const GridPoint& via);
    /// Whether the segment between two vertices inside the square crosses no constraint.
    bool isVisible(int a, int b) const;
    /// Adds a label to the sides of one edge that have none.
    void label(int edge, const SideLabels& labels);

    int vertexCount() const { return static_cast<int>(m_points.size()); }
    int edgeCount() const { return static_cast<int>(m_origin.size()); }
    const GridPoint& point(int vertex) const { return m_points[index(vertex)]; }
    int origin(int edge) const { return m_origin[index(edge)]; }
    int target(int edge) const { return origin(next(edge)); }
    /// The same edge from the other side; −1 on the border of the square.
    int twin(int edge) const { return m_twin[index(edge)]; }
    /// The label of the edge on the side of its triangle.
    int labelOf(int edge) const { return m_label[index(edge)]; }
    bool isConstraint(int edge) const { return labelOf(edge) >= 0 || (twin(edge) >= 0 && labelOf(twin(edge)) >= 0); }
    static int next(int edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; }
    static int previous(int edge) { return edge % 3 == 0 ? edge + 2 : edge - 1; }
    /// The edges that start at a vertex inside the square, anticlockwise.
    std::vector<int> edgesFrom(int vertex) const;
    /// −1 when there is none.
    int edgeBetween(int a, int b) const;
    /// An edge of the triangle that contains the point, border included.
    int triangleAt(const GridPoint& point) const;

  private:
    struct Constraint {
        int a, b;
        SideLabels labels;
    };
    struct Crossed { // the first vertex or constraint that a segment meets
        int vertex = -1;
        int edge = -1;                        // a constraint
        std::vector<std::pair<int, int>> way; // free edges before it, by their ends
    };

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    void set(int edge, int origin, int twin, int label);
    void flip(int edge);
    void splitEdge(int edge, int vertex);
    void splitTriangle(int edge, int vertex);
    void makeDelaunay(std::vector<int>& around);
    bool isDelaunay(int edge) const;
    Crossed crossedBy(int a, int b) const;
    bool work();
    void cross(const Constraint& constraint, int edge);
    int reroute(int edge, const GridPoint& via);
    bool clear(const Constraint& constraint, std::deque<std::pair<int, int>> way);

    std::vector<GridPoint> m_points;
    std::vector<int> m_edgeFrom; // of each vertex
    std::vector<int> m_origin, m_twin, m_label;
    std::vector<Constraint> m_work;
    mutable int m_last = 0; // edge of the triangle of the last search
    int m_crossings = 0;
};

} // namespace spacetow
