#include "tests/support/contact_scenes.h"
#include "tests/support/gaps.h"

#include <algorithm>
#include <utility>
#include <vector>

using namespace spacetow;
using namespace spacetow::test;

namespace {

BodyDef kinematic(BodyDef def, const Vec2& velocity, double spin) {
    def.kind = BodyKind::Kinematic;
    def.velocity = velocity;
    def.angularVelocity = spin;
    return def;
}

/// A closed square frame of four boxes, 2 m inside from the middle.
BodyDef frame(double spin) {
    const auto side = [](const Vec2& at, double halfWidth, double halfHeight) {
        const Vec2 w(halfWidth, 0);
        const Vec2 h(0, halfHeight);
        return Polygon{{at - w - h, at + w - h, at + w + h, at - w + h}};
    };
    return kinematic({.shapes = {side({0, -2.2}, 2.4, 0.2), side({0, 2.2}, 2.4, 0.2), side({-2.2, 0}, 0.2, 2),
                                 side({2.2, 0}, 0.2, 2)}},
                     {0, 0}, spin);
}

/// One iteration an update, as long as one of `iterations` is, so that nothing goes unseen between two.
UpdateParameters oneByOne(int iterations, const Vec2& gravity) {
    return {.gravity = gravity, .seconds = 0.02 / iterations, .iterations = 1};
}

} // namespace

class KinematicTest : public QObject {
    Q_OBJECT

  private slots:
    void aRisingPlatformCarriesWhatLiesOnIt_data() {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<QString>("what");
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("iterations");
        for (const char* floor : floors) {
            for (const char* what : {"ball", "box"}) {
                for (const double speed : {0.05, 0.5, 5.0, 50.0}) {
                    for (const int iterations : iterationCounts) {
                        QTest::addRow("%s on %s, %g m/s, %d iterations", what, floor, speed, iterations)
                            << floor << what << speed << iterations;
                    }
                }
            }
        }
    }
    void aRisingPlatformCarriesWhatLiesOnIt() {
        QFETCH(QString, floor);
        QFETCH(QString, what);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        const BodyId base = add(world, kinematic(floorOf(floor), {0, speed}, 0));
        const double from = world.body(base).pose.position.y();
        const BodyId id = add(world, dropped(what, {0, 0.2}));
        for (int i = 1; i <= 100; ++i) {
            world.update();
            const double risen = world.body(base).pose.position.y() - from;
            QVERIFY(std::abs(risen - speed * 0.02 * i) < 1e-9 * (1 + risen));
            const double above = world.body(id).massCenter.y() - risen;
            QVERIFY2(std::abs(above - 0.2) < 0.005, qPrintable(QString("update %1: %2 above").arg(i).arg(above)));
        }
        QVERIFY(std::abs(world.body(id).velocity.y() - speed) < 0.01);
    }

    void aPlatformThatMovesSidewaysTakesItsLoadAlong_data() { iterationRows(); }
    void aPlatformThatMovesSidewaysTakesItsLoadAlong() {
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef floor = floorOf("polygon");
        floor.friction = 0.5;
        add(world, kinematic(floor, {1, 0}, 0));
        BodyDef def = box({0, 0.2}, 0.2, 0.2);
        def.friction = 0.5;
        const BodyId id = add(world, def);
        run(world, 2);
        QVERIFY2(std::abs(world.body(id).velocity.x() - 1) < 1e-3,
                 qPrintable(QString::number(world.body(id).velocity.x())));
        // It lags by v² / 2μg while it gets up to speed.
        QVERIFY2(std::abs(world.body(id).massCenter.x() - (2 - 1 / (2 * 0.5 * 9.81))) < 0.01,
                 qPrintable(QString::number(world.body(id).massCenter.x())));
    }

    void aKinematicCircleSendsAStillBallOffAtTwiceItsSpeed_data() {
        QTest::addColumn<double>("mass");
        QTest::addColumn<double>("ballMass");
        QTest::addColumn<int>("iterations");
        for (const double mass : {0.001, 0.5, 5.0, 500.0}) {
            for (const double ballMass : {0.001, 1.0, 1000.0}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%g kg into %g kg, %d iterations", mass, ballMass, iterations)
                        << mass << ballMass << iterations;
                }
            }
        }
    }
    void aKinematicCircleSendsAStillBallOffAtTwiceItsSpeed() {
        QFETCH(double, mass);
        QFETCH(double, ballMass);
        QFETCH(int, iterations);
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(1, 17)) {
            const Vec2 way = Rot::fromAngle(degrees * pi / 180) * Vec2(1, 0);
            World world(withIterations(iterations, {0, 0}));
            BodyDef hammer = kinematic(ball(-way, 0.2), way, 0);
            hammer.mass = mass;
            hammer.restitution = 1;
            const BodyId pusher = add(world, hammer);
            BodyDef def = ball({0, 0}, 0.2);
            def.mass = ballMass;
            def.restitution = 1;
            const BodyId id = add(world, def);
            run(world, 1);
            QVERIFY2((world.body(id).velocity - 2 * way).norm() < 1e-9, qPrintable(QString("%1°").arg(degrees)));
            QVERIFY((world.body(pusher).velocity - way).norm() < 1e-12);
        }
    }

    void aKinematicBodyPushesWhatItMeets_data() {
        QTest::addColumn<QString>("pusher");
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("iterations");
        for (const char* pusher : {"ball", "box", "line", "edge"}) {
            for (const double speed : {0.1, 1.0, 10.0, 30.0, 100.0, 1000.0}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%s, %g m/s, %d iterations", pusher, speed, iterations)
                        << pusher << speed << iterations;
                }
            }
        }
    }
    void aKinematicBodyPushesWhatItMeets() {
        QFETCH(QString, pusher);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        for (int k = 0; k < fullOrQuick(100, 20); ++k) {
            World world(withIterations(iterations, {0, 0}));
            BodyDef def = pusher == "ball" || pusher == "box" ? dropped(pusher, {0, 0}) : lineBody({0, -1}, {0, 1});
            if (pusher == "edge") {
                def.shapes = {Edge{{0, 1}, {0, -1}, 0}};
            }
            def.position = {-0.3 - 0.02 * speed * std::fmod(0.618 * k, 1), 0};
            add(world, kinematic(def, {speed, 0}, 0));
            const BodyId id = add(world, ball({0, 0}, 0.05));
            run(world, 0.5 / speed + 0.06);
            QVERIFY2(std::abs(world.body(id).velocity.x() - speed) < 0.01 * speed,
                     qPrintable(QString("start %1: %2 m/s").arg(k).arg(world.body(id).velocity.x())));
        }
    }

    void aPushPastThePivotByNextToNothingSpinsNothing() {
        World world({.gravity = {0, 0}, .iterations = 4});
        const BodyId pinned = add(world, box({0, 0}, 0.5, 0.2));
        world.setFrozen(pinned, true, false);
        BodyDef ram = ball({1e-9, 0.35}, 0.1);
        ram.kind = BodyKind::Kinematic;
        ram.velocity = {0, -5};
        add(world, ram);
        for (int i = 0; i < 3; ++i) {
            world.update();
            QVERIFY2(std::abs(world.body(pinned).angularVelocity) < 1,
                     qPrintable(QString::number(world.body(pinned).angularVelocity)));
        }
        QVERIFY(world.body(pinned).active);
    }

    void aTurningFrameKeepsWhatIsInIt_data() {
        QTest::addColumn<double>("spin");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<int>("iterations");
        for (const double spin : {0.1, 0.436, 2.0, 10.0}) {
            for (const double e : {0.0, 0.5}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%g rad/s, e %g, %d iterations", spin, e, iterations) << spin << e << iterations;
                }
            }
        }
    }
    void aTurningFrameKeepsWhatIsInIt() {
        QFETCH(double, spin);
        QFETCH(double, restitution);
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef walls = frame(spin);
        walls.restitution = restitution;
        const BodyId box = add(world, walls);
        std::vector<BodyId> balls;
        for (int i = 0; i < 20; ++i) {
            BodyDef def = ball({-1.2 + 0.6 * (i % 5), -0.9 + 0.6 * (i / 5)}, 0.1 + 0.02 * (i % 4));
            def.restitution = restitution;
            balls.push_back(add(world, def));
        }
        for (int i = 0; i < fullOrQuick(1500, 300); ++i) {
            world.update();
            for (const BodyId id : balls) {
                const Vec2 at = world.body(box).pose.toLocal(world.body(id).massCenter);
                QVERIFY2(at.cwiseAbs().maxCoeff() < 2,
                         qPrintable(QString("update %1: at (%2, %3) in the frame").arg(i).arg(at.x()).arg(at.y())));
            }
        }
    }

    void aTurningBoxPushesBallsAwayAndNoneGetsIntoIt_data() {
        QTest::addColumn<double>("spin");
        QTest::addColumn<int>("iterations");
        for (const double spin : {0.5, 2.0, 8.0}) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%g rad/s, %d iterations", spin, iterations) << spin << iterations;
            }
        }
    }
    void aTurningBoxPushesBallsAwayAndNoneGetsIntoIt() {
        QFETCH(double, spin);
        QFETCH(int, iterations);
        World world(oneByOne(iterations, {0, 0}));
        add(world, frame(0));
        const BodyId paddle = add(world, kinematic(box({0, 0}, 1.2, 0.1), {0, 0}, spin));
        std::vector<BodyId> balls;
        for (int i = 0; i < 12; ++i) {
            const Vec2 at = Rot::fromAngle(0.5 + 2 * pi * i / 12) * Vec2(0.5 + 0.09 * i, 0);
            if (std::abs(at.y()) > 0.3) {
                balls.push_back(add(world, ball(at, 0.1)));
            }
        }
        int pushed = 0;
        double deepest = 0;
        for (int i = 0; i < iterations * fullOrQuick(500, 100); ++i) {
            world.update();
            for (const TouchEvent& event : world.events().began) {
                pushed += event.a == paddle ? 1 : 0;
            }
            const Transform pose = world.body(paddle).pose;
            for (const BodyId id : balls) {
                const Vec2 at = world.body(id).massCenter;
                QVERIFY(at.cwiseAbs().maxCoeff() < 2);
                deepest = std::max(deepest, 0.1 - distanceTo(world.shapes(paddle).front(), pose, at));
            }
        }
        QVERIFY2(deepest < 0.05, qPrintable(QString("a ball was %1 deep").arg(deepest)));
        QVERIFY(pushed >= 1);
    }

    void aSpinningPlankLeavesNoBallBehind_data() {
        QTest::addColumn<bool>("held");
        QTest::addColumn<double>("spin");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<int>("iterations");
        for (const bool held : {false, true}) {
            for (const double e : {0.0, 0.5, 1.0}) {
                for (const double spin : {3.0, 10.0, 30.0, 100.0}) {
                    for (const int iterations : iterationCounts) {
                        QTest::addRow("%s, %g rad/s, e %g, %d iterations", held ? "heavy and held" : "kinematic", spin,
                                      e, iterations)
                            << held << spin << e << iterations;
                    }
                }
            }
        }
    }
    void aSpinningPlankLeavesNoBallBehind() {
        QFETCH(bool, held);
        QFETCH(double, spin);
        QFETCH(double, restitution);
        QFETCH(int, iterations);
        for (int k = 0; k < fullOrQuick(400, 40); ++k) {
            World world(withIterations(iterations, {0, 0}));
            BodyDef plank = kinematic(box({0, 0}, 3, 0.05), {0, 0}, spin);
            if (held) {
                plank.kind = BodyKind::Dynamic;
                plank.mass = 1e6;
                plank.positionFrozen = true;
            }
            plank.restitution = restitution;
            plank.friction = 0;
            add(world, plank);
            const double angle = 0.3 + 1.5 * std::fmod(0.618 * k, 1);
            const double radius = 0.8 + 2 * std::fmod(0.414 * k, 1);
            const Vec2 out = Rot::fromAngle(angle) * Vec2(1, 0);
            BodyDef def = ball(radius * out, 0.05);
            def.velocity = Rot::fromAngle(k) * Vec2(0.005 * spin, 0);
            def.restitution = restitution;
            def.friction = 0;
            const BodyId id = add(world, def);
            run(world, 2.2 / spin + 0.02);
            // A ball that was hit flies ahead of the plank at its speed there, or faster.
            const double speed = leftOf(out).dot(world.body(id).velocity);
            QVERIFY2(speed > 0.9 * spin * radius,
                     qPrintable(QString("ball %1 at %2 rad, %3 m: %4 m/s").arg(k).arg(angle).arg(radius).arg(speed)));
        }
    }

    void whatHappensAroundAFastPlankIsToldOncePerIteration() {
        World world(withIterations(4, {0, 0}));
        add(world, kinematic(box({0, 0}, 3, 0.05), {0, 0}, 100));
        BodyDef def = ball({0, 0.5}, 0.05);
        def.reportsTouches = true;
        add(world, def);
        std::size_t reports = 0;
        for (int i = 0; i < 5; ++i) {
            world.update();
            int last = -1;
            for (const TagsTouchedEvent& event : world.events().tagsTouched) {
                QVERIFY(event.iteration > last && event.iteration < 4);
                last = event.iteration;
            }
            reports += world.events().tagsTouched.size();
            for (const TouchEvent& event : world.events().began) {
                QVERIFY(event.iteration >= 0 && event.iteration < 4);
            }
        }
        QVERIFY(reports > 0);
    }

    void aFastPlankDisturbsNoPileElsewhere() {
        World world(withIterations(4));
        add(world, floorOf("edge"));
        std::vector<BodyId> pile;
        for (int i = 0; i < 5; ++i) {
            pile.push_back(add(world, box({0, 0.2 + 0.4 * i}, 0.2, 0.2)));
        }
        run(world, 1);
        const Filter elsewhere{TagMask::bit(1), TagMask::bit(1)};
        BodyDef plank = kinematic(box({0, 50}, 3, 0.05), {0, 0}, 100);
        plank.filter = elsewhere;
        add(world, plank);
        for (int i = 0; i < 100; ++i) {
            if (i % 5 == 0) { // one more for the plank to meet
                BodyDef def = ball(Vec2(0, 50) + Rot::fromAngle(i) * Vec2(1 + 0.018 * i, 0), 0.05);
                def.filter = elsewhere;
                add(world, def);
            }
            world.update();
            for (const BodyId id : pile) {
                QVERIFY2(world.body(id).velocity.norm() < 1e-6,
                         qPrintable(QString("update %1: %2 m/s").arg(i).arg(world.body(id).velocity.norm())));
            }
        }
    }
};

SPACETOW_TEST(KinematicTest)
#include "kinematic_test.moc"
