#include "core/geometry/mass.h"

#include "core/geometry/polygon.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

bool isNearRelative(double a, double b) {
    return std::fabs(a - b) <= 1e-12 * std::max(1.0, std::fabs(b));
}

Polygon polygonOf(std::vector<Vec2> vertices) {
    return Polygon{std::move(vertices)};
}

} // namespace

class MassTest : public QObject {
    Q_OBJECT

  private slots:
    void massesFollowTheFormulas_data();
    void massesFollowTheFormulas();
    void regularPolygonsHaveTheirKnownInertia();
    void theOrientationOfAPolygonDoesNotMatter();
    void aPolygonCutInTwoWeighsAsMuch();
    void inertiaAgreesWithSampling();
    void aNewMassScalesTheInertia();
    void whatEnclosesNothingHasNoMass();
};

void MassTest::massesFollowTheFormulas_data() {
    QTest::addColumn<Shape>("shape");
    QTest::addColumn<double>("mass"); // at density 2
    QTest::addColumn<Vec2>("center");
    QTest::addColumn<double>("inertiaPerMass"); // about the centre
    const double pi = std::numbers::pi;
    QTest::newRow("circle") << Shape(Circle{Vec2(3, -1), 0.5}) << 2 * pi * 0.25 << Vec2(3, -1) << 0.125;
    QTest::newRow("edge") << Shape(Edge{Vec2(-1, 0), Vec2(1, 0), 5}) << 4.0 << Vec2(0, 0) << 1.0 / 3;
    QTest::newRow("line off the origin") << Shape(Line{Vec2(0, 0), Vec2(2, 0)}) << 4.0 << Vec2(1, 0) << 1.0 / 3;
    QTest::newRow("square") << Shape(polygonOf(regularPolygon(4, 1))) << 4.0 << Vec2(0, 0) << 1.0 / 3;
    QTest::newRow("unit square with a corner at the origin")
        << Shape(polygonOf({Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})) << 2.0 << Vec2(0.5, 0.5) << 1.0 / 6;
    QTest::newRow("ship") << Shape(polygonOf(
                                 {Vec2(0, 0.7 / 3), Vec2(-0.2, -0.5 / 3), Vec2(0, -0.2 / 3), Vec2(0.2, -0.5 / 3)}))
                          << 0.12 << Vec2(0, 0) << 1.0 / 72;
}

void MassTest::massesFollowTheFormulas() {
    QFETCH(Shape, shape);
    QFETCH(double, mass);
    QFETCH(Vec2, center);
    QFETCH(double, inertiaPerMass);
    const MassProperties found = massOf(shape, 2);
    QVERIFY(isNearRelative(found.mass, mass));
    const bool thin = std::holds_alternative<Edge>(shape) || std::holds_alternative<Line>(shape);
    QVERIFY(isNearRelative(found.area, thin ? 0 : mass / 2));
    QVERIFY(isNear(found.center, center, 1e-12));
    QVERIFY(isNearRelative(found.inertia, mass * inertiaPerMass));
    QVERIFY(isNearRelative(found.inertiaAboutOrigin, mass * (inertiaPerMass + center.squaredNorm())));
}

void MassTest::regularPolygonsHaveTheirKnownInertia() {
    for (int n = 3; n < 30; ++n) {
        const MassProperties found = massOf(polygonOf(regularPolygon(n, 1)), 1).withMass(1);
        const double s = std::sin(std::numbers::pi / n);
        QVERIFY(isNearRelative(found.inertia, 0.5 * (1 - 2.0 / 3 * s * s)));
    }
}

void MassTest::theOrientationOfAPolygonDoesNotMatter() {
    Polygon polygon{{Vec2(0, 0), Vec2(3, 0), Vec2(3, 1), Vec2(1, 1), Vec2(1, 3), Vec2(0, 3)}};
    const MassProperties there = massOf(polygon, 1.5);
    std::reverse(polygon.vertices.begin(), polygon.vertices.end());
    const MassProperties back = massOf(polygon, 1.5);
    QVERIFY(isNearRelative(there.mass, 7.5));
    QVERIFY(isNearRelative(there.mass, back.mass));
    QVERIFY(isNear(there.center, back.center, 1e-12));
    QVERIFY(isNearRelative(there.inertia, back.inertia));
}

void MassTest::aPolygonCutInTwoWeighsAsMuch() {
    for (unsigned seed = 0; seed < 300; ++seed) {
        Random random(seed);
        const ConvexPart part = randomConvex(random, randomPoint(random, 3));
        Polygon whole;
        for (int i = 0; i < part.count; ++i) {
            whole.vertices.push_back(part.corners[static_cast<std::size_t>(i)]);
        }
        if (part.count < 4) {
            continue;
        }
        const Polygon first{{whole.vertices.begin(), whole.vertices.begin() + 3}};
        Polygon second{{whole.vertices.begin() + 2, whole.vertices.end()}};
        second.vertices.push_back(whole.vertices[0]);
        const MassProperties expected = massOf(whole, 2);
        const MassProperties found = sum(std::array{massOf(first, 2), massOf(second, 2)});
        QVERIFY(isNearRelative(found.area, expected.area));
        QVERIFY(isNearRelative(found.mass, expected.mass));
        QVERIFY(isNear(found.center, expected.center, 1e-12));
        QVERIFY(isNearRelative(found.inertia, expected.inertia));
        QVERIFY(isNearRelative(found.inertiaAboutOrigin, expected.inertiaAboutOrigin));
    }
}

void MassTest::inertiaAgreesWithSampling() {
    const Polygon arrow{{Vec2(2, 0), Vec2(0, 1), Vec2(0.5, 0), Vec2(0, -1)}};
    const MassProperties found = massOf(arrow, 1);
    double mass = 0;
    double inertia = 0;
    const double step = 0.002;
    for (double x = step / 2; x < 2; x += step) {
        for (double y = -1 + step / 2; y < 1; y += step) {
            if (contains(arrow.vertices, Vec2(x, y))) {
                mass += step * step;
                inertia += step * step * (Vec2(x, y) - found.center).squaredNorm();
            }
        }
    }
    QVERIFY(isNear(found.mass, mass, 1e-3 * mass));
    QVERIFY(isNear(found.inertia, inertia, 1e-3 * inertia));
}

void MassTest::aNewMassScalesTheInertia() {
    const MassProperties before = massOf(Circle{Vec2(1, 0), 2}, 1);
    const MassProperties after = before.withMass(3);
    QCOMPARE(after.mass, 3.0);
    QVERIFY(isNearRelative(after.inertia, 6));
    QVERIFY(isNearRelative(after.inertiaAboutOrigin, 9));
    QCOMPARE(after.area, before.area);
}

void MassTest::whatEnclosesNothingHasNoMass() {
    QCOMPARE(massOf(Polygon{}, 1).mass, 0.0);
    QCOMPARE(massOf(Polygon{{Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)}}, 1).mass, 0.0);
    QVERIFY(isFinite(massOf(Polygon{{Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)}}, 1).center));
    QCOMPARE(sum({}).mass, 0.0);
}

SPACETOW_TEST(MassTest)
#include "mass_test.moc"
