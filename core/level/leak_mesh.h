#pragma once
// The plane around the walls of a level cut into triangles, over whose edges the ship can go or not. World coordinates,
// metres.
//
// The ship counts as a disc. A disc cannot pass between two points of walls that are closer to each other than it is
// wide. Where all such pairs are joined, whatever a point can reach, a disc can: the walls, each grown by the disc's
// radius, are convex, so that which of them meet says which parts of the plane they separate. Of those pairs the ones
// are enough that have no third wall in the circle over them, and these are edges of a Delaunay triangulation, once
// walls have a vertex wherever a corner is nearest to them.

#include "core/geometry/constrained_triangulation.h"
#include "core/level/leak_walls.h"
#include "core/math/aabb.h"

namespace spacetow {

class LeakMesh {
  public:
    /// Whoever asks `isSound()` afterwards knows whether it was made: not when it was stopped, or the walls are too
    /// much of a tangle.
    LeakMesh(const std::vector<LeakWall>& walls, const Vec2& ship, double width, const std::stop_token& stop);

    bool isSound() const { return m_isSound; }
    const ConstrainedTriangulation& net() const { return m_net; }
    Vec2 at(int vertex) const;
    int triangleAt(const Vec2& place) const { return m_net.triangleAt(grid(place)) / 3; }
    /// Where the ship starts.
    int start() const { return m_start; }
    /// Beyond all walls.
    bool isOutside(int triangle) const;

    /// Whether the ship can leave the edge's triangle over it.
    bool lets(int edge) const;
    /// The one-way wall, by its place, which is seen from behind over this edge; −1 for none.
    int wallFromBehind(int edge) const;
    /// The wall on the edge, from whichever side it is solid; −1 for none.
    int wallOn(int edge) const;
    bool isClosure(int edge) const { return isClosureLabel(m_net.labelOf(edge)); }

    /// One-way walls stop the ship from behind as well.
    void shut(int wall, bool isShut) { m_shut[static_cast<std::size_t>(wall)] = isShut; }
    void shutAll(bool areShut) { m_shut.assign(m_shut.size(), areShut); }
    /// Adds a wall between two vertices, for a trial; the number to open it with. −1 where that is impossible.
    int close(int a, int b);
    /// Gives the walls seen from a vertex a vertex where they are nearest to it, at most so many metres away: those of
    /// the nearest few.
    std::vector<int> addNearestTo(int vertex, double metres);
    void open(int closure) { m_open[static_cast<std::size_t>(closure)] = true; }
    void closeAgain(int closure) { m_open[static_cast<std::size_t>(closure)] = false; }

  private:
    struct Bend {
        int u, w; // the wall, by its vertices
        GridPoint at;
        double along; // grid, from u
    };
    struct Cone { // of what is seen from a vertex
        int edge;
        int right, left;
    };

    GridPoint grid(const Vec2& place) const;
    int wallCount() const { return static_cast<int>(m_shut.size()); }
    int gapLabel() const { return wallCount(); }
    bool isClosureLabel(int label) const { return label > gapLabel(); }
    bool isWall(int label) const { return label >= 0 && label < gapLabel(); }
    void addWalls(const std::vector<LeakWall>& walls, const std::stop_token& stop);
    void addNearestPoints(const std::stop_token& stop);
    void lookAround(int vertex, double reach, std::vector<Bend>& bends) const;
    bool isNearest(int vertex, int edge, Bend& bend) const;
    void closeGaps();
    void closeShortRuns();
    bool stops(int vertex, const Vec2& direction) const;
    bool isHard(int vertex) const;
    void findStart(const Vec2& ship);

    ConstrainedTriangulation m_net;
    Vec2 m_low{0, 0};
    double m_unit = 1;  // m, of the grid
    double m_width = 0; // of the ship, in the units of the grid
    int m_start = 0;
    GridPoint m_startAt;
    bool m_isSound = true;
    std::vector<char> m_shut; // by wall
    std::vector<char> m_open; // by closure
};

} // namespace spacetow
