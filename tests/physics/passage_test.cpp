// One-way walls that are passed from behind by what has many parts, and where they are joined.

#include "tests/support/passages.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int bends[] = {-120, -60, -10, 10, 60, 120}; // degrees; positive: hollow as seen from the front

void passerRows(bool bent) {
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("bend");
    QTest::addColumn<double>("depth");
    for (const char* what : passers) {
        for (const int bend : bends) {
            for (const double depth : {0.0, 0.1, 0.5}) {
                if (bent || bend == 10) {
                    QTest::addRow("%s, %d degrees, depth %g", what, bend, depth) << what << bend << depth;
                }
            }
        }
    }
}

} // namespace

class PassageTest : public QObject {
    Q_OBJECT

  private slots:
    void whatComesFromBehindPassesWhereTwoEdgesMeetAtAnAngle_data() { passerRows(true); }
    void whatComesFromBehindPassesWhereTwoEdgesMeetAtAnAngle() {
        QFETCH(QString, what);
        QFETCH(int, bend);
        QFETCH(double, depth);
        const double below = (depth + 0.6) / std::cos(0.5 * bend * pi / 180);
        for (const int iterations : {4, 20}) {
            for (const double speed : {0.2, 2.0, 50.0}) {
                for (const double across : {-0.12, 0.0}) {
                    if (speed < 1 && (iterations > 4 || across == 0)) {
                        continue; // takes long
                    }
                    Flight flight(iterations, bentBy(bend), depth);
                    flight.start(what, {across, -below}, {0, speed});
                    const QString fault = flight.fly(below + 1);
                    QVERIFY2(fault.isEmpty(), qPrintable(flownText({speed, across, iterations}) + fault));
                }
            }
        }
    }

    void whatTurnsBackHalfWayThroughABendIsLetBack_data() { passerRows(true); }
    void whatTurnsBackHalfWayThroughABendIsLetBack() {
        QFETCH(QString, what);
        QFETCH(int, bend);
        QFETCH(double, depth);
        const double below = (depth + 0.6) / std::cos(0.5 * bend * pi / 180);
        for (const double speed : {0.5, 2.0}) {
            for (const double top : {-0.2, 0.0, 0.1}) {
                Flight flight(4, bentBy(bend), depth);
                flight.start(what, {0.03, -below}, {0, speed});
                QString fault = flight.fly(below + top);
                QVERIFY2(fault.isEmpty(), qPrintable(QString("%1 m/s, to %2: %3").arg(speed).arg(top).arg(fault)));
                flight.turnBack();
                fault = flight.fly(below);
                QVERIFY2(fault.isEmpty(),
                         qPrintable(QString("%1 m/s, back from %2: %3").arg(speed).arg(top).arg(fault)));
            }
        }
    }

    void whatComesFromBehindPassesAslantAcrossManyShortEdges_data() { passerRows(true); }
    void whatComesFromBehindPassesAslantAcrossManyShortEdges() {
        QFETCH(QString, what);
        QFETCH(int, bend);
        QFETCH(double, depth);
        const double share = std::abs(bend) > 60 ? 0.5 : 1; // of the bend; further ones look into each other's face
        for (const double speed : {0.2, 3.0, 50.0}) {
            for (const double degrees : {45.0, 90.0, 120.0}) {
                const Vec2 direction = Rot::fromAngle(degrees * pi / 180).right();
                Flight flight(4, arcOf(share * bend), depth);
                flight.start(what, -(1.5 * depth + 1) * direction, speed * direction);
                const QString fault = flight.fly(1.5 * depth + 2);
                QVERIFY2(fault.isEmpty(), qPrintable(QString("%1 m/s, %2°: %3").arg(speed).arg(degrees).arg(fault)));
            }
        }
    }

    void whatTurnsAboutWhileItPassesTouchesNothing_data() { passerRows(false); }
    void whatTurnsAboutWhileItPassesTouchesNothing() {
        QFETCH(QString, what);
        QFETCH(double, depth);
        for (const double spin : {-1.0, 0.5, 1.0}) {
            Flight flight(4, {{-3, 0}, {-0.1, 0}, {0.2, 0}, {3, 0}}, depth);
            flight.start(what, {0.03, -depth - 0.7}, {0, 1}, spin);
            const QString fault = flight.fly(depth + 1.5);
            QVERIFY2(fault.isEmpty(), qPrintable(QString("%1 rad/s: %2").arg(spin).arg(fault)));
        }
    }

    void whatHasPassedABendIsStoppedByItsFront_data() { passerRows(true); }
    void whatHasPassedABendIsStoppedByItsFront() {
        QFETCH(QString, what);
        QFETCH(int, bend);
        QFETCH(double, depth);
        const double below = (depth + 0.6) / std::cos(0.5 * bend * pi / 180);
        const double above = bend > 60 ? 1.6 : 1;
        Flight flight(4, bentBy(bend), depth);
        flight.start(what, {0.03, -below}, {0, 1});
        QVERIFY(flight.fly(below + above).isEmpty());
        flight.turnBack();
        bool touched = false;
        for (int i = 0; i < 150; ++i) {
            flight.world.update();
            touched = touched || !flight.world.events().began.empty();
        }
        QVERIFY(touched);
    }

    void whatComesFromTheFrontIsStoppedBesideABodyThatPasses_data() { passerRows(true); }
    void whatComesFromTheFrontIsStoppedBesideABodyThatPasses() {
        QFETCH(QString, what);
        QFETCH(int, bend);
        QFETCH(double, depth);
        const double below = (depth + 0.6) / std::cos(0.5 * bend * pi / 180);
        for (const double speed : {0.5, 50.0}) {
            Flight flight(4, bentBy(bend), depth);
            flight.start(what, {0.03, -below}, {0, 0.2});
            QVERIFY(flight.fly(below).isEmpty());
            const Vec2 normal = Rot::fromAngle((0.5 * bend + 90) * pi / 180).right();
            const Vec2 on = 3 * Rot::fromAngle(0.5 * bend * pi / 180).right();
            BodyDef def = passerOf(what, on + 0.8 * normal);
            def.velocity = -speed * normal;
            const BodyId id = add(flight.world, def);
            for (int i = 0; i < 100; ++i) {
                flight.world.update();
                QVERIFY2(normal.dot(flight.world.body(id).massCenter - on) > 0,
                         qPrintable(QString("%1 m/s, update %2").arg(speed).arg(i)));
            }
        }
    }

    void whatHooksAroundAFreeEndIsHeldByTheFront() {
        // The upper arm of a hook lies on a ledge, its centre of mass is below.
        for (const double depth : {0.0, 0.1}) {
            World world(withIterations(4));
            add(world, edgeBody({0, 0}, {3, 0}, depth));
            BodyDef hook{.shapes = {Polygon{{{-0.3, -1.5},
                                             {0.5, -1.5},
                                             {0.5, -1.2},
                                             {-0.1, -1.2},
                                             {-0.1, 0},
                                             {0.5, 0},
                                             {0.5, 0.2},
                                             {-0.3, 0.2}}}},
                         .position = {0.15, 0.05}};
            const BodyId id = add(world, hook);
            run(world, 3);
            QVERIFY2(world.body(id).pose.position.y() > -0.3,
                     qPrintable(QString("depth %1: %2").arg(depth).arg(world.body(id).pose.position.y())));
        }
    }
};

SPACETOW_TEST(PassageTest)
#include "passage_test.moc"
