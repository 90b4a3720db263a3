#include "tests/support/contact_scenes.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double radiusA = 0.2;
constexpr double radiusB = 0.3;
constexpr double reach = radiusA + radiusB;

struct Momenta {
    Vec2 linear{0, 0};
    double angular = 0; // about the origin
    double energy = 0;  // kinetic
};

Momenta momentaOf(const World& world) {
    Momenta sum;
    for (const BodyId id : world.bodies()) {
        const BodyState s = world.body(id);
        sum.linear += s.mass * s.velocity;
        sum.angular += s.mass * cross(s.massCenter, s.velocity) + s.inertia * s.angularVelocity;
        sum.energy += 0.5 * (s.mass * s.velocity.squaredNorm() + s.inertia * s.angularVelocity * s.angularVelocity);
    }
    return sum;
}

BodyDef elastic(const Vec2& at, double radius, double friction) {
    BodyDef def = ball(at, radius);
    def.restitution = 1;
    def.friction = friction;
    return def;
}

struct CircleShot {
    double speed;    // of one towards the other, m/s
    double offset;   // of the centres across the way, in sums of the radii
    double friction; // of both
    bool moving;     // both, not only the first
    int iterations;
};

/// An empty text when the circles met and kept what they must keep.
QString whatIsWrong(const CircleShot& shot, int degrees) {
    World world(withIterations(shot.iterations, {0, 0}));
    const Rot turn = Rot::fromAngle(degrees * pi / 180);
    // So that the impact falls on another moment of the update for every angle.
    const double phase = std::fmod(0.618 * degrees, 1);
    const double distance = 0.6 + 0.02 * shot.speed * phase;
    const Vec2 common = shot.moving ? Vec2(turn * Vec2(-0.3, 0.7) * shot.speed) : Vec2(0, 0);
    BodyDef a = elastic(turn * Vec2(-distance, shot.offset * reach), radiusA, shot.friction);
    a.velocity = turn * Vec2(shot.speed, 0) + common;
    BodyDef b = elastic({0, 0}, radiusB, shot.friction);
    b.velocity = common;
    if (shot.friction > 0) {
        a.angularVelocity = 3 * shot.speed;
        b.angularVelocity = -shot.speed;
    }
    const BodyId idA = add(world, a);
    const BodyId idB = add(world, b);
    const Momenta before = momentaOf(world);
    run(world, std::max(0.06, (distance + 0.3) / shot.speed + 0.02));
    const Momenta after = momentaOf(world);
    const double mass = world.body(idA).mass;
    const auto text = [&](const char* what, double figure) {
        return QString("%1°: %2 %3").arg(degrees).arg(what).arg(figure);
    };
    if ((world.body(idB).velocity - common).norm() < 0.01 * shot.speed) {
        return text("missed", 0);
    }
    const double momentum = (after.linear - before.linear).norm() / (mass * shot.speed);
    if (!(momentum < 1e-9)) {
        return text("momentum off by", momentum);
    }
    const double angular = (after.angular - before.angular) / (mass * shot.speed);
    if (!(std::abs(angular) < 1e-9)) {
        return text("angular momentum off by", angular);
    }
    const double energy = after.energy / before.energy - 1;
    return shot.friction > 0         ? energy < 1e-9 ? QString() : text("energy rose by", energy)
                   : std::abs(energy) < 1e-6 ? QString()
                                     : text("energy off by", energy);
}

} // namespace

class ElasticCirclesTest : public QObject {
    Q_OBJECT

  private slots:
    void circlesCollideElasticallyFromEveryAngle_data() {
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("offset");
        QTest::addColumn<int>("iterations");
        for (const double speed : {0.1, 1.0, 10.0, 100.0}) {
            for (int tenths = 0; tenths <= 9; tenths += fullOrQuick(1, 3)) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%g m/s, offset 0.%d, %d iterations", speed, tenths, iterations)
                        << speed << 0.1 * tenths << iterations;
                }
            }
        }
    }
    void circlesCollideElasticallyFromEveryAngle() {
        QFETCH(double, speed);
        QFETCH(double, offset);
        QFETCH(int, iterations);
        for (const double friction : {0.0, 0.5}) {
            for (const bool moving : {false, true}) {
                // The number of degrees between two shots of a quick run divides neither 90 nor 360.
                for (int degrees = 0; degrees < 360; degrees += fullOrQuick(1, friction > 0 || moving ? 53 : 7)) {
                    const QString wrong = whatIsWrong({speed, offset, friction, moving, iterations}, degrees);
                    QVERIFY2(wrong.isEmpty(), qPrintable(QString("friction %1, %2: %3")
                                                             .arg(friction)
                                                             .arg(moving ? "both moving" : "one at rest", wrong)));
                }
            }
        }
    }

    void overlappingCirclesSeparateAndGainNothing_data() {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("iterations");
        for (const double distance : {0.0, 0.1, 0.5, 0.9, 0.99}) {
            for (const double speed : {0.0, 0.1, 1.0, 10.0, 100.0}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("distance %g, %g m/s, %d iterations", distance, speed, iterations)
                        << distance << speed << iterations;
                }
            }
        }
    }
    void overlappingCirclesSeparateAndGainNothing() {
        QFETCH(double, distance);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(1, 17)) {
            World world(withIterations(iterations, {0, 0}));
            const Rot turn = Rot::fromAngle(degrees * pi / 180);
            BodyDef a = elastic(turn * Vec2(-distance * reach, 0), radiusA, 0);
            a.velocity = Rot::fromAngle(0.7) * turn * Vec2(speed, 0);
            const BodyId idA = add(world, a);
            const BodyId idB = add(world, elastic({0, 0}, radiusB, 0));
            const Momenta before = momentaOf(world);
            const double mass = world.body(idA).mass;
            bool pushed = false;
            for (int i = 0; i < 50; ++i) {
                world.update();
                pushed = pushed || (!world.events().began.empty() && world.events().began.front().solid);
                const Momenta now = momentaOf(world);
                const double momentum = (now.linear - before.linear).norm();
                QVERIFY2(momentum <= 1e-9 * mass * speed, qPrintable(QString("%1°: %2").arg(degrees).arg(momentum)));
                QVERIFY2(now.energy <= before.energy * (1 + 1e-9),
                         qPrintable(QString("%1°: %2 of %3").arg(degrees).arg(now.energy).arg(before.energy)));
            }
            const double gap = (world.body(idA).massCenter - world.body(idB).massCenter).norm() - reach;
            QVERIFY2(gap > -0.005, qPrintable(QString("%1°: gap %2").arg(degrees).arg(gap)));
            QVERIFY2(pushed, qPrintable(QString("%1°: not touched").arg(degrees)));
            // Where the centres coincide any direction will do, one across the motion too.
            QVERIFY2(distance == 0 || world.body(idB).velocity.norm() >= 0.1 * speed,
                     qPrintable(QString("%1°: not pushed").arg(degrees)));
        }
    }
};

SPACETOW_TEST(ElasticCirclesTest)
#include "elastic_circles_test.moc"
