#include "core/geometry/wall_side.h"

#include "core/geometry/cast.h"
#include "core/geometry/collide.h"
#include "core/geometry/convex_parts.h"
#include "tests/geometry/chains.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class WallSideTest : public QObject {
    Q_OBJECT

  private slots:
    void anEdgeStopsWhatComesFromItsLeft_data();
    void anEdgeStopsWhatComesFromItsLeft();
    void aLineStopsBothSides_data();
    void aLineStopsBothSides();
    void freeEndsStopABallFromEverySide_data();
    void freeEndsStopABallFromEverySide();
    void freeEndsStopABoxFromEverySide();
    void aBoxBesideACornerIsPushedSideways();
    void aWallWithoutLengthIsAPoint();
};

void WallSideTest::anEdgeStopsWhatComesFromItsLeft_data() {
    QTest::addColumn<double>("depth");
    QTest::addColumn<double>("y"); // of the centre of a ball or box of 0.2
    QTest::addColumn<bool>("touches");
    QTest::newRow("in front, apart") << inf << 0.25 << false;
    QTest::newRow("in front, touching") << inf << 0.19 << true;
    QTest::newRow("in front of a face without depth") << 0.0 << 0.01 << true;
    QTest::newRow("centre on a face without depth") << 0.0 << 0.0 << true;
    QTest::newRow("behind a face without depth") << 0.0 << -0.01 << false;
    QTest::newRow("inside the band") << 0.15 << -0.149 << true;
    QTest::newRow("deeper than the band") << 0.15 << -0.151 << false;
    QTest::newRow("far inside a wall without back") << inf << -9.0 << true;
}

void WallSideTest::anEdgeStopsWhatComesFromItsLeft() {
    QFETCH(double, depth);
    QFETCH(double, y);
    QFETCH(bool, touches);
    for (unsigned seed = 0; seed < 50; ++seed) {
        Random random(seed);
        const Transform world = randomPose(random, 5);
        const Part wall = edge(Vec2(-1, 0), Vec2(1, 0), depth);
        const Vec2 center(random.uniform(-0.7, 0.7), y);
        for (const Part& body : {ball(0.2), box(0.2, 0.2)}) {
            const Manifold manifold = collide(wall, world, body, carried(world, {center, {}}), 0);
            QCOMPARE(manifold.count > 0, touches);
            if (touches) {
                QVERIFY(isNear(manifold.normal, world.rotation * Vec2(0, 1)));
                QVERIFY(isNear(manifold.points[0].separation, y - 0.2));
            }
        }
    }
}

void WallSideTest::aLineStopsBothSides_data() {
    QTest::addColumn<double>("y");
    QTest::newRow("well above") << 0.19;
    QTest::newRow("just above") << 0.001;
    QTest::newRow("just below") << -0.001;
    QTest::newRow("well below") << -0.19;
}

void WallSideTest::aLineStopsBothSides() {
    QFETCH(double, y);
    for (const Part& wall : {line(Vec2(-1, 0), Vec2(1, 0)), line(Vec2(1, 0), Vec2(-1, 0))}) {
        for (const Part& body : {ball(0.2), box(0.2, 0.2)}) {
            const Manifold manifold = collide(wall, {}, body, {Vec2(0.3, y), {}}, 0);
            QVERIFY(manifold.count > 0);
            QVERIFY(isNear(manifold.normal, Vec2(0, y > 0 ? 1 : -1)));
            QVERIFY(isNear(manifold.points[0].separation, std::fabs(y) - 0.2));
        }
    }
}

void WallSideTest::freeEndsStopABallFromEverySide_data() {
    QTest::addColumn<double>("end");
    QTest::addColumn<Part>("wall");
    for (const double end : {-1.0, 1.0}) {
        QTest::addRow("edge without depth, x = %g", end) << end << edge(Vec2(-1, 0), Vec2(1, 0), 0);
        QTest::addRow("line, x = %g", end) << end << line(Vec2(-1, 0), Vec2(1, 0));
    }
}

void WallSideTest::freeEndsStopABallFromEverySide() {
    QFETCH(double, end);
    QFETCH(Part, wall);
    for (int degrees = 0; degrees < 360; ++degrees) {
        const Vec2 way = Rot::fromAngle(degrees * std::numbers::pi / 180).right();
        const Vec2 center = Vec2(end, 0) + 0.15 * way;
        const Manifold manifold = collide(wall, {}, ball(0.2), {center, {}}, 0);
        QCOMPARE(manifold.count, 1);
        const bool overFace = way.x() * end < -1e-12 && (way.y() >= 0 || !std::get<WallPart>(wall).oneWay);
        if (!overFace) {
            QVERIFY2(isNear(manifold.normal, way), QByteArray::number(degrees));
            QVERIFY(isNear(manifold.points[0].separation, -0.05));
        }
        QCOMPARE(
            collide(wall, {}, ball(0.2), {Vec2(Vec2(end, 0) + 0.25 * Vec2(end, way.y()).normalized()), {}}, 0).count,
            0);
    }
}

void WallSideTest::freeEndsStopABoxFromEverySide() {
    const Part wall = edge(Vec2(-1, 0), Vec2(1, 0), 0);
    for (const double end : {-1.0, 1.0}) {
        for (int degrees = -170; degrees <= 170; degrees += 5) {
            // The middle of one side of the box a little past the end, the box outside the wall's span or behind it.
            const Rot rotation = Rot::fromAngle(degrees * std::numbers::pi / 180);
            const Vec2 way = rotation.right();
            const bool beyond = way.x() * end > 0.3;
            const bool behind = way.y() < -0.3;
            if (!beyond && !behind) {
                continue;
            }
            const Vec2 center = Vec2(end, 0) + (0.2 - 0.01) * way;
            const Manifold manifold = collide(wall, {}, box(0.2, 0.2), {center, rotation}, 0);
            QVERIFY2(manifold.count > 0, QByteArray::number(degrees));
            QVERIFY2(isNear(manifold.normal, way, 1e-6), QByteArray::number(degrees));
            QVERIFY(isNear(manifold.points[0].separation, -0.01) || isNear(manifold.points[1].separation, -0.01));
        }
    }
}

void WallSideTest::aBoxBesideACornerIsPushedSideways() {
    // A shelf that ends in a drop: what touches the drop, however low, is not lifted on to the shelf.
    const std::vector<Part> walls = chain({Vec2(-5, 0), Vec2(0, 0), Vec2(0, -5)}, true);
    for (const double y : {-2.0, -0.21, -0.19, -0.05, 0.0, 0.05, 0.15, 0.19}) {
        for (const double sunk : {0.0005, 0.003}) {
            const auto found = contacts(walls, box(0.2, 0.2), {Vec2(0.2 - sunk, y), {}}, 0);
            QVERIFY2(!found.empty(), QByteArray::number(y));
            for (const Manifold& manifold : found) {
                QVERIFY2(isNear(manifold.normal, Vec2(1, 0), 1e-9), QByteArray::number(y));
                QVERIFY(isNear(manifold.points[0].separation, -sunk));
            }
        }
    }
}

void WallSideTest::aWallWithoutLengthIsAPoint() {
    const Part wall = edge(Vec2(1, 1), Vec2(1, 1), 0);
    const Manifold manifold = collide(wall, {}, ball(0.2), {Vec2(1.1, 1), {}}, 0);
    QVERIFY(manifold.count == 0 || isFinite(manifold.normal));
    const Manifold boxed = collide(wall, {}, box(0.2, 0.2), {Vec2(1.1, 1), {}}, 0);
    QVERIFY(boxed.count == 0 || isFinite(boxed.normal));
}

SPACETOW_TEST(WallSideTest)
#include "wall_side_test.moc"
