#include "tests/support/contact_scenes.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double gravity = 9.81;

/// A static floor through the origin that falls to the right, 100 m of it.
BodyDef slopeOf(const QString& shape, double angle, double friction) {
    const Rot turn = Rot::fromAngle(-angle);
    const Vec2 a = turn * Vec2(-5, 0);
    const Vec2 b = turn * Vec2(100, 0);
    BodyDef ground = shape == "line" ? lineBody(a, b) : edgeBody(a, b, shape == "thin edge" ? 0 : noBack);
    if (shape == "polygon") {
        const Vec2 down = turn * Vec2(0, -1);
        ground.shapes = {Polygon{{a, a + down, b + down, b}}};
    }
    ground.friction = friction;
    return ground;
}

void slopeRows() {
    QTest::addColumn<QString>("floor");
    QTest::addColumn<int>("degrees");
    QTest::addColumn<int>("iterations");
    for (const char* floor : floors) {
        for (int degrees = 5; degrees <= 60; degrees += 5) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%s, %d°, %d iterations", floor, degrees, iterations) << floor << degrees << iterations;
            }
        }
    }
}

} // namespace

class SlopesTest : public QObject {
    Q_OBJECT

  private slots:
    void aBoxOnASlopeHoldsOrSlidesAsFrictionSays_data() { slopeRows(); }
    void aBoxOnASlopeHoldsOrSlidesAsFrictionSays() {
        QFETCH(QString, floor);
        QFETCH(int, degrees);
        QFETCH(int, iterations);
        const double slope = degrees * pi / 180;
        const Rot turn = Rot::fromAngle(-slope);
        const double along = gravity * std::sin(slope);
        const double across = gravity * std::cos(slope);
        for (const double share : {0.0, 0.25, 0.5, 0.75, 0.9, 1.05, 1.5}) {
            const double friction = share * std::tan(slope);
            World world(withIterations(iterations));
            add(world, slopeOf(floor, slope, friction));
            BodyDef def = box(turn * Vec2(0, 0.1), 0.4, 0.1);
            def.angle = -slope;
            def.friction = friction;
            const BodyId id = add(world, def);
            run(world, 2);
            const BodyState state = world.body(id);
            const double expected = 2 * std::max(along - friction * across, 0.0);
            const double way = (state.massCenter - def.position).norm();
            const QString figures = QString("friction %1 tan: speed %2, expected %3, way %4")
                                        .arg(share)
                                        .arg(state.velocity.norm())
                                        .arg(expected)
                                        .arg(way);
            if (share > 1) {
                QVERIFY2(state.velocity.norm() < 1e-3 && way < 0.005, qPrintable(figures));
            } else {
                QVERIFY2(std::abs(state.velocity.norm() / expected - 1) < 0.02, qPrintable(figures));
                QVERIFY2(std::abs(way / expected - 1) < 0.02, qPrintable(figures)); // 2 s · v / 2
            }
        }
    }

    void aBallOnASlopeRolls_data() { slopeRows(); }
    void aBallOnASlopeRolls() {
        QFETCH(QString, floor);
        QFETCH(int, degrees);
        QFETCH(int, iterations);
        const double slope = degrees * pi / 180;
        const Rot turn = Rot::fromAngle(-slope);
        World world(withIterations(iterations));
        add(world, slopeOf(floor, slope, 1));
        BodyDef def = ball(turn * Vec2(0, 0.2), 0.2);
        def.friction = 1;
        const BodyId id = add(world, def);
        for (int i = 0; i < 100; ++i) {
            world.update();
            if (i % 10 != 9) {
                continue;
            }
            const BodyState state = world.body(id);
            const double speed = state.velocity.norm();
            const double expected = 0.02 * (i + 1) * gravity * std::sin(slope) / 1.5;
            QVERIFY2(std::abs(speed / expected - 1) < 0.01,
                     qPrintable(QString("update %1: speed %2, expected %3").arg(i).arg(speed).arg(expected)));
            QVERIFY2(std::abs(-state.angularVelocity * 0.2 / speed - 1) < 0.01,
                     qPrintable(QString("update %1: speed %2, spin %3").arg(i).arg(speed).arg(state.angularVelocity)));
        }
    }

    void aBallSlipsWhereFrictionIsTooSmallToRoll_data() { slopeRows(); }
    void aBallSlipsWhereFrictionIsTooSmallToRoll() {
        QFETCH(QString, floor);
        QFETCH(int, degrees);
        QFETCH(int, iterations);
        const double slope = degrees * pi / 180;
        const Rot turn = Rot::fromAngle(-slope);
        const double friction = 0.5 * std::tan(slope) / 3; // half of what it takes
        World world(withIterations(iterations));
        add(world, slopeOf(floor, slope, friction));
        BodyDef def = ball(turn * Vec2(0, 0.2), 0.2);
        def.friction = friction;
        const BodyId id = add(world, def);
        run(world, 2);
        const BodyState state = world.body(id);
        const double grip = friction * gravity * std::cos(slope);
        QVERIFY2(std::abs(state.velocity.norm() / (2 * (gravity * std::sin(slope) - grip)) - 1) < 0.01,
                 qPrintable(QString::number(state.velocity.norm())));
        QVERIFY2(std::abs(-state.angularVelocity / (2 * grip / (0.5 * 0.2)) - 1) < 0.01,
                 qPrintable(QString::number(state.angularVelocity)));
    }
};

SPACETOW_TEST(SlopesTest)
#include "slopes_test.moc"
