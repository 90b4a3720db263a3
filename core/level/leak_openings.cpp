#include "core/level/leak_openings.h"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

namespace spacetow {

namespace {

bool isLeftOf(const Vec2& a, const Vec2& b, const Vec2& p) {
    return cross(b - a, p - a) > 0;
}

/// Whether the way leads from one side of the segment to the other.
bool separates(const Vec2& a, const Vec2& b, const std::vector<Vec2>& way) {
    bool isOdd = false;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const Vec2& p = way[i];
        const Vec2& q = way[i + 1];
        const bool crosses = isLeftOf(a, b, p) != isLeftOf(a, b, q) && isLeftOf(p, q, a) != isLeftOf(p, q, b);
        isOdd = isOdd != crosses;
    }
    return isOdd;
}

/// The shape that a vertex belongs to, by its places; by itself where there is none.
using Side = std::pair<int, int>;

Side sideOf(const LeakMesh& mesh, const std::vector<LeakWall>& walls, int vertex) {
    const int wall = wallAt(mesh, vertex);
    if (wall < 0) {
        return {-2, vertex};
    }
    const LeakWall& found = walls[static_cast<std::size_t>(wall)];
    return {found.object, found.shape};
}

template <class SideAt>
std::vector<Closure> firstOfEach(std::vector<Closure> closures, SideAt sideAt) {
    constexpr std::size_t most = 200;
    std::sort(closures.begin(), closures.end(), [](const Closure& p, const Closure& q) {
        return std::tuple(p.cost, p.a, p.b) < std::tuple(q.cost, q.a, q.b);
    });
    std::vector<Closure> first;
    std::set<std::pair<Side, Side>> seen;
    for (const Closure& closure : closures) {
        std::pair<Side, Side> sides = std::minmax(sideAt(closure.a), sideAt(closure.b));
        if (sides.first == sides.second) {
            sides = {Side(-2, closure.a), Side(-2, closure.b)}; // two places of one wall
        }
        if (first.size() < most && seen.insert(sides).second) {
            first.push_back(closure);
        }
    }
    return first;
}

} // namespace

std::vector<int> looseEnds(const LeakMesh& mesh) {
    std::vector<int> ends;
    for (int vertex = ConstrainedTriangulation::corners; vertex < mesh.net().vertexCount(); ++vertex) {
        int walls = 0;
        for (const int edge : mesh.net().edgesFrom(vertex)) {
            walls += mesh.wallOn(edge) >= 0 || mesh.wallOn(mesh.net().twin(edge)) >= 0 ? 1 : 0;
        }
        if (walls == 1) {
            ends.push_back(vertex);
        }
    }
    return ends;
}

int wallAt(const LeakMesh& mesh, int vertex) {
    for (const int edge : mesh.net().edgesFrom(vertex)) {
        for (const int side : {edge, mesh.net().twin(edge)}) {
            if (mesh.wallOn(side) >= 0) {
                return mesh.wallOn(side);
            }
        }
    }
    return -1;
}

std::vector<int> endsBeside(const LeakMesh& mesh, const std::vector<int>& ends, const std::vector<Vec2>& way) {
    constexpr std::size_t most = 48;
    constexpr std::size_t samples = 200;
    const std::size_t step = way.size() / samples + 1;
    std::vector<std::pair<double, int>> sorted;
    for (const int end : ends) {
        const Vec2 at = mesh.at(end);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < way.size(); i += step) {
            const Vec2 along = way[std::min(i + step, way.size() - 1)] - way[i];
            const double t = std::clamp((at - way[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
            least = std::min(least, (way[i] + t * along - at).squaredNorm());
        }
        sorted.emplace_back(least, end);
    }
    std::ranges::sort(sorted);
    std::vector<int> result;
    for (std::size_t i = 0; i < std::min(sorted.size(), most); ++i) {
        result.push_back(sorted[i].second);
    }
    return result;
}

std::vector<Closure> likelyClosures(const LeakMesh& mesh, const std::vector<LeakWall>& walls, const OpeningSides& sides,
                                    const Escape& escape) {
    constexpr double endAndWall = 2;
    constexpr double twoWalls = 3;
    constexpr double sameWall = 8;
    std::vector<Closure> closures;
    const auto add = [&](int a, int b, double factor) {
        if (a != b && separates(mesh.at(a), mesh.at(b), escape.points)) {
            closures.push_back({factor * (mesh.at(a) - mesh.at(b)).norm(), std::min(a, b), std::max(a, b)});
        }
    };
    for (std::size_t i = 0; i < sides.ends.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            add(sides.ends[i], sides.ends[k], 1);
        }
    }
    for (const auto& [end, wall] : sides.nearestWalls) {
        add(end, wall, endAndWall);
    }
    std::set<int> beside;
    for (const int edge : escape.edges) {
        const int a = mesh.net().origin(edge);
        const int b = mesh.net().target(edge);
        if (std::min(a, b) >= ConstrainedTriangulation::corners) {
            const bool isSame = wallAt(mesh, a) >= 0 && sideOf(mesh, walls, a) == sideOf(mesh, walls, b);
            add(a, b, isSame ? sameWall : twoWalls);
            beside.insert({a, b});
        }
    }
    for (const int end : sides.ends) {
        for (const int vertex : beside) {
            add(end, vertex, endAndWall);
        }
    }
    return firstOfEach(std::move(closures), [&](int vertex) {
        const bool isEnd = std::ranges::find(sides.ends, vertex) != sides.ends.end();
        return isEnd ? Side(-1, vertex) : sideOf(mesh, walls, vertex);
    });
}

} // namespace spacetow
