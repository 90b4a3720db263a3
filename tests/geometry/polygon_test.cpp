#include "core/geometry/polygon.h"

#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<Vec2> shipOutline() {
    return {Vec2(0, 0.7 / 3), Vec2(-0.2, -0.5 / 3), Vec2(0, -0.2 / 3), Vec2(0.2, -0.5 / 3)};
}

std::vector<Vec2> squareAround(double half) {
    return {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)};
}

} // namespace

class PolygonTest : public QObject {
    Q_OBJECT

  private slots:
    void areaAndCentroidFollowTheFormulas();
    void areaAndCentroidMoveWithTheOutline();
    void anOutlineWithoutAreaHasItsMeanAsCentroid();
    void isSimpleTellsCrossingOutlines_data();
    void isSimpleTellsCrossingOutlines();
    void isSimpleAgreesWithTestingAllSides();
    void isSimpleIsFastForLargeOutlines();
    void pointsAreInsideOrOutside();
    void theIncircleOfASquareIsHalfItsSide();
    void regularPolygonsStartUpright();
    void theOutlinePointLiesAhead();
};

void PolygonTest::areaAndCentroidFollowTheFormulas() {
    QVERIFY(isNear(signedArea(shipOutline()), 0.06, 1e-15));
    QVERIFY(isNear(centroid(shipOutline()), Vec2(0, 0), 1e-15));
    QVERIFY(isNear(signedArea(squareAround(1.5)), 9, 1e-14));
    for (int n = 3; n < 20; ++n) {
        const auto outline = regularPolygon(n, 2);
        QVERIFY(isNear(signedArea(outline), 0.5 * n * 4 * std::sin(2 * std::numbers::pi / n), 1e-13));
        QVERIFY(isNear(centroid(outline), Vec2(0, 0), 1e-14));
    }
}

void PolygonTest::areaAndCentroidMoveWithTheOutline() {
    for (unsigned seed = 0; seed < 200; ++seed) {
        Random random(seed);
        const Transform by = randomPose(random, 1e4);
        std::vector<Vec2> moved;
        for (const Vec2& v : shipOutline()) {
            moved.push_back(by.toWorld(v));
        }
        QVERIFY(isNear(signedArea(moved), 0.06, 1e-11));
        QVERIFY(isNear(centroid(moved), by.position, 1e-10));
        std::reverse(moved.begin(), moved.end());
        QVERIFY(isNear(signedArea(moved), -0.06, 1e-11));
        QVERIFY(isNear(centroid(moved), by.position, 1e-10));
    }
}

void PolygonTest::anOutlineWithoutAreaHasItsMeanAsCentroid() {
    QVERIFY(isNear(centroid(std::vector{Vec2(1, 2)}), Vec2(1, 2)));
    QVERIFY(isNear(centroid(std::vector{Vec2(1, 2), Vec2(3, 2)}), Vec2(2, 2)));
    QVERIFY(isNear(centroid(std::vector{Vec2(0, 0), Vec2(1, 0), Vec2(2, 0)}), Vec2(1, 0)));
}

void PolygonTest::isSimpleTellsCrossingOutlines_data() {
    QTest::addColumn<std::vector<Vec2>>("outline");
    QTest::addColumn<bool>("simple");
    QTest::newRow("square") << squareAround(1) << true;
    QTest::newRow("ship") << shipOutline() << true;
    QTest::newRow("two points") << std::vector{Vec2(0, 0), Vec2(1, 0)} << false;
    QTest::newRow("bow tie") << std::vector{Vec2(0, 0), Vec2(1, 1), Vec2(1, 0), Vec2(0, 1)} << false;
    QTest::newRow("repeated vertex") << std::vector{Vec2(0, 0), Vec2(1, 0), Vec2(1, 0), Vec2(0, 1)} << false;
    QTest::newRow("vertex on a side") << std::vector{Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(1, 0), Vec2(0, 2)}
                                      << false;
    QTest::newRow("spike") << std::vector{Vec2(0, 0), Vec2(2, 0), Vec2(1, 0), Vec2(1, 2)} << false;
    QTest::newRow("straight corner") << std::vector{Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(1, 2)} << true;
    QTest::newRow("touching vertices") << std::vector{Vec2(0, 0), Vec2(1, 1), Vec2(2, 0),
                                                      Vec2(2, 2), Vec2(1, 1), Vec2(0, 2)}
                                       << false;
    QTest::newRow("not a number") << std::vector{Vec2(0, 0), Vec2(1, std::nan("")), Vec2(2, 0)} << false;
}

void PolygonTest::isSimpleTellsCrossingOutlines() {
    QFETCH(std::vector<Vec2>, outline);
    QFETCH(bool, simple);
    for (std::size_t shift = 0; shift < outline.size(); ++shift) {
        QCOMPARE(isSimple(outline), simple);
        std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
    std::reverse(outline.begin(), outline.end());
    QCOMPARE(isSimple(outline), simple);
}

void PolygonTest::isSimpleAgreesWithTestingAllSides() {
    int simpleOnes = 0;
    for (unsigned seed = 0; seed < 3000; ++seed) {
        Random random(seed);
        std::vector<Vec2> outline;
        const std::size_t count = 3 + random.below(5);
        for (std::size_t i = 0; i < count; ++i) {
            outline.push_back(randomPoint(random, 1));
        }
        bool expected = true; // by orientation tests alone: points in general position
        const auto side = [](const Vec2& a, const Vec2& b, const Vec2& p) { return cross(b - a, p - a) > 0; };
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = i + 2; k < count; ++k) {
                const Vec2& a = outline[i];
                const Vec2& b = outline[i + 1];
                const Vec2& c = outline[k];
                const Vec2& d = outline[(k + 1) % count];
                if ((k + 1) % count != i && side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) {
                    expected = false;
                }
            }
        }
        simpleOnes += expected ? 1 : 0;
        QVERIFY2(isSimple(outline) == expected, "seed " + QByteArray::number(seed));
    }
    QVERIFY(simpleOnes > 300);
}

void PolygonTest::isSimpleIsFastForLargeOutlines() {
    QVERIFY(isSimple(regularPolygon(100000, 50)));
}

void PolygonTest::pointsAreInsideOrOutside() {
    QVERIFY(contains(shipOutline(), Vec2(0, 0)));
    QVERIFY(!contains(shipOutline(), Vec2(0, -0.1))); // in the notch
    QVERIFY(contains(shipOutline(), Vec2(0.17, -0.14)));
    QVERIFY(!contains(std::vector<Vec2>{}, Vec2(0, 0)));
    const auto outline = regularPolygon(7, 1);
    for (unsigned seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        const Vec2 p = randomPoint(random, 1.2);
        bool inside = true;
        for (std::size_t i = 0; i < 7; ++i) {
            inside = inside && cross(outline[(i + 1) % 7] - outline[i], p - outline[i]) > 0;
        }
        QVERIFY2(contains(outline, p) == inside, "seed " + QByteArray::number(seed));
    }
}

void PolygonTest::theIncircleOfASquareIsHalfItsSide() {
    for (const double circumradius : {0.05, 0.1, 0.15}) {
        const auto outline = regularPolygon(4, circumradius);
        QVERIFY(isNear(incircleRadius(outline, Vec2(0, 0)), circumradius * std::sqrt(0.5), 1e-15));
        QVERIFY(isNear(outerRadius(outline, Vec2(0, 0)), circumradius, 1e-15));
    }
    QVERIFY(isNear(incircleRadius(shipOutline(), Vec2(0, 0)), 0.2 / 3, 1e-15)); // the notch is nearest
    QVERIFY(isNear(outerRadius(shipOutline(), Vec2(0, 0)), std::hypot(0.2, 0.5 / 3), 1e-15));
}

void PolygonTest::regularPolygonsStartUpright() {
    for (int n = 3; n < 12; ++n) {
        const auto outline = regularPolygon(n, 1.5);
        QCOMPARE(outline.size(), static_cast<std::size_t>(n));
        QVERIFY(isNear(outline[0], Vec2(0, 1.5), 1e-15));
        QVERIFY(outline[1].x() < 0); // anticlockwise
        for (int i = 0; i < n; ++i) {
            const Vec2 expected = Rot::fromAngle(2 * std::numbers::pi * i / n) * Vec2(0, 1.5);
            QVERIFY(isNear(outline[static_cast<std::size_t>(i)], expected, 1e-14));
        }
    }
}

void PolygonTest::theOutlinePointLiesAhead() {
    const auto outline = squareAround(1);
    const auto right = outlinePoint(outline, Vec2(0, 0), Vec2(1, 0));
    QVERIFY(right && isNear(*right, Vec2(1, 0)));
    const auto up = outlinePoint(outline, Vec2(0.25, 0), Vec2(0, 0.01));
    QVERIFY(up && isNear(*up, Vec2(0.25, 1)));
    const auto corner = outlinePoint(outline, Vec2(0, 0), Vec2(-1, -1));
    QVERIFY(corner && isNear(*corner, Vec2(-1, -1)));
    const auto fromOutside = outlinePoint(outline, Vec2(-5, 0.5), Vec2(1, 0));
    QVERIFY(fromOutside && isNear(*fromOutside, Vec2(-1, 0.5)));
    QVERIFY(!outlinePoint(outline, Vec2(5, 0), Vec2(1, 0)));
    QVERIFY(!outlinePoint(outline, Vec2(0, 0), Vec2(0, 0)));
}

SPACETOW_TEST(PolygonTest)
#include "polygon_test.moc"
