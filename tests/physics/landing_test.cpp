// Heaps that land: an impact has to go through all the rows to the ground before anything is at rest.

#include "core/physics/solver/solve_unconverged.h"
#include "core/physics/state/world_data.h"
#include "tests/support/contact_scenes.h"

#include <vector>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double ballRadius = 0.1;
constexpr double spacing = 0.24; // of rows and columns
constexpr double gap = 0.5;      // from the lowest centres to the floor

BodyDef rough(BodyDef def) {
    def.friction = 0.3;
    return def;
}

/// Rows of balls, every other one shifted by a quarter of a ball.
std::vector<BodyId> addHeap(World& world, int rows, int columns, const Vec2& lowestLeft, const Vec2& velocity) {
    std::vector<BodyId> balls;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            BodyDef def = rough(
                ball(lowestLeft + Vec2(spacing * column + 0.5 * ballRadius * (row % 2), spacing * row), ballRadius));
            def.velocity = velocity;
            balls.push_back(add(world, def));
        }
    }
    return balls;
}

/// Heaps, each above a floor between two walls.
struct Silos {
    World world{{.seconds = 1.0 / 60, .iterations = 4}};
    std::vector<BodyId> balls;

    void addSilo(int rows, int columns, double left = 0) {
        const double right = left + spacing * columns + 2 * ballRadius;
        const double top = spacing * rows + 2;
        add(world, rough(lineBody({left, top}, {left, 0})));
        add(world, rough(lineBody({left, 0}, {right, 0})));
        add(world, rough(lineBody({right, 0}, {right, top})));
        const std::vector<BodyId> more = addHeap(world, rows, columns, {left + 1.5 * ballRadius, gap}, {0, 0});
        balls.insert(balls.end(), more.begin(), more.end());
    }

    /// How far a row falls until those below have closed up, at most: they come to lie half a ballRadius to the side of
    /// each other.
    static double fallOf(int row) {
        const double closed = ballRadius * std::sqrt(4 - 0.25);
        return gap - ballRadius + row * (spacing - closed);
    }

    double meanSquareSpeed() const {
        double sum = 0;
        for (const BodyId id : balls) {
            sum += world.body(id).velocity.squaredNorm();
        }
        return sum / static_cast<double>(balls.size());
    }
};

double secondsToFall(double height) {
    return std::sqrt(2 * height / 9.81);
}

struct Momentum {
    Vec2 linear{0, 0};
    double scale = 0; // what rounding is to be compared with

    explicit Momentum(const World& world) {
        for (const BodyId id : world.bodies()) {
            const BodyState state = world.body(id);
            linear += state.mass * state.velocity;
            scale += state.mass * state.velocity.norm();
        }
    }
};

void verifyKeepsMomentum(World& world, int updates) {
    const Momentum before(world);
    for (int i = 0; i < updates; ++i) {
        world.update();
        const double change = (Momentum(world).linear - before.linear).norm();
        QVERIFY2(change < 1e-10 * before.scale, qPrintable(QString("update %1: %2 N s").arg(i).arg(change)));
    }
    QVERIFY(Momentum(world).scale < 0.9 * before.scale); // they did meet
}

/// Of the bodies of a component, in which all have the same mass: twice their kinetic energy for each kilogram.
double liveliness(const WorldData& data, const std::vector<BodyVelocity>& velocities, Slot root) {
    double sum = 0;
    for (const Slot slot : data.bodies.moving) {
        const BodyVelocity& v = velocities[slot];
        sum += data.contactGraph.roots[slot] == root ? v.x * v.x + v.y * v.y : 0;
    }
    return sum;
}

bool isSame(const BodyVelocity& p, const BodyVelocity& q) {
    return p.x == q.x && p.y == q.y && p.angular == q.angular;
}

} // namespace

class LandingTest : public QObject {
    Q_OBJECT

  private slots:
    void aHeapIsAtRestSoonAfterItsTopHasFallen_data() {
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("columns");
        QTest::newRow("25 rows") << 25 << 20;
        QTest::newRow("60 rows") << 60 << 10;
        QTest::newRow("60 rows, wide") << 60 << 30;
        if (isFullRun()) {
            QTest::newRow("150 rows") << 150 << 20;
        }
    }
    void aHeapIsAtRestSoonAfterItsTopHasFallen() {
        QFETCH(int, rows);
        QFETCH(int, columns);
        Silos silo;
        silo.addSilo(rows, columns);
        run(silo.world, secondsToFall(Silos::fallOf(rows - 1)) + 1.25);
        const double speed = std::sqrt(silo.meanSquareSpeed());
        QVERIFY2(speed < 0.2, qPrintable(QString("%1 m/s").arg(speed)));
    }

    void whatIsAboveFallsFreelyWhileWhatIsBelowIsHeldBack() {
        constexpr int rows = 60;
        Silos silo;
        silo.addSilo(rows, 10);
        const double start = silo.world.body(silo.balls.back()).massCenter.y();
        while (silo.world.body(silo.balls.back()).velocity.y() > -0.8 * 9.81 * secondsToFall(Silos::fallOf(rows - 1))) {
            silo.world.update();
        }
        const BodyState top = silo.world.body(silo.balls.back());
        const double speed = top.velocity.y();
        const double lag = top.massCenter.y() - (start - speed * speed / (2 * 9.81));
        QVERIFY2(std::abs(lag) < 1e-6, qPrintable(QString("%1 m").arg(lag)));
    }

    void whatFollowsABodyThatTheFloorStopsDoesNotEnterIt_data() { iterationRows(); }
    void whatFollowsABodyThatTheFloorStopsDoesNotEnterIt() {
        QFETCH(int, iterations);
        for (const double height : {0.001, 0.002, 0.004, 0.008}) {
            World world(withIterations(iterations, {0, 0}));
            add(world, floorOf("edge"));
            const BodyId hit = add(world, ball({0, ballRadius + height}, ballRadius));
            BodyDef def = ball({0.02, 3 * ballRadius + height}, ballRadius);
            def.velocity = {0, -5};
            const BodyId hammer = add(world, def);
            for (int i = 0; i < 10; ++i) {
                world.update();
                const double apart = (world.body(hammer).massCenter - world.body(hit).massCenter).norm();
                QVERIFY2(apart > 2 * ballRadius - 0.001,
                         qPrintable(QString("from %1 m, update %2: %3 m").arg(height).arg(i).arg(apart)));
            }
        }
    }

    void heapsThatMeetInFreeSpaceKeepTheirMomentum_data() { iterationRows(); }
    void heapsThatMeetInFreeSpaceKeepTheirMomentum() {
        QFETCH(int, iterations);
        World world(withIterations(iterations, {0, 0}));
        addHeap(world, 20, 6, {0, 0}, {0.3, 5});
        addHeap(world, 20, 6, {0.07, 20 * spacing + 0.1}, {0, -8});
        verifyKeepsMomentum(world, 50);
    }

    void aHeapOnAPlatformInFreeSpaceKeepsTheirMomentum_data() { iterationRows(); }
    void aHeapOnAPlatformInFreeSpaceKeepsTheirMomentum() {
        QFETCH(int, iterations);
        World world(withIterations(iterations, {0, 0}));
        addHeap(world, 20, 6, {-0.6, 0.5}, {1, 0});
        BodyDef platform = rough(box({0, 0}, 2, 0.2));
        platform.velocity = {1, 10};
        add(world, platform);
        verifyKeepsMomentum(world, 50);
    }

    void aComponentIsSolvedOnAsIfAllWere() {
        Silos silo;
        silo.addSilo(20, 8);
        silo.addSilo(20, 8, 10);
        run(silo.world, 0.7);
        WorldData some = silo.world.data();
        WorldData all = silo.world.data();
        const SolverScratch& last = silo.world.data().scratch.solver;
        const Slot here = some.contactGraph.roots[silo.balls.front().index];
        const Slot there = some.contactGraph.roots[silo.balls.back().index];
        QVERIFY(here != there && some.constraints.circleContacts.size() > 50);
        some.scratch.solver.unconverged.assign(some.bodies.motions.size(), 0);
        some.scratch.solver.unconverged[here] = 1;
        all.scratch.solver.unconverged.assign(all.bodies.motions.size(), 1);
        reserveForUnconverged(some);
        // The velocities of the last iteration, with impulses that are to be found anew.
        for (WorldData* data : {&some, &all}) {
            data->scratch.solver.velocities = last.plannedVelocities;
            data->scratch.solver.velocities.emplace_back();
            for (const CircleContact& c : data->constraints.circleContacts) {
                data->constraints.batches.circles[c.lane.batch].normalImpulse[c.lane.lane] = 0;
                data->constraints.batches.circles[c.lane.batch].tangentImpulse[c.lane.lane] = 0;
            }
        }
        solveUnconverged(some, 3);
        solveUnconverged(all, 3);
        for (const BodyId id : silo.balls) {
            const Slot slot = id.index;
            const bool solved = some.contactGraph.roots[slot] == here;
            const WorldData& expected = solved ? all : some;
            const BodyVelocity& velocity =
                solved ? expected.scratch.solver.velocities[slot] : last.plannedVelocities[slot];
            QVERIFY(isSame(some.scratch.solver.velocities[slot], velocity));
        }
        // Impulses between bodies that do not bounce take energy.
        const double before = liveliness(some, last.plannedVelocities, here);
        const double after = liveliness(some, some.scratch.solver.velocities, here);
        QVERIFY2(after < 0.99 * before, qPrintable(QString("%1 of %2 m²/s²").arg(after).arg(before)));
    }
};

SPACETOW_TEST(LandingTest)
#include "landing_test.moc"
