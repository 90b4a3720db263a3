#include "tests/support/known_values.h"

#include "core/geometry/bounds.h"
#include "core/geometry/collide.h"
#include "core/geometry/intersect.h"
#include "core/geometry/mass.h"
#include "core/geometry/polygon.h"
#include "core/geometry/static_quadtree.h"
#include "tests/geometry/random_parts.h"

#include <algorithm>
#include <bit>

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<Vec2> ship() {
    return {Vec2(0, 0.7 / 3), Vec2(-0.2, -0.5 / 3), Vec2(0, -0.2 / 3), Vec2(0.2, -0.5 / 3)};
}

std::vector<Vec2> square(const Vec2& center, double half) {
    return {center + Vec2(-half, -half), center + Vec2(half, -half), center + Vec2(half, half),
            center + Vec2(-half, half)};
}

MassProperties kilogramOf(const Shape& shape) {
    return massOf(shape, 1).withMass(1);
}

int outerSides(const std::vector<Vec2>& outline) {
    int sides = 0;
    for (const Part& part : partsOf(Polygon{outline})) {
        sides += std::popcount(static_cast<unsigned>(std::get<ConvexPart>(part).outerFaces));
    }
    return sides;
}

/// The shortest outer side that ends or begins at `corner`; nothing there is infinitely long.
double sideAt(const std::vector<Vec2>& outline, const Vec2& corner) {
    double shortest = noBack;
    for (const Part& part : partsOf(Polygon{outline})) {
        const auto& convex = std::get<ConvexPart>(part);
        for (int i = 0; i < convex.count; ++i) {
            const Vec2& a = convex.corners[static_cast<std::size_t>(i)];
            const Vec2& b = convex.corners[static_cast<std::size_t>((i + 1) % convex.count)];
            if ((convex.outerFaces >> i & 1) != 0 && (a == corner || b == corner)) {
                shortest = std::min(shortest, (b - a).norm());
            }
        }
    }
    return shortest;
}

/// Where the static tree parts boxes without extent at x = 1, 2 … count.
double middleOf(int count) {
    std::vector<Aabb> boxes;
    for (int i = 1; i <= count; ++i) {
        boxes.push_back({Vec2(i, 0), Vec2(i, 0)});
    }
    double middle = count;
    for (const Aabb& cell : StaticQuadtree(boxes).cells()) {
        middle = cell.min.x() > 1 ? std::min(middle, cell.min.x()) : middle;
    }
    return middle;
}

std::vector<std::uint32_t> foundIn(const std::vector<Aabb>& boxes, const Aabb& area) {
    std::vector<std::uint32_t> found;
    StaticQuadtree(boxes).query(area, found);
    return found;
}

std::vector<Aabb> tiles() {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 400; ++i) {
        const Vec2 corner(i % 20, i / 20);
        boxes.push_back({corner, corner + Vec2(1, 1)});
    }
    return boxes;
}

double leftmostCell(const std::vector<Aabb>& boxes) {
    double left = noBack;
    for (const Aabb& cell : StaticQuadtree(boxes).cells()) {
        left = std::min(left, cell.min.x());
    }
    return left;
}

/// How far a ball of radius 0.2 at the origin is from a square of side 2 whose local centre is at (3, 0).
double gapBeside(const Transform& pose) {
    const Part part = partsOf(Polygon{square(Vec2(3, 0), 1)}).at(0);
    return collide(part, pose, Circle{Vec2(0, 0), 0.2}, {}, 5).points[0].separation;
}

double movedBoxGrowth() {
    const Shape wall = Edge{Vec2(-1, 0), Vec2(1, 0), 0.3};
    const Vec2 size = boundsOf(wall, {}).size();
    double growth = 0;
    for (int i = 0; i < 1000; ++i) {
        growth = std::max(growth, (boundsOf(wall, {Vec2(0.1 * i, -0.05 * i), {}}).size() - size).norm());
    }
    return growth;
}

void intersectionRows() {
    const auto slanted = segmentIntersection(Vec2(0, 0), Vec2(2, 1), Vec2(1, -1), Vec2(1, 3));
    known("the segment from the origin to (2, 1) meets the upright one over x = 1 at x = 1", slanted->x(), 1);
    known("the segment from the origin to (2, 1) meets the upright one over x = 1 at y = 0.5, not 0.375", slanted->y(),
          0.5);
    known("perpendicular segments apart do not meet, though the line of one parts the ends of the other",
          segmentsMeet(Vec2(-1, 0), Vec2(1, 0), Vec2(0, 1), Vec2(0, 2)) ||
              segmentsMeet(Vec2(0, 1), Vec2(0, 2), Vec2(-1, 0), Vec2(1, 0)),
          0, 0);
    known("a segment that crosses the line of another beside it does not meet it",
          segmentsMeet(Vec2(-1, 0), Vec2(1, 0), Vec2(2, -1), Vec2(2, 1)), 0, 0);
    const std::vector<Vec2> outline = square(Vec2(0, 0), 1);
    known("seen from the middle of a square to the right, its outline is at x = 1 and not behind",
          outlinePoint(outline, Vec2(0, 0), Vec2(1, 0))->x(), 1);
    known("seen from the middle of a square to the right, its outline is at y = 0 and not at a corner",
          outlinePoint(outline, Vec2(0, 0), Vec2(1, 0))->y(), 0);
}

void radiusRows() {
    const Vec2 origin(0, 0);
    known("the circle in a square of circumradius 0.05 has radius 0.0354, not 0.0025",
          incircleRadius(regularPolygon(4, 0.05), origin), 0.05 * std::sqrt(0.5));
    known("the circle in a square of circumradius 0.1 has radius 0.0707, not 0.01",
          incircleRadius(regularPolygon(4, 0.1), origin), 0.1 * std::sqrt(0.5));
    known("the circle in a square of circumradius 2 has radius 1.4142", incircleRadius(regularPolygon(4, 2), origin),
          std::sqrt(2.0));
    known("the circle in the ship has radius 0.0667, not 0.0544", incircleRadius(ship(), origin), 0.2 / 3);
}

void inertiaRows() {
    known("a triangle of circumradius 1 and 1 kg has an inertia of 0.25",
          kilogramOf(Polygon{regularPolygon(3, 1)}).inertia, 0.25);
    known("a square of circumradius 1 and 1 kg has an inertia of 1/3, not 0.2222",
          kilogramOf(Polygon{regularPolygon(4, 1)}).inertia, 1.0 / 3);
    known("a hexagon of circumradius 1 and 1 kg has an inertia of 5/12",
          kilogramOf(Polygon{regularPolygon(6, 1)}).inertia, 5.0 / 12);
    known("the ship of 1 kg has an inertia of 1/72, not 0.00889", kilogramOf(Polygon{ship()}).inertia, 1.0 / 72, 1e-15);
    known("a unit square of 1 kg has an inertia of 2/3 about its corner, not 0.6111",
          kilogramOf(Polygon{square(Vec2(0.5, 0.5), 0.5)}).inertiaAboutOrigin, 2.0 / 3);
    known("a rod of 2 m and 1 kg has an inertia of 1/3 about its middle, not 1",
          kilogramOf(Line{Vec2(-1, 0), Vec2(1, 0)}).inertiaAboutOrigin, 1.0 / 3);
    known("a rod of 2 m and 1 kg has an inertia of 4/3 about its end, not 2",
          kilogramOf(Edge{Vec2(0, 0), Vec2(2, 0), 0.1}).inertiaAboutOrigin, 4.0 / 3);
}

void outlineRows() {
    known("the ship has four sides", outerSides(ship()), 4, 0);
    known("the sides at the ship's nose are as long as from there to the tail", sideAt(ship(), ship().front()),
          (ship()[0] - ship()[1]).norm());
    known("the last side of a triangle leads back to its first corner",
          sideAt({Vec2(0, 0), Vec2(3, 0), Vec2(0, 4)}, Vec2(0, 0)), 3);
    known("a square drawn beside its body's origin is met where it is drawn", gapBeside({Vec2(0, 0), {}}), 1.8);
    known("a square drawn beside its body's origin turns about that origin",
          gapBeside({Vec2(0, 1), Rot::fromAngle(std::numbers::pi / 2)}), 2.8);
    const Aabb line = boundsOf(Shape(Line{Vec2(2, 1), Vec2(4, 1)}), {});
    known("a line from (2, 1) to (4, 1) starts at x = 2, not 4", line.min.x(), 2, 0);
    known("a line from (2, 1) to (4, 1) ends at x = 4", line.max.x(), 4, 0);
    known("a line from (2, 1) to (4, 1) lies at y = 1", 0.5 * (line.min.y() + line.max.y()), 1, 0);
}

void treeRows() {
    known("the static tree parts 17 boxes at the middle one", middleOf(17), 9, 0);
    known("the static tree parts 18 boxes half way between the middle two", middleOf(18), 9.5, 0);
    known("a point where four boxes of the static tree meet finds all four",
          static_cast<double>(foundIn(tiles(), {Vec2(10, 10), Vec2(10, 10)}).size()), 4, 0);
    known("a tree made of the same boxes tells them in the same order",
          foundIn(tiles(), {Vec2(3, 3), Vec2(17, 9)}) == foundIn(tiles(), {Vec2(3, 3), Vec2(17, 9)}), 1, 0);
    known("the static tree of a level far from the origin does not reach to the origin",
          leftmostCell({{Vec2(1000, 1000), Vec2(1001, 1001)}, {Vec2(1004, 1002), Vec2(1005, 1003)}}), 1000, 0);
    known("the box of an edge keeps its size wherever the edge goes", movedBoxGrowth(), 0, 1e-12);
}

} // namespace

class KnownShapesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyNumberIsWhatItsSentenceSays_data() {
        knownValueColumns();
        intersectionRows();
        radiusRows();
        inertiaRows();
        outlineRows();
        treeRows();
    }
    void everyNumberIsWhatItsSentenceSays() { checkKnownValue(); }
};

SPACETOW_TEST(KnownShapesTest)
#include "known_shapes_test.moc"
