#include "core/math/transform.h"

#include "core/base/random.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;

namespace {

Vec2 randomPoint(Random& random, double reach) {
    const double x = random.uniform(-reach, reach);
    return {x, random.uniform(-reach, reach)};
}

bool isNear(const Vec2& a, const Vec2& b, double tolerance = 1e-12) {
    return (a - b).norm() <= tolerance;
}

} // namespace

class TransformTest : public QObject {
    Q_OBJECT

  private slots:
    void distancesCountBothAxes();
    void crossProductsTurnAnticlockwise();
    void anglesAddWhenRotationsMultiply();
    void anglesStayInOneTurn();
    void aRotationTurnsItsAxes();
    void aRotationDoesNotGrow();
    void localAndWorldAreInverse();
    void aBodyAtAnAnglePlacesItsPoints();
};

void TransformTest::distancesCountBothAxes() {
    QCOMPARE((Vec2(3, 4) - Vec2(0, 0)).squaredNorm(), 25.0);
}

void TransformTest::crossProductsTurnAnticlockwise() {
    QCOMPARE(cross(Vec2(1, 0), Vec2(0, 1)), 1.0);
    QCOMPARE(cross(Vec2(0, 1), Vec2(1, 0)), -1.0);
    QCOMPARE(cross(1.0, Vec2(1, 0)), Vec2(0, 1)); // the velocity of (1, 0) at 1 rad/s
    QCOMPARE(leftOf(Vec2(1, 0)), Vec2(0, 1));
    QVERIFY(isFinite(Vec2(1, 2)));
    QVERIFY(!isFinite(Vec2(1, std::nan(""))));
    QVERIFY(!isFinite(Vec2(INFINITY, 0)));
}

void TransformTest::anglesAddWhenRotationsMultiply() {
    QVERIFY(std::fabs((Rot::fromAngle(1.0) * Rot::fromAngle(0.5)).angle() - 1.5) < 1e-15);
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double a = random.uniform(-1.5, 1.5);
        const double b = random.uniform(-1.5, 1.5);
        QVERIFY(std::fabs((Rot::fromAngle(a) * Rot::fromAngle(b)).angle() - (a + b)) < 1e-14);
        QVERIFY(std::fabs((Rot::fromAngle(a).inverse() * Rot::fromAngle(b)).angle() - (b - a)) < 1e-14);
    }
}

void TransformTest::anglesStayInOneTurn() {
    for (int i = -50; i <= 50; ++i) {
        const double angle = Rot::fromAngle(i).angle();
        QVERIFY(angle > -std::numbers::pi - 1e-15 && angle <= std::numbers::pi);
        const double turns = (i - angle) / (2 * std::numbers::pi);
        QVERIFY(std::fabs(turns - std::round(turns)) < 1e-13);
    }
}

void TransformTest::aRotationTurnsItsAxes() {
    const Rot quarter = Rot::fromAngle(std::numbers::pi / 2);
    QVERIFY(isNear(quarter * Vec2(1, 0), Vec2(0, 1)));
    QVERIFY(isNear(quarter * Vec2(0, 1), Vec2(-1, 0)));
    const Rot any = Rot::fromAngle(0.7);
    QVERIFY(isNear(any.right(), any * Vec2(1, 0)));
    QVERIFY(isNear(any.up(), any * Vec2(0, 1)));
    QVERIFY(Rot{} == Rot::fromAngle(0));
}

void TransformTest::aRotationDoesNotGrow() {
    Rot rotation;
    const Rot step = Rot::fromAngle(0.01);
    for (int i = 0; i < 100000; ++i) {
        rotation = step * rotation;
    }
    QVERIFY(std::fabs(std::hypot(rotation.c, rotation.s) - 1) < 1e-10);
}

void TransformTest::localAndWorldAreInverse() {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        const Vec2 position = randomPoint(random, 50);
        const Transform pose{position, Rot::fromAngle(random.uniform(-10, 10))};
        const Vec2 p = randomPoint(random, 50);
        QVERIFY2(isNear(pose.toWorld(pose.toLocal(p)), p), "seed " + QByteArray::number(seed));
        QVERIFY2(isNear(pose.toLocal(pose.toWorld(p)), p), "seed " + QByteArray::number(seed));
    }
}

void TransformTest::aBodyAtAnAnglePlacesItsPoints() {
    const Transform unturned{Vec2(3, 4), {}};
    QVERIFY(isNear(unturned.toLocal(Vec2(5, 4)), Vec2(2, 0)));
    const Transform turned{Vec2(3, 4), Rot::fromAngle(std::numbers::pi / 2)};
    QVERIFY(isNear(turned.toWorld(Vec2(1, 0)), Vec2(3, 5)));
    QVERIFY(isNear(turned.toLocal(Vec2(3, 5)), Vec2(1, 0)));
}

SPACETOW_TEST(TransformTest)
#include "transform_test.moc"
