#include "core/geometry/polygon_booleans.h"

#include "core/base/contract.h"
#include "core/geometry/polygon.h"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spacetow {

namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;
using ClipperLib::PolyNode;
using ClipperLib::PolyTree;

constexpr double unitsPerMetre = 1 << 30;
constexpr double places = 1e8;     // results are rounded to this fraction of a metre
constexpr double leastArea = 1e-8; // m²; what is less is left over from rounding
constexpr double farthest = 1e6;   // m

/// Integer coordinates, and the way back to the numbers that they came from.
class Lattice {
  public:
    IntPoint toLattice(const Vec2& point) {
        EXPECTS(std::abs(point.x()) < farthest && std::abs(point.y()) < farthest);
        const IntPoint at(std::llround(point.x() * unitsPerMetre), std::llround(point.y() * unitsPerMetre));
        m_xs.emplace(at.X, point.x());
        m_ys.emplace(at.Y, point.y());
        return at;
    }
    Vec2 toMetres(const IntPoint& point) const { return {back(m_xs, point.X), back(m_ys, point.Y)}; }
    Paths toLattice(const PolygonSet& polygons) {
        Paths paths;
        for (const std::vector<Vec2>& polygon : polygons) {
            Path path;
            for (const Vec2& point : polygon) {
                path.push_back(toLattice(point));
            }
            paths.push_back(std::move(path));
        }
        return paths;
    }
    Paths anticlockwise(const PolygonSet& polygons) {
        Paths paths = toLattice(polygons);
        for (Path& path : paths) {
            if (!ClipperLib::Orientation(path)) {
                ClipperLib::ReversePath(path);
            }
        }
        return paths;
    }

  private:
    static double back(const std::map<cInt, double>& known, cInt value) {
        const auto found = known.find(value);
        return found != known.end() ? found->second
                                    : std::round(static_cast<double>(value) / unitsPerMetre * places) / places + 0.0;
    }

    std::map<cInt, double> m_xs, m_ys;
};

ClipperLib::ClipType typeOf(PolygonBoolean how) {
    switch (how) {
    case PolygonBoolean::Union:
        return ClipperLib::ctUnion;
    case PolygonBoolean::Difference:
        return ClipperLib::ctDifference;
    case PolygonBoolean::Intersection:
        break;
    }
    return ClipperLib::ctIntersection;
}

void clip(const Paths& a, const Paths& b, ClipperLib::ClipType type, PolyTree& tree) {
    ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
    clipper.AddPaths(a, ClipperLib::ptSubject, true);
    clipper.AddPaths(b, ClipperLib::ptClip, true);
    clipper.Execute(type, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
}

/// The rectangle to the left or to the right of `x` that covers the path.
Path halfOf(const Path& path, cInt x, bool left) {
    IntPoint min = path.front();
    IntPoint max = path.front();
    for (const IntPoint& point : path) {
        min = {std::min(min.X, point.X), std::min(min.Y, point.Y)};
        max = {std::max(max.X, point.X), std::max(max.Y, point.Y)};
    }
    (left ? max : min).X = x;
    return {min, {max.X, min.Y}, max, {min.X, max.Y}};
}

/// Where an upright line goes through the middle of the hole.
cInt middleOf(const Path& hole) {
    const auto [min, max] =
        std::minmax_element(hole.begin(), hole.end(), [](const IntPoint& a, const IntPoint& b) { return a.X < b.X; });
    return min->X + (max->X - min->X) / 2;
}

Paths holesOf(const PolyNode& outer) {
    Paths holes;
    for (const PolyNode* hole : outer.Childs) {
        holes.push_back(hole->Contour);
    }
    return holes;
}

void removeSmallest(Paths& holes) {
    holes.erase(std::ranges::min_element(holes, {}, [](const Path& hole) { return std::abs(ClipperLib::Area(hole)); }));
}

constexpr int cutAttempts = 4;

/// An outline with its holes as areas without any. A line goes through the first hole, so that each part has fewer; but
/// one that is no wider than the lattice may be shut again by rounding. After some attempts the smallest hole is
/// filled.
void cutThroughHoles(const Path& outline, Paths holes, Paths& result, int attempts = cutAttempts) {
    if (attempts == 0) {
        removeSmallest(holes);
        attempts = cutAttempts;
    }
    if (holes.empty()) {
        result.push_back(outline);
        return;
    }
    Paths area = holes;
    area.push_back(outline);
    const cInt x = middleOf(holes.front());
    for (const bool left : {true, false}) {
        PolyTree half;
        clip(area, {halfOf(outline, x, left)}, ClipperLib::ctIntersection, half);
        for (const PolyNode* part : half.Childs) {
            Paths within = holesOf(*part);
            const bool hasFewer = within.size() < holes.size();
            cutThroughHoles(part->Contour, std::move(within), result, hasFewer ? attempts : attempts - 1);
        }
    }
}

/// All outlines of areas, those inside holes included.
void collect(const PolyNode& node, Paths& result) {
    for (const PolyNode* outer : node.Childs) {
        cutThroughHoles(outer->Contour, holesOf(*outer), result);
        for (const PolyNode* hole : outer->Childs) {
            collect(*hole, result);
        }
    }
}

/// The outlines of all areas in the tree, in metres.
PolygonSet areasOf(const PolyTree& tree, const Lattice& lattice) {
    Paths outlines;
    collect(tree, outlines);
    PolygonSet result;
    for (const Path& outline : outlines) {
        std::vector<Vec2> points;
        for (const IntPoint& point : outline) {
            const Vec2 at = lattice.toMetres(point);
            if (points.empty() || points.back() != at) {
                points.push_back(at);
            }
        }
        if (points.size() > 1 && points.front() == points.back()) {
            points.pop_back();
        }
        if (points.size() >= 3 && signedArea(points) > leastArea) {
            result.push_back(std::move(points));
        }
    }
    return result;
}

} // namespace

PolygonSet combined(const PolygonSet& a, const PolygonSet& b, PolygonBoolean how) {
    Lattice lattice;
    const Paths pathsA = lattice.anticlockwise(a);
    const Paths pathsB = lattice.anticlockwise(b);
    PolyTree tree;
    clip(pathsA, pathsB, typeOf(how), tree);
    return areasOf(tree, lattice);
}

PolygonSet filledAreas(const PolygonSet& outlines, FillRule rule) {
    Lattice lattice;
    const ClipperLib::PolyFillType type = rule == FillRule::EvenOdd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
    ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
    clipper.AddPaths(lattice.toLattice(outlines), ClipperLib::ptSubject, true);
    PolyTree tree;
    clipper.Execute(ClipperLib::ctUnion, tree, type, type);
    return areasOf(tree, lattice);
}

} // namespace spacetow
