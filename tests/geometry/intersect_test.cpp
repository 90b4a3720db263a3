#include "core/geometry/intersect.h"

#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class IntersectTest : public QObject {
    Q_OBJECT

  private slots:
    void segmentsMeetWhereTheyShould_data();
    void segmentsMeetWhereTheyShould();
    void theMeetingPointLiesOnBoth();
    void theClosestPointIsClosest();
};

void IntersectTest::segmentsMeetWhereTheyShould_data() {
    QTest::addColumn<Vec2>("a");
    QTest::addColumn<Vec2>("b");
    QTest::addColumn<Vec2>("c");
    QTest::addColumn<Vec2>("d");
    QTest::addColumn<bool>("meet");
    QTest::addColumn<Vec2>("at");
    QTest::newRow("a slanted pair") << Vec2(0, 0) << Vec2(2, 1) << Vec2(1, -1) << Vec2(1, 3) << true << Vec2(1, 0.5);
    QTest::newRow("a cross") << Vec2(-1, 0) << Vec2(1, 0) << Vec2(0, -1) << Vec2(0, 1) << true << Vec2(0, 0);
    QTest::newRow("perpendicular and apart")
        << Vec2(-1, 0) << Vec2(1, 0) << Vec2(0, 1) << Vec2(0, 2) << false << Vec2(0, 0);
    QTest::newRow("one ends short of the other's line")
        << Vec2(-1, 0) << Vec2(1, 0) << Vec2(2, -1) << Vec2(2, 1) << false << Vec2(0, 0);
    QTest::newRow("a T") << Vec2(-1, 0) << Vec2(1, 0) << Vec2(0.5, 0) << Vec2(0.5, 1) << true << Vec2(0.5, 0);
    QTest::newRow("end to end") << Vec2(0, 0) << Vec2(1, 0) << Vec2(1, 0) << Vec2(2, 3) << true << Vec2(1, 0);
    QTest::newRow("parallel") << Vec2(0, 0) << Vec2(1, 0) << Vec2(0, 1) << Vec2(1, 1) << false << Vec2(0, 0);
    QTest::newRow("one line, apart") << Vec2(0, 0) << Vec2(1, 1) << Vec2(2, 2) << Vec2(3, 3) << false << Vec2(0, 0);
    QTest::newRow("overlapping") << Vec2(0, 0) << Vec2(2, 0) << Vec2(3, 0) << Vec2(1, 0) << true << Vec2(1, 0);
    QTest::newRow("a point on a segment") << Vec2(0, 0) << Vec2(2, 0) << Vec2(1, 0) << Vec2(1, 0) << true << Vec2(1, 0);
    QTest::newRow("a point beside it") << Vec2(0, 0) << Vec2(2, 0) << Vec2(1, 1) << Vec2(1, 1) << false << Vec2(0, 0);
    QTest::newRow("a point beyond it") << Vec2(0, 0) << Vec2(2, 0) << Vec2(3, 0) << Vec2(3, 0) << false << Vec2(0, 0);
    QTest::newRow("two equal points") << Vec2(1, 1) << Vec2(1, 1) << Vec2(1, 1) << Vec2(1, 1) << true << Vec2(1, 1);
    QTest::newRow("two points") << Vec2(1, 1) << Vec2(1, 1) << Vec2(1, 2) << Vec2(1, 2) << false << Vec2(0, 0);
}

void IntersectTest::segmentsMeetWhereTheyShould() {
    QFETCH(Vec2, a);
    QFETCH(Vec2, b);
    QFETCH(Vec2, c);
    QFETCH(Vec2, d);
    QFETCH(bool, meet);
    QFETCH(Vec2, at);
    QCOMPARE(segmentsMeet(a, b, c, d), meet);
    QCOMPARE(segmentsMeet(c, d, a, b), meet);
    QCOMPARE(segmentsMeet(b, a, c, d), meet);
    QCOMPARE(segmentsMeet(a, b, d, c), meet);
    const auto point = segmentIntersection(a, b, c, d);
    QCOMPARE(point.has_value(), meet);
    QVERIFY(!point || isNear(*point, at));
}

void IntersectTest::theMeetingPointLiesOnBoth() {
    int found = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        Random random(seed);
        const Vec2 a = randomPoint(random, 1);
        const Vec2 b = randomPoint(random, 1);
        const Vec2 c = randomPoint(random, 1);
        const Vec2 d = randomPoint(random, 1);
        if (const auto p = segmentIntersection(a, b, c, d)) {
            ++found;
            QVERIFY(isNear(closestOnSegment(a, b, *p), *p, 1e-12));
            QVERIFY(isNear(closestOnSegment(c, d, *p), *p, 1e-9));
        } else {
            const Vec2 on = a + cross(c - a, d - c) / cross(b - a, d - c) * (b - a); // of the two whole lines
            const bool onBoth =
                isNear(closestOnSegment(a, b, on), on, 1e-12) && isNear(closestOnSegment(c, d, on), on, 1e-12);
            QVERIFY2(!onBoth, "seed " + QByteArray::number(seed));
        }
    }
    QVERIFY(found > 200);
}

void IntersectTest::theClosestPointIsClosest() {
    for (unsigned seed = 0; seed < 500; ++seed) {
        Random random(seed);
        const Vec2 a = randomPoint(random, 1);
        const Vec2 b = randomPoint(random, 1);
        const Vec2 p = randomPoint(random, 2);
        const double distance = (closestOnSegment(a, b, p) - p).norm();
        for (int i = 0; i <= 100; ++i) {
            QVERIFY(distance <= (a + i / 100.0 * (b - a) - p).norm() + 1e-12);
        }
    }
    QCOMPARE(closestOnSegment(Vec2(1, 2), Vec2(1, 2), Vec2(5, 5)), Vec2(1, 2));
    QCOMPARE(closestOnSegment(Vec2(0, 0), Vec2(1, 0), Vec2(5, 5)), Vec2(1, 0));
}

SPACETOW_TEST(IntersectTest)
#include "intersect_test.moc"
