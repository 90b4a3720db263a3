#include "editor/exchange/figure_shapes.h"

#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"
#include "core/geometry/polygon_booleans.h"
#include "core/level/fields.h"
#include "core/math/aabb.h"
#include "editor/exchange/codes.h"
#include "editor/exchange/flatten.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr double rounding = 1e-6; // m
// Beyond these it would take too long to work out what outlines fill.
constexpr std::size_t mostOutlines = 4000;    // of one figure
constexpr std::size_t mostNested = 500;       // whose boxes overlap
constexpr std::size_t mostTangled = 20'000;   // vertices of these
constexpr std::size_t mostCrossings = 20'000; // of these

struct FlatPath {
    std::vector<Vec2> points; // no two neighbours are the same
    bool closed = false;
};

Aabb boxOf(const std::vector<Vec2>& points) {
    Aabb box;
    for (const Vec2& point : points) {
        box.include(point);
    }
    return box;
}

/// Whether outlines cross so often that it would take too long to work out what they fill.
bool areTangled(const PolygonSet& outlines) {
    struct Side {
        Vec2 a, b;
        double left, right;
    };
    std::vector<Side> sides;
    for (const std::vector<Vec2>& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2& a = outline[i];
            const Vec2& b = outline[(i + 1) % outline.size()];
            sides.push_back({a, b, std::min(a.x(), b.x()), std::max(a.x(), b.x())});
        }
    }
    if (sides.size() > mostTangled || outlines.size() > mostNested) {
        return true;
    }
    std::ranges::sort(sides, {}, &Side::left);
    const std::size_t most = sides.size() + mostCrossings; // each side meets the next one
    std::size_t count = 0;
    for (std::size_t i = 0; i < sides.size() && count <= most; ++i) {
        for (std::size_t j = i + 1; j < sides.size() && sides[j].left <= sides[i].right; ++j) {
            count += segmentsMeet(sides[i].a, sides[i].b, sides[j].a, sides[j].b) ? 1 : 0;
        }
    }
    return count > most;
}

/// Outlines whose boxes overlap, directly or through others, in one set each.
std::vector<PolygonSet> overlappingSets(PolygonSet outlines) {
    struct Set {
        Aabb box;
        PolygonSet outlines;
    };
    std::vector<Set> sets;
    for (std::vector<Vec2>& outline : outlines) {
        Set one{boxOf(outline), {}};
        one.outlines.push_back(std::move(outline));
        for (std::size_t i = 0; i < sets.size();) {
            if (sets[i].box.overlaps(one.box)) {
                // What it joins may make it reach others, so it is compared with all of them again.
                one.box.include(sets[i].box);
                sets[i].outlines.insert(sets[i].outlines.end(), std::make_move_iterator(one.outlines.begin()),
                                        std::make_move_iterator(one.outlines.end()));
                one.outlines = std::move(sets[i].outlines);
                sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(i));
                i = 0;
            } else {
                ++i;
            }
        }
        sets.push_back(std::move(one));
    }
    std::vector<PolygonSet> result;
    for (Set& set : sets) {
        result.push_back(std::move(set.outlines));
    }
    return result;
}

class FigureMaker {
  public:
    FigureMaker(const DrawnItem& item, const Figure& figure, const ShapeOptions& options, Report& report)
        : m_item(item), m_figure(figure), m_options(options), m_report(report) {}

    Result<std::vector<LevelShape>> made() {
        if (m_figure.filled && !m_options.fillsAsWalls) {
            addAreas();
        } else {
            addWalls();
        }
        if (m_error) {
            return *m_error;
        }
        if (m_shapes.empty()) {
            refuse("import-flat");
        }
        return std::move(m_shapes);
    }

  private:
    void refuse(ExchangeCode code) { m_report.refuse(code, m_item.line, m_item.name); }

    FlatPath flatPath(const DrawnPath& path) {
        const double tolerance = std::max(m_options.tolerance - rounding, m_options.tolerance / 2);
        const Affine scaling{{m_options.scale, 0}, {0, m_options.scale}, {0, 0}};
        auto points = flattened(mapped(path, scaling), tolerance, limits::vertices - m_vertices);
        if (!points) {
            m_error = Error{ExchangeCode("import-too-many-vertices"), {std::to_string(limits::vertices)}};
            return {};
        }
        if (!std::ranges::all_of(*points, isWithinReach)) {
            m_error = Error{ExchangeCode("import-too-far"), {std::to_string(static_cast<int>(farthestImport))}};
            return {};
        }
        m_vertices += static_cast<int>(points->size());
        FlatPath out{std::move(*points), path.closed};
        std::ranges::transform(out.points, out.points.begin(), onMicrometres);
        out.points.erase(std::unique(out.points.begin(), out.points.end()), out.points.end());
        if (out.points.size() > 1 && out.points.front() == out.points.back()) {
            out.points.pop_back(); // so does a path that comes back without being said to be closed
            out.closed = true;
        }
        out.closed = out.closed && out.points.size() > 2;
        return out;
    }

    void addAreas() {
        for (const Circle& circle : m_figure.circles) {
            const double radius = std::max(rounding, onMicrometres({m_options.scale * circle.radius, 0}).x());
            const Vec2 center = m_options.scale * circle.center;
            if (!isWithinReach(center) || !isWithinReach({radius, radius})) {
                m_error = Error{ExchangeCode("import-too-far"), {std::to_string(static_cast<int>(farthestImport))}};
                return;
            }
            m_shapes.emplace_back(Circle{onMicrometres(center), radius});
        }
        PolygonSet outlines;
        for (const DrawnPath& path : m_figure.paths) {
            FlatPath flat = flatPath(path);
            if (flat.points.size() >= 3) {
                outlines.push_back(std::move(flat.points));
            } else if (m_figure.stroked) {
                addChain(std::move(flat));
            }
        }
        if (m_error) {
            return;
        }
        if (outlines.size() > mostOutlines) {
            addTangle(std::move(outlines));
            return;
        }
        for (PolygonSet& set : overlappingSets(std::move(outlines))) {
            addArea(std::move(set));
        }
    }

    void addTangle(PolygonSet outlines) {
        refuse("import-tangled");
        for (std::vector<Vec2>& outline : outlines) {
            addChain({std::move(outline), true});
        }
    }

    void addArea(PolygonSet outlines) {
        if (outlines.size() == 1 && (outlines.front().size() > mostTangled || isSimple(outlines.front()))) {
            addPolygon(std::move(outlines.front()));
            return;
        }
        if (areTangled(outlines)) {
            addTangle(std::move(outlines));
            return;
        }
        const bool isNested = outlines.size() > 1;
        PolygonSet areas = filledAreas(outlines, m_figure.evenOdd ? FillRule::EvenOdd : FillRule::NonZero);
        if (isNested && areas.size() > 1) {
            refuse("import-holes");
        }
        for (std::vector<Vec2>& area : areas) {
            addPolygon(std::move(area));
        }
    }

    void addPolygon(std::vector<Vec2> outline) {
        std::ranges::transform(outline, outline.begin(), onMicrometres);
        outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
        if (outline.size() > 1 && outline.front() == outline.back()) {
            outline.pop_back();
        }
        const double area = outline.size() < 3 ? 0 : signedArea(outline);
        if (!(std::abs(area) > rounding * rounding)) {
            return;
        }
        if (area < 0) {
            std::reverse(outline.begin() + 1, outline.end());
        }
        if (outline.size() > limits::polygonVertices || !isSimple(outline)) {
            refuse("import-large-polygon");
            std::reverse(outline.begin() + 1, outline.end()); // one-way walls are solid from their left
            addChain({std::move(outline), true});
        } else {
            m_shapes.emplace_back(Polygon{std::move(outline)});
        }
    }

    void addWalls() {
        for (const Circle& circle : m_figure.circles) {
            addChain(flatPath(ellipsePath(circle.center, {circle.radius, 0}, {0, circle.radius})));
        }
        for (const DrawnPath& path : m_figure.paths) {
            addChain(flatPath(path));
        }
    }

    void addChain(FlatPath path) {
        if (path.points.size() < 2) {
            return;
        }
        if (m_options.walls == ImportedWalls::TwoWay) {
            m_shapes.emplace_back(LineChain{std::move(path.points), path.closed});
            return;
        }
        if (m_figure.filled && path.closed && signedArea(path.points) > 0) {
            std::reverse(path.points.begin() + 1, path.points.end());
        }
        m_shapes.emplace_back(EdgeChain{std::move(path.points), path.closed, noBack});
    }

    const DrawnItem& m_item;
    const Figure& m_figure;
    const ShapeOptions& m_options;
    Report& m_report;
    std::vector<LevelShape> m_shapes;
    int m_vertices = 0;
    std::optional<Error> m_error;
};

} // namespace

bool isWithinReach(const Vec2& point) {
    return std::abs(point.x()) < farthestImport && std::abs(point.y()) < farthestImport;
}

Vec2 onMicrometres(const Vec2& point) {
    const auto rounded = [](double value) {
        constexpr double parts = 1 / rounding;
        return std::abs(value) < limits::coordinate ? std::round(value * parts) / parts + 0.0 : value;
    };
    return {rounded(point.x()), rounded(point.y())};
}

Result<std::vector<LevelShape>> shapesOf(const DrawnItem& item, const Figure& figure, const ShapeOptions& options,
                                         Report& report) {
    return FigureMaker(item, figure, options, report).made();
}

} // namespace spacetow
