#include "tests/support/test_main.h"

#include "core/geometry/mass.h"
#include "core/geometry/polygon.h"
#include "core/physics/world/world.h"
#include "tests/support/contact_scenes.h"

#include <array>
#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Of a body of 1 kg.
struct Formula {
    double area;
    Vec2 center;
    double inertia; // about the centre
};

bool isWithin(double found, double expected) {
    return std::abs(found - expected) <= 1e-12 * std::abs(expected);
}

std::vector<Vec2> shifted(std::vector<Vec2> outline, const Vec2& by) {
    for (Vec2& v : outline) {
        v += by;
    }
    return outline;
}

std::vector<Vec2> turned(std::vector<Vec2> outline, double angle) {
    for (Vec2& v : outline) {
        v = Vec2(std::cos(angle) * v.x() - std::sin(angle) * v.y(), std::sin(angle) * v.x() + std::cos(angle) * v.y());
    }
    return outline;
}

std::vector<Vec2> rectangle(double width, double height) {
    return {Vec2(0, 0), Vec2(width, 0), Vec2(width, height), Vec2(0, height)};
}

Formula regular(int n, double radius, const Vec2& center) {
    const double s = std::sin(pi / n);
    return {0.5 * n * radius * radius * std::sin(2 * pi / n), center, 0.5 * radius * radius * (1 - 2.0 / 3 * s * s)};
}

/// A rectangle of 3 × 1 with another of 1 × 2 on top of its left end.
const std::vector<Vec2> ell{Vec2(0, 0), Vec2(3, 0), Vec2(3, 1), Vec2(1, 1), Vec2(1, 3), Vec2(0, 3)};
const Vec2 ellCenter((3 * 1.5 + 2 * 0.5) / 5, (3 * 0.5 + 2 * 2) / 5);

double ellInertia() {
    const double lower = 3.0 / 5 * ((9.0 + 1) / 12 + (Vec2(1.5, 0.5) - ellCenter).squaredNorm());
    const double upper = 2.0 / 5 * ((1.0 + 4) / 12 + (Vec2(0.5, 2) - ellCenter).squaredNorm());
    return lower + upper;
}

void row(const char* name, const Shape& shape, const Formula& formula) {
    QTest::newRow(name) << shape << formula.area << formula.center << formula.inertia;
}

void polygonRows() {
    const std::vector<Vec2> ship{Vec2(0, 0.7 / 3), Vec2(-0.2, -0.5 / 3), Vec2(0, -0.2 / 3), Vec2(0.2, -0.5 / 3)};
    row("the ship has an area of 0.06 and an inertia of 0.0138889", Polygon{ship}, {0.06, {0, 0}, 1.0 / 72});
    row("the ship drawn beside its origin", Polygon{shifted(ship, {1, -2})}, {0.06, {1, -2}, 1.0 / 72});
    row("a right triangle", Polygon{{Vec2(0, 0), Vec2(3, 0), Vec2(0, 4)}}, {6, {1, 4.0 / 3}, 25.0 / 18});
    row("a rectangle from its corner", Polygon{rectangle(3, 0.5)}, {1.5, {1.5, 0.25}, 9.25 / 12});
    row("a rectangle at an angle", Polygon{turned(rectangle(3, 0.5), 0.7)},
        {1.5, turned({Vec2(1.5, 0.25)}, 0.7)[0], 9.25 / 12});
    row("a sliver", Polygon{rectangle(1, 1e-6)}, {1e-6, {0.5, 5e-7}, (1 + 1e-12) / 12});
    row("an L", Polygon{ell}, {5, ellCenter, ellInertia()});
    row("an L at an angle", Polygon{turned(ell, -2)}, {5, turned({ellCenter}, -2)[0], ellInertia()});
    row("a square a kilometre from its origin", Polygon{shifted(rectangle(1, 1), {1024, -512})},
        {1, {1024.5, -511.5}, 1.0 / 6});
    for (int n = 3; n <= 24; ++n) {
        for (const Vec2& center : {Vec2(0, 0), Vec2(3, -1)}) {
            row(qPrintable(QString("a regular %1-gon about (%2, %3)").arg(n).arg(center.x()).arg(center.y())),
                Polygon{shifted(regularPolygon(n, 0.7), center)}, regular(n, 0.7, center));
        }
    }
}

void otherRows() {
    row("a circle", Circle{{0, 0}, 0.3}, {0.09 * pi, {0, 0}, 0.045});
    row("a circle beside the origin", Circle{{3, -1}, 0.5}, {0.25 * pi, {3, -1}, 0.125});
    row("a small circle far from the origin", Circle{{1000, 1}, 0.01}, {1e-4 * pi, {1000, 1}, 5e-5});
    row("an edge about its middle", Edge{{-1, 0}, {1, 0}, 5}, {0, {0, 0}, 1.0 / 3});
    row("an edge from its end", Edge{{0, 0}, {0, 2}, 0}, {0, {0, 1}, 1.0 / 3});
    row("a slanted edge", Edge{{1, 1}, {4, 5}, 0.1}, {0, {2.5, 3}, 25.0 / 12});
    row("a line from its end", Line{{0, 0}, {2, 0}}, {0, {1, 0}, 1.0 / 3});
    row("a slanted line", Line{{1, 1}, {-4, 13}}, {0, {-1.5, 7}, 169.0 / 12});
}

} // namespace

class MassFormulasTest : public QObject {
    Q_OBJECT

  private slots:
    void everyShapeHasTheInertiaOfItsFormula_data() {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<double>("area");
        QTest::addColumn<Vec2>("center");
        QTest::addColumn<double>("inertia");
        polygonRows();
        otherRows();
    }
    void everyShapeHasTheInertiaOfItsFormula() {
        QFETCH(Shape, shape);
        QFETCH(double, area);
        QFETCH(Vec2, center);
        QFETCH(double, inertia);
        const MassProperties found = massOf(shape, 3);
        const double size = std::max(center.norm(), 1.0);
        QVERIFY(isWithin(found.area, area));
        QVERIFY(area == 0 || isWithin(found.mass, 3 * area));
        QVERIFY((found.center - center).norm() <= 1e-12 * size);
        QVERIFY2(isWithin(found.inertia, found.mass * inertia),
                 qPrintable(QString::number(found.inertia / found.mass / inertia - 1)));
        QVERIFY(isWithin(found.inertiaAboutOrigin, found.mass * (inertia + center.squaredNorm())));
        const MassProperties heavy = found.withMass(7);
        QCOMPARE(heavy.mass, 7.0);
        QVERIFY(isWithin(heavy.inertia, 7 * inertia));
        QVERIFY(isWithin(heavy.inertiaAboutOrigin, 7 * (inertia + center.squaredNorm())));
    }

    void aBodyHasTheInertiaOfItsShape_data() { everyShapeHasTheInertiaOfItsFormula_data(); }
    void aBodyHasTheInertiaOfItsShape() {
        QFETCH(Shape, shape);
        QFETCH(Vec2, center);
        QFETCH(double, inertia);
        World world;
        const BodyState state = world.body(add(world, {.shapes = {shape}, .position = {2, 1}, .mass = 7}));
        QCOMPARE(state.mass, 7.0);
        QVERIFY(isWithin(state.inertia, 7 * inertia));
        QVERIFY((state.massCenter - center - Vec2(2, 1)).norm() <= 1e-12 * std::max(center.norm(), 1.0));
    }

    void aBodyOfSeveralShapesIsTheirSum() {
        // An L put together from two rectangles weighs and turns as the L in one piece.
        const Polygon lower{rectangle(3, 1)};
        const Polygon upper{shifted(rectangle(1, 2), {0, 1})};
        const MassProperties whole = massOf(Polygon{ell}, 2);
        const MassProperties both = sum(std::array{massOf(lower, 2), massOf(upper, 2)});
        QVERIFY(isWithin(both.mass, whole.mass) && isWithin(both.area, whole.area));
        QVERIFY((both.center - ellCenter).norm() <= 1e-12);
        QVERIFY(isWithin(both.inertia, 10 * ellInertia()));
        QVERIFY(isWithin(both.inertiaAboutOrigin, 10 * (ellInertia() + ellCenter.squaredNorm())));
        World world;
        const BodyState state = world.body(add(world, {.shapes = {lower, upper}, .density = 2}));
        QVERIFY(isWithin(state.mass, 10) && isWithin(state.inertia, 10 * ellInertia()));
        const BodyId mixed = add(world, {.shapes = {Circle{{1, 0}, 1}, Line{{-3, 0}, {-1, 0}}}});
        const double mass = pi + 2;
        const double x = (pi - 4) / mass;
        QVERIFY(isWithin(world.body(mixed).mass, mass));
        QVERIFY(isWithin(world.body(mixed).massCenter.x(), x));
        QVERIFY(
            isWithin(world.body(mixed).inertia, pi * (0.5 + (1 - x) * (1 - x)) + 2 * (1.0 / 3 + (2 + x) * (2 + x))));
    }

    void whatCannotBeMovedIsInfinitelyHeavy() {
        World world;
        for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic}) {
            BodyDef def = ball({0, 0}, 0.5);
            def.kind = kind;
            def.mass = 2;
            const BodyState state = world.body(add(world, def));
            QVERIFY(std::isinf(state.mass) && std::isinf(state.inertia));
        }
    }
};

SPACETOW_TEST(MassFormulasTest)
#include "mass_formulas_test.moc"
