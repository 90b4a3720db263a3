#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/known_values.h"
#include "tests/support/rows.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

BodyDef smooth(BodyDef def, double restitution) {
    def.restitution = restitution;
    def.friction = 0;
    return def;
}

/// Velocity of a ball of 0.2 m that starts at `at` with `velocity` in an elastic right-angled corner.
Vec2 outOfTheCorner(const Vec2& at, const Vec2& velocity, int updates) {
    World world(withIterations(4, {0, 0}));
    add(world, smooth(edgeBody({0, 5}, {0, 0}), 1));
    add(world, smooth(edgeBody({0, 0}, {5, 0}), 1));
    BodyDef def = smooth(ball(at, 0.2), 1);
    def.velocity = velocity;
    const BodyId id = add(world, def);
    for (int i = 0; i < updates; ++i) {
        world.update();
    }
    return world.body(id).velocity;
}

/// Upward speed of a ball of 2 kg that fell onto the floor at 3 m/s.
double reboundOf(double ballRestitution, double floorRestitution) {
    World world(withIterations(20, {0, 0}));
    BodyDef ground = floorOf("edge");
    ground.restitution = floorRestitution;
    add(world, ground);
    BodyDef def = ball({0, 0.5}, 0.2);
    def.mass = 2;
    def.velocity = {0, -3};
    def.restitution = ballRestitution;
    const BodyId id = add(world, def);
    run(world, 0.4);
    return world.body(id).velocity.y();
}

/// Speed of a box after sliding for half a second from 4 m/s.
double speedAfterSliding(double boxFriction, double floorFriction) {
    World world(withIterations(20));
    BodyDef ground = floorOf("edge");
    ground.friction = floorFriction;
    add(world, ground);
    BodyDef def = box({0, 0.1}, 0.4, 0.1);
    def.friction = boxFriction;
    def.velocity = {4, 0};
    const BodyId id = add(world, def);
    run(world, 0.5);
    return world.body(id).velocity.x();
}

/// How far two overlapping balls are apart after a second, surface to surface.
double gapAfterOverlap(double overlap) {
    World world(withIterations(20, {0, 0}));
    const BodyId a = add(world, ball({0, 0}, 0.2));
    const BodyId b = add(world, ball({0.4 - overlap, 0}, 0.2));
    run(world, 1);
    return (world.body(a).massCenter - world.body(b).massCenter).norm() - 0.4;
}

/// Lowest point of a box of half size 0.2 that starts with its middle below the surface of a floor.
double lowestOfAPushedInBox(const BodyDef& ground, double middle, double angle) {
    World world(withIterations(20));
    add(world, ground);
    BodyDef def = box({0, middle}, 0.2, 0.2);
    def.angle = angle;
    const BodyId id = add(world, def);
    run(world, 5);
    return lowestPoint(world, id);
}

struct RodHit {
    double speed, spin;             // after the hit
    double wantedSpeed, wantedSpin; // j = (1 + e) v / (1/m + r²/I)
};

/// A smooth rod that falls at 2 m/s onto a peg `arm` metres right of its middle.
RodHit rodOnPeg(double arm, double restitution) {
    World world(withIterations(20, {0, 0}));
    BodyDef peg = smooth(ball({arm, -0.3}, 0.05), restitution);
    peg.kind = BodyKind::Static;
    add(world, peg);
    BodyDef def = smooth(box({0, 0}, 0.5, 0.01), restitution);
    def.mass = 3;
    def.velocity = {0, -2};
    const BodyId id = add(world, def);
    const double inertia = world.body(id).inertia;
    run(world, 0.16);
    const double impulse = (1 + restitution) * 2 / (1.0 / 3 + arm * arm / inertia);
    const BodyState state = world.body(id);
    return {state.velocity.y(), state.angularVelocity, -2 + impulse / 3, arm * impulse / inertia};
}

void cornerRows() {
    const Vec2 touching = outOfTheCorner({0.2, 0.2}, {-1, -1}, 1);
    known("a ball in a right-angled corner turns back from both walls in one step, sideways", touching.x(), 1, 1e-9);
    known("a ball in a right-angled corner turns back from both walls in one step, upwards", touching.y(), 1, 1e-9);
    const Vec2 flying = outOfTheCorner({0.7, 0.7}, {-1, -1}, 40);
    known("a ball that flies into a right-angled corner comes back the way it went, sideways", flying.x(), 1, 1e-9);
    known("a ball that flies into a right-angled corner comes back the way it went, upwards", flying.y(), 1, 1e-9);
    const Vec2 askew = outOfTheCorner({0.9, 0.5}, {-2, -1}, 40);
    known("a ball that meets one wall of the corner after the other comes back as well, sideways", askew.x(), 2, 1e-9);
    known("a ball that meets one wall of the corner after the other comes back as well, upwards", askew.y(), 1, 1e-9);
}

void reboundRows() {
    known("a hit changes the velocity: 2 kg at 3 m/s with e = ½ leave the floor at 1.5 m/s", reboundOf(0.5, 0.5), 1.5,
          1e-9);
    known("the restitution of a pair is the mean of both: 1 and 0 make ½", reboundOf(1, 0), 1.5, 1e-9);
    known("the restitution of a pair is the mean of both: 0.2 and 0.6 make 0.4", reboundOf(0.2, 0.6), 1.2, 1e-9);
    known("no restitution makes a ball leave faster than it came", reboundOf(1, 1), 3, 1e-9);
    known("the friction of a pair is the geometric mean of both: 0.4 and 0.1 make 0.2", speedAfterSliding(0.4, 0.1),
          4 - 0.5 * 0.2 * 9.81, 0.02);
    known("a pair of which one has no friction has none", speedAfterSliding(0, 0.9), 4, 1e-9);
    known("balls that overlap by a quarter come apart", std::min(gapAfterOverlap(0.1), -0.005), -0.005, 0);
    known("balls that overlap by half come apart", std::min(gapAfterOverlap(0.2), -0.005), -0.005, 0);
    known("balls on top of each other come apart", std::min(gapAfterOverlap(0.4), -0.005), -0.005, 0);
}

void pushedInRows() {
    for (const char* ground : {"edge", "polygon"}) {
        for (const double middle : {-0.05, -0.15}) {
            for (const double angle : {0.0, 0.3}) {
                known(qPrintable(QString("a box with its middle %1 m inside a floor (%2), turned by %3, is pushed out")
                                     .arg(-middle)
                                     .arg(ground)
                                     .arg(angle)),
                      lowestOfAPushedInBox(floorOf(ground), middle, angle), 0, 0.005);
            }
        }
    }
    known("a box in the band of an edge of some depth is pushed out in front",
          lowestOfAPushedInBox(edgeBody({-20, 0}, {20, 0}, 0.5), -0.3, 0.1), 0, 0.005);
}

void rodRows() {
    for (const double e : {0.1, 0.5, 1.0}) {
        for (const double arm : {-0.45, -0.2, 0.0, 0.1, 0.3}) {
            const RodHit hit = rodOnPeg(arm, e);
            known(qPrintable(
                      QString("a rod hit %1 m off its middle, e = %2, has the speed of the formula").arg(arm).arg(e)),
                  hit.speed, hit.wantedSpeed, 1e-6);
            known(qPrintable(
                      QString("a rod hit %1 m off its middle, e = %2, has the spin of the formula").arg(arm).arg(e)),
                  hit.spin, hit.wantedSpin, 1e-6);
        }
    }
}

} // namespace

class SingleHitsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyNumberIsWhatItsSentenceSays_data() {
        knownValueColumns();
        cornerRows();
        reboundRows();
        pushedInRows();
        rodRows();
    }
    void everyNumberIsWhatItsSentenceSays() { checkKnownValue(); }

    void aBallLeavesAFloorAsItCameWhateverItsAngle_data() {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<int>("iterations");
        for (const char* floor : floors) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%s, %d iterations: at (1, −1) in, at (1, 1) out, the spin unchanged", floor, iterations)
                    << floor << iterations;
            }
        }
    }
    void aBallLeavesAFloorAsItCameWhateverItsAngle() {
        QFETCH(QString, floor);
        QFETCH(int, iterations);
        for (int step = 0; step < 24; ++step) {
            World world(withIterations(iterations, {0, 0}));
            add(world, smooth(floorOf(floor), 1));
            BodyDef def = smooth(ball({0, 0.7}, 0.2), 1);
            def.angle = step * pi / 12;
            def.velocity = {1, -1};
            def.angularVelocity = step % 3 - 1;
            const BodyId id = add(world, def);
            run(world, 1);
            const BodyState state = world.body(id);
            QVERIFY2((state.velocity - Vec2(1, 1)).norm() < 1e-9, qPrintable(QString("step %1").arg(step)));
            QCOMPARE(state.angularVelocity, def.angularVelocity);
        }
    }

    void smoothBallsKeepTheirSpinsAndAllTheirEnergy_data() { iterationRows(); }
    void smoothBallsKeepTheirSpinsAndAllTheirEnergy() {
        QFETCH(int, iterations);
        for (int step = -9; step <= 9; ++step) {
            World world(withIterations(iterations, {0, 0}));
            BodyDef a = smooth(ball({-1, 0.05 * step}, 0.2), 1);
            a.velocity = {2, 0};
            a.angularVelocity = 3;
            BodyDef b = smooth(ball({0, 0}, 0.3), 1);
            b.angularVelocity = -1;
            const BodyId idA = add(world, a);
            const BodyId idB = add(world, b);
            const double start = totals(world).energy();
            run(world, 1);
            QVERIFY(world.body(idB).velocity.norm() > 0.01);
            QCOMPARE(world.body(idA).angularVelocity, 3.0);
            QCOMPARE(world.body(idB).angularVelocity, -1.0);
            QVERIFY(std::abs(totals(world).energy() / start - 1) < 1e-9);
        }
    }

    void aBulletBouncesOffAThinEdge_data() { iterationRows(); }
    void aBulletBouncesOffAThinEdge() {
        QFETCH(int, iterations);
        for (int shot = 0; shot < 50; ++shot) {
            World world(withIterations(iterations, {0, 0}));
            add(world, smooth(edgeBody({-3, 0}, {3, 0}, 0.15), 1));
            BodyDef def = smooth(ball({0, 1 + 0.37 * shot}, 0.05), 1);
            def.velocity = {0, -1000};
            const BodyId id = add(world, def);
            run(world, 0.06);
            QVERIFY2(std::abs(world.body(id).velocity.y() - 1000) < 1e-6, qPrintable(QString("shot %1").arg(shot)));
        }
    }
};

SPACETOW_TEST(SingleHitsTest)
#include "single_hits_test.moc"
