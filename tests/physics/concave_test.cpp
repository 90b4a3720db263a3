#include "tests/support/contact_scenes.h"
#include "tests/support/gaps.h"

#include <algorithm>
#include <array>
#include <vector>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int teeth = 4;
constexpr double pitch = 0.6; // m, from tooth to tooth; a tooth is 0.2 wide and a gap 0.4

/// A back 0.3 m high with teeth 0.8 m long on top of it; the origin is the middle of the back's upper side.
Polygon comb() {
    const double half = 0.5 * (teeth * pitch - 0.4);
    Polygon polygon{{Vec2(-half, -0.3), Vec2(half, -0.3)}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double left = -half + i * pitch;
        const double right = left + 0.2;
        if (i < teeth - 1) {
            polygon.vertices.emplace_back(right, 0);
        }
        polygon.vertices.emplace_back(right, 0.8);
        polygon.vertices.emplace_back(left, 0.8);
        if (i > 0) {
            polygon.vertices.emplace_back(left, 0);
        }
    }
    return polygon;
}

struct Combs {
    World world;
    std::array<BodyId, 2> ids;
    int touches = 0;
    double deepest = 0;

    explicit Combs(const UpdateParameters& parameters) : world(parameters) {}

    /// How deep the outlines have ever been in each other is in `deepest`.
    void run(double seconds) {
        const Shape shape = comb();
        for (int i = 0; i < std::lround(seconds / world.parameters().seconds); ++i) {
            world.update();
            for (const TouchEvent& event : world.events().began) {
                touches += event.a == ids[0] && event.b == ids[1] ? 1 : 0;
            }
            deepest =
                std::max(deepest, overlapDepth(shape, world.body(ids[0]).pose, shape, world.body(ids[1]).pose, 0.05));
        }
    }
};

void combRows(const std::vector<double>& shifts) {
    QTest::addColumn<double>("shift");
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("iterations");
    for (const double shift : shifts) {
        for (const double speed : {0.0, 2.0, 10.0, 50.0}) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("shifted by %g, %g m/s, %d iterations", shift, speed, iterations)
                    << shift << speed << iterations;
            }
        }
    }
}

} // namespace

class ConcaveTest : public QObject {
    Q_OBJECT

  private slots:
    void aBallReachesTheShipsNotch_data() {
        QTest::addColumn<double>("radius");
        QTest::addColumn<int>("iterations");
        for (const double radius : {0.005, 0.02, 0.05}) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("radius %g, %d iterations", radius, iterations) << radius << iterations;
            }
        }
    }
    void aBallReachesTheShipsNotch() {
        QFETCH(double, radius);
        QFETCH(int, iterations);
        for (const double aside : {0.0, 0.03, -0.03}) {
            for (const double speed : {0.0, 5.0, 50.0}) {
                World world(withIterations(iterations));
                BodyDef ship = shipBody({0, 0}, pi); // upside down, so that the notch opens upwards
                ship.kind = BodyKind::Static;
                ship.filter = {};
                ship.restitution = 0;
                add(world, ship);
                BodyDef def = ball({aside, 0.5}, radius);
                def.velocity = {0, -speed};
                const BodyId id = add(world, def);
                for (int i = 0; i < 200; ++i) {
                    world.update();
                    QVERIFY2(distanceTo(shipHull(), {{0, 0}, Rot::fromAngle(pi)}, world.body(id).massCenter) > 0,
                             qPrintable(QString("from %1, %2 m/s, update %3: inside").arg(aside).arg(speed).arg(i)));
                }
                const double notch = -shipNotch().y();
                const double expected = notch + radius / std::sin(std::atan2(0.2, 0.1)); // resting on both flanks
                const Vec2 at = world.body(id).massCenter;
                if (speed > 10 || (speed > 0 && aside != 0)) {
                    // Thrown out over a tip; without the hull it would have fallen by 78 m and more.
                    QVERIFY2(at.y() > -75,
                             qPrintable(QString("from %1, %2 m/s: %3").arg(aside).arg(speed).arg(at.y())));
                    continue;
                }
                QVERIFY2(std::abs(at.y() - expected) < 0.005 && std::abs(at.x()) < 0.005,
                         qPrintable(QString("from %1, %2 m/s: at (%3, %4), expected height %5")
                                        .arg(aside)
                                        .arg(speed)
                                        .arg(at.x())
                                        .arg(at.y())
                                        .arg(expected)));
            }
        }
    }

    // Teeth over the gaps, teeth that graze the flanks, and teeth on teeth.
    void aCombFallsIntoAStandingOne_data() { combRows({0.3, 0.38, 0.2, 0.0, -0.9}); }
    void aCombFallsIntoAStandingOne() {
        QFETCH(double, shift);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        Combs combs(withIterations(iterations));
        BodyDef standing{.kind = BodyKind::Static, .shapes = {comb()}};
        combs.ids[0] = add(combs.world, standing);
        BodyDef falling{.shapes = {comb()}, .position = {shift, 2}, .angle = pi, .velocity = {0, -speed}};
        combs.ids[1] = add(combs.world, falling);
        combs.run(fullOrQuick(10, 2));
        QVERIFY(combs.touches > 0);
        QVERIFY2(combs.deepest < 0.05, qPrintable(QString("%1 deep").arg(combs.deepest)));
        if (shift == 0.3) { // in the middle of the gaps: the tips reach the other back
            const double height = combs.world.body(combs.ids[1]).pose.position.y();
            QVERIFY2(std::abs(height - 0.8) < 0.005, qPrintable(QString::number(height)));
        }
    }

    void twoFlyingCombsMeet_data() { combRows({0.3, 0.38, 0.2, 0.0, -0.9}); }
    void twoFlyingCombsMeet() {
        QFETCH(double, shift);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        for (const double spin : {0.0, 3.0}) {
            Combs combs(withIterations(iterations, {0, 0}));
            const double each = 0.5 * std::max(speed, 0.5);
            for (int i = 0; i < 2; ++i) {
                BodyDef def{.shapes = {comb()}};
                def.position = i == 0 ? Vec2(0, -0.7) : Vec2(shift, 0.7 + 0.3);
                def.angle = i * pi;
                def.velocity = {0, i == 0 ? each : -each};
                def.angularVelocity = i == 0 ? spin : 0.5 * spin;
                combs.ids[static_cast<std::size_t>(i)] = add(combs.world, def);
            }
            combs.run(fullOrQuick(10, 2));
            QVERIFY(combs.touches > 0);
            QVERIFY2(combs.deepest < 0.05, qPrintable(QString("spin %1: %2 deep").arg(spin).arg(combs.deepest)));
        }
    }
};

SPACETOW_TEST(ConcaveTest)
#include "concave_test.moc"
