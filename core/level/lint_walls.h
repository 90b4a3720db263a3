#pragma once
// The walls of a level as lint looks at them: every chain in world coordinates, and what follows what. Metres.

#include "core/geometry/static_quadtree.h"
#include "core/level/lint_findings.h"

#include <vector>

namespace spacetow {

namespace lint_limits {
constexpr double together = 1e-7; // m: ends no farther apart meet
constexpr double nearly = 0.05;   // m: ends that are closer were meant to meet; neither ship nor payload fits through
} // namespace lint_limits

/// One chain of a body without errors.
struct WallChain {
    int object = 0; // place in the level
    int shape = 0;
    Key key = 0;
    const BodyObject* body = nullptr;
    bool oneWay = false;
    bool closed = false;
    double depth = 0;         // of one-way walls
    std::vector<Vec2> points; // world

    int segments() const { return static_cast<int>(points.size()) - (closed ? 0 : 1); }
    const Vec2& start(int segment) const { return points[static_cast<std::size_t>(segment)]; }
    const Vec2& end(int segment) const { return points[static_cast<std::size_t>(segment + 1) % points.size()]; }
    /// As many as the shape has; points that repeat the one before are not among `points`.
    std::size_t vertices() const;
    double length() const;
    /// Does not move, whatever happens.
    bool isStill() const;
    /// Ship and payload are stopped by it.
    bool isWall() const;
    FindingPlace place(std::vector<Vec2> marks = {}) const;
};

/// Those of a body, which is at `place` in the level.
void addWallChains(std::vector<WallChain>& chains, const Object& object, int place);
/// Those of tangible bodies, in the order of the level.
std::vector<WallChain> wallChains(const Level& level, const Findings& findings);

/// One end of a chain that is not closed.
struct WallEndPoint {
    int chain = 0;
    bool isStart = false;
    Vec2 at{0, 0};
    double beside = 0; // m, length of the wall that ends here
};

/// Which ends of open chains are in one place, or nearly so. Chains are asked about those that stand still with them.
class WallEnds {
  public:
    explicit WallEnds(const std::vector<WallChain>& chains);

    const std::vector<WallEndPoint>& ends() const { return m_ends; }
    /// The places (in `ends`) of other ends within `distance`, which is at most `nearly`.
    std::vector<int> around(int end, double distance) const;
    /// The end of another chain, or of the same, that is alone in meeting this one; −1 where there is none or several.
    int partner(int end) const { return m_partners[static_cast<std::size_t>(end)]; }
    /// The end at the other side of the same chain.
    static int opposite(int end) { return end ^ 1; }

  private:
    const std::vector<WallChain>& m_chains;
    std::vector<WallEndPoint> m_ends;
    std::vector<std::pair<std::int64_t, int>> m_cells; // sorted
    std::vector<int> m_partners;
};

/// All segments of chains that stand still, to be asked what is near.
struct WallTree {
    struct Segment {
        int chain = 0;
        int segment = 0;
    };
    explicit WallTree(const std::vector<WallChain>& chains);

    std::vector<Segment> segments; // in the order of the tree's boxes
    StaticQuadtree tree;
};

/// What the rules share, made once.
struct Walls {
    std::vector<WallChain> chains;
    WallEnds ends;
    WallTree still;

    explicit Walls(std::vector<WallChain> all) : chains(std::move(all)), ends(chains), still(chains) {}
    Walls(const Walls&) = delete;
    Walls& operator=(const Walls&) = delete;
};

// The rules.

/// Chains that are solid on the other side than those they go on from.
void checkDirections(const Level& level, const Walls& walls, Findings& findings);
/// Ends that nearly meet.
void checkGaps(const Level& level, const Walls& walls, Findings& findings);
/// Walls that lie on each other, end to end.
void checkOverlaps(const Level& level, const Walls& walls, Findings& findings);
/// What is solid behind walls reaches into where others are free, or is so thin that what is fast gets through.
void checkDepths(const Level& level, const Walls& walls, Findings& findings);
/// Ship, payload and finish in the same cave.
void checkCaves(const Level& level, const Walls& walls, Findings& findings);

} // namespace spacetow
