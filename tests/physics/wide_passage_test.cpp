// What passes one-way walls from behind: at bends of any angle, at joints that meet but for rounding, through doors
// that move, and spinning.

#include "tests/support/passages.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double anyBends[] = {-170, -151, -133, -97, -71, -38, -17, -5, 5, 23, 44, 83, 101, 138, 159, 170}; // degrees
constexpr double wallDepths[] = {0, 0.1, 0.5};

double halfOf(double degrees) {
    return 0.5 * degrees * pi / 180;
}

/// From where below the bend nothing of a body is within the depth of its walls, m.
double startBelow(double bend, double depth) {
    return (depth + 0.6) / std::cos(halfOf(bend));
}

/// In quick runs one row of so many.
struct Thin {
    int every;
    int row = 0;

    bool takes() { return row++ % (isFullRun() ? 1 : every) == 0; }
};

void bendRows(int every) {
    QTest::addColumn<QString>("what");
    QTest::addColumn<double>("bend");
    QTest::addColumn<double>("depth");
    Thin thin{every};
    for (const char* what : passers) {
        for (const double bend : anyBends) {
            for (const double depth : wallDepths) {
                if (thin.takes()) {
                    QTest::addRow("%s, %g degrees, depth %g", what, bend, depth) << what << bend << depth;
                }
            }
        }
    }
}

/// Whose legs reach beyond the start.
Flight flightAtBend(int iterations, double bend, double depth) {
    return {iterations, bentBy(bend, startBelow(bend, depth) + 5), depth};
}

/// How a joint misses: along the walls (a gap, or one over the other), and across them.
struct Miss {
    double along, across; // m
};

/// A row of edges along x whose ends miss each other, turned by the angle; joints are at the odd multiples of 0.15.
World rowThatMisses(const Miss& miss, double angle, double depth, bool oneBody) {
    World world(withIterations(4, {0, 0}));
    const Rot turn = Rot::fromAngle(angle);
    BodyDef all{.kind = BodyKind::Static};
    for (int i = -8; i <= 8; ++i) {
        const double up = i % 2 == 0 ? 0 : miss.across;
        const Edge edge{turn * Vec2(0.3 * i - 0.15 + 0.5 * miss.along, up),
                        turn * Vec2(0.3 * i + 0.15 - 0.5 * miss.along, up), depth};
        if (oneBody) {
            all.shapes.emplace_back(edge);
        } else {
            add(world, edgeBody(edge.a, edge.b, depth));
        }
    }
    if (oneBody) {
        add(world, all);
    }
    return world;
}

/// How a door of several edges moves.
struct DoorMotion {
    const char* name;
    Vec2 velocity;
    double spin;
};

const DoorMotion doorMotions[] = {{"still", {0, 0}, 0},      {"aside", {3, 0}, 0},      {"towards", {0, -2}, 0},
                                  {"away", {0, 0.7}, 0},     {"turning", {0, 0}, 0.5},  {"turning back", {0, 0}, -0.5},
                                  {"aslant", {-1, -1}, 0.3}, {"fast", {-20, -30}, -0.2}};

/// A kinematic body of five edges, a little bent, about the origin; its front is up.
BodyDef door(const DoorMotion& motion, double bend, double depth) {
    const double step = bend * pi / 180 / 5;
    std::vector<Vec2> corners{{0, 0}};
    for (int i = -2; i <= 2; ++i) {
        corners.push_back(corners.back() + Rot::fromAngle(step * i).right());
    }
    const Vec2 middle = 0.5 * (corners[2] + corners[3]);
    BodyDef def{.kind = BodyKind::Kinematic, .velocity = motion.velocity, .angularVelocity = motion.spin};
    for (int i = 0; i < 5; ++i) {
        def.shapes.emplace_back(Edge{corners[i] - middle, corners[i + 1] - middle, depth});
    }
    return def;
}

void doorRows(int every) {
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("motion");
    QTest::addColumn<double>("bend");
    QTest::addColumn<double>("depth");
    Thin thin{every};
    for (const char* what : passers) {
        for (int motion = 0; motion < static_cast<int>(std::size(doorMotions)); ++motion) {
            for (const double bend : {-35.0, 0.0, 35.0}) {
                for (const double depth : wallDepths) {
                    if (thin.takes()) {
                        QTest::addRow("%s, %s, %g degrees, depth %g", what, doorMotions[motion].name, bend, depth)
                            << what << motion << bend << depth;
                    }
                }
            }
        }
    }
}

void spinRows(int every) {
    QTest::addColumn<QString>("what");
    QTest::addColumn<double>("spin");
    QTest::addColumn<double>("depth");
    Thin thin{every};
    for (const char* what : passers) {
        for (const double spin : {-60.0, -27.0, -11.0, -5.0, 5.0, 8.0, 19.0, 42.0, 60.0}) {
            for (const double depth : wallDepths) {
                if (thin.takes()) {
                    QTest::addRow("%s, %g rad/s, depth %g", what, spin, depth) << what << spin << depth;
                }
            }
        }
    }
}

} // namespace

class WidePassageTest : public QObject {
    Q_OBJECT

  private slots:
    void whatComesFromBehindPassesAnyBend_data() { bendRows(5); }
    void whatComesFromBehindPassesAnyBend() {
        QFETCH(QString, what);
        QFETCH(double, bend);
        QFETCH(double, depth);
        const double below = startBelow(bend, depth);
        for (const int iterations : {4, 20}) {
            for (const double speed : {2.0, 50.0}) {
                for (const double across : {-0.12, 0.0, 0.05}) {
                    Flight flight = flightAtBend(iterations, bend, depth);
                    flight.start(what, {across, -below}, {0, speed});
                    const QString fault = flight.fly(below + 1);
                    QVERIFY2(fault.isEmpty(), qPrintable(flownText({speed, across, iterations}) + fault));
                }
            }
        }
    }

    void whatTurnsBackInAnyBendIsLetBack_data() { bendRows(7); }
    void whatTurnsBackInAnyBendIsLetBack() {
        QFETCH(QString, what);
        QFETCH(double, bend);
        QFETCH(double, depth);
        const double below = startBelow(bend, depth);
        for (const double top : {-0.2, 0.0}) {
            Flight flight = flightAtBend(4, bend, depth);
            flight.start(what, {0.03, -below}, {0, 2});
            QString fault = flight.fly(below + top);
            QVERIFY2(fault.isEmpty(), qPrintable(QString("to %1: %2").arg(top).arg(fault)));
            flight.turnBack();
            fault = flight.fly(below);
            QVERIFY2(fault.isEmpty(), qPrintable(QString("back from %1: %2").arg(top).arg(fault)));
        }
    }

    void whatComesFromTheFrontOfAnyBendIsStopped_data() { bendRows(7); }
    /// Against the middle of the right wall.
    void whatComesFromTheFrontOfAnyBendIsStopped() {
        QFETCH(QString, what);
        QFETCH(double, bend);
        QFETCH(double, depth);
        const Vec2 along = Rot::fromAngle(halfOf(bend)).right();
        const Vec2 normal = leftOf(along);
        const double length = startBelow(bend, depth) + 5;
        const Vec2 on = 0.5 * length * along;
        // Half way to the other wall, where that is near.
        const double room = bend > 90 ? std::min(0.8, on.x() / std::max(-normal.x(), 0.1)) : 0.8;
        for (const double speed : {0.5, 7.0, 50.0}) {
            Flight flight = flightAtBend(4, bend, depth);
            flight.start(what, on + room * normal, -speed * normal);
            bool touched = false;
            for (int i = 0; i < 100; ++i) {
                flight.world.update();
                touched = touched || !flight.world.events().began.empty();
                QVERIFY2(normal.dot(flight.world.body(flight.id).massCenter - on) > 0,
                         qPrintable(QString("%1 m/s, update %2").arg(speed).arg(i)));
            }
            QVERIFY2(touched, qPrintable(QString("%1 m/s").arg(speed)));
        }
    }

    void whatComesFromBehindPassesWhereEdgesMeetButForRounding_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<double>("along");
        QTest::addColumn<double>("across");
        QTest::addColumn<bool>("oneBody");
        Thin thin{9};
        for (const char* what : passers) {
            for (const double along : {-1e-6, -1e-9, 0.0, 1e-12, 1e-9, 1e-7, 1e-6}) {
                for (const double across : {-1e-6, -1e-10, 0.0, 1e-12, 1e-8, 1e-6}) {
                    for (const bool oneBody : {false, true}) {
                        if (thin.takes()) {
                            QTest::addRow("%s, %g m along, %g m across, %s", what, along, across,
                                          oneBody ? "one body" : "many")
                                << what << along << across << oneBody;
                        }
                    }
                }
            }
        }
    }
    void whatComesFromBehindPassesWhereEdgesMeetButForRounding() {
        QFETCH(QString, what);
        QFETCH(double, along);
        QFETCH(double, across);
        QFETCH(bool, oneBody);
        for (const double depth : wallDepths) {
            for (const double angle : {0.0, 0.7, 2.9}) {
                for (const double speed : {1.0, 50.0}) {
                    for (const double degrees : {62.0, 90.0}) {
                        Flight flight(rowThatMisses({along, across}, angle, depth, oneBody));
                        const Vec2 direction = Rot::fromAngle(angle + degrees * pi / 180).right();
                        flight.start(what, -(1.2 * depth + 0.7) * direction, speed * direction);
                        const QString fault = flight.fly(1.2 * depth + 1.4);
                        QVERIFY2(fault.isEmpty(), qPrintable(QString("depth %1, at %2, %3 m/s, %4°: %5")
                                                                 .arg(depth)
                                                                 .arg(angle)
                                                                 .arg(speed)
                                                                 .arg(degrees)
                                                                 .arg(fault)));
                    }
                }
            }
        }
    }

    void whatComesFromBehindPassesADoorThatMoves_data() { doorRows(5); }
    void whatComesFromBehindPassesADoorThatMoves() {
        QFETCH(QString, what);
        QFETCH(int, motion);
        QFETCH(double, bend);
        QFETCH(double, depth);
        const DoorMotion& moves = doorMotions[motion];
        for (const int iterations : {4, 20}) {
            for (const double speed : {2.5, 40.0}) { // of the body towards the door
                for (const double across : {-0.1, 0.4}) {
                    Flight flight(World(withIterations(iterations, {0, 0})));
                    const double below = depth + 0.9;
                    BodyDef def = door(moves, bend, depth);
                    def.angle = -moves.spin * below / speed; // straight when they meet
                    add(flight.world, def);
                    const Vec2 velocity = moves.velocity + Vec2(0, speed);
                    flight.start(what, {across, -below}, velocity);
                    const QString fault = flight.fly((below + 1) * velocity.norm() / speed);
                    QVERIFY2(fault.isEmpty(), qPrintable(flownText({speed, across, iterations}) + fault));
                }
            }
        }
    }

    void whatComesFromTheFrontOfADoorThatMovesIsStopped_data() { doorRows(5); }
    void whatComesFromTheFrontOfADoorThatMovesIsStopped() {
        QFETCH(QString, what);
        QFETCH(int, motion);
        QFETCH(double, bend);
        QFETCH(double, depth);
        const DoorMotion& moves = doorMotions[motion];
        for (const double speed : {0.8, 40.0}) {
            Flight flight(World(withIterations(4, {0, 0})));
            BodyDef def = door(moves, bend, depth);
            const BodyId wall = add(flight.world, def);
            flight.start(what, {0.05, 0.6}, moves.velocity + Vec2(0, -speed));
            bool touched = false;
            for (int i = 0; i < 60; ++i) {
                flight.world.update();
                touched = touched || !flight.world.events().began.empty();
                const Vec2 at = flight.world.body(wall).pose.toLocal(flight.world.body(flight.id).massCenter);
                if (std::abs(at.x()) > 1.8) {
                    break; // off at the side
                }
                QVERIFY2(at.y() > -0.12, qPrintable(QString("%1 m/s, update %2: %3").arg(speed).arg(i).arg(at.y())));
            }
            QVERIFY2(touched, qPrintable(QString("%1 m/s").arg(speed)));
        }
    }

    void whatSpinsBackBeforeItIsThroughIsLetBack_data() { spinRows(4); }
    void whatSpinsBackBeforeItIsThroughIsLetBack() {
        QFETCH(QString, what);
        QFETCH(double, spin);
        QFETCH(double, depth);
        for (const int iterations : {4, 20}) {
            for (const double speed : {1.0, 20.0}) {
                for (const double top : {-0.25, 0.0}) { // of the centre of mass: never in front as a whole
                    Flight flight(iterations, {{-5, 0}, {-0.1, 0}, {0.2, 0}, {5, 0}}, depth);
                    flight.start(what, {0.03, -depth - 0.8}, {0, speed}, -spin);
                    QString fault = flight.fly(top - flight.at.y() - 0.02 * speed);
                    QVERIFY2(fault.isEmpty(), qPrintable(QString("%1 m/s, to %2: %3").arg(speed).arg(top).arg(fault)));
                    flight.turnBack(spin);
                    fault = flight.fly(depth + 1);
                    QVERIFY2(fault.isEmpty(),
                             qPrintable(QString("%1 m/s, back from %2: %3").arg(speed).arg(top).arg(fault)));
                }
            }
        }
    }

    void whatSpinsAgainstTheFrontAfterItHasPassedIsStopped_data() { spinRows(4); }
    void whatSpinsAgainstTheFrontAfterItHasPassedIsStopped() {
        QFETCH(QString, what);
        QFETCH(double, spin);
        QFETCH(double, depth);
        for (const int iterations : {4, 20}) {
            for (const double speed : {0.7, 4.0, 50.0}) {
                Flight flight(iterations, {{-50, 0}, {-0.1, 0}, {0.2, 0}, {50, 0}}, depth);
                flight.start(what, {0.03, -depth - 0.7}, {0, 4});
                const QString fault = flight.fly(depth + 1.5);
                QVERIFY2(fault.isEmpty(), qPrintable(fault));
                flight.world.setVelocity(flight.id, {0, -speed}, spin);
                bool touched = false;
                for (int i = 0; i < 120; ++i) {
                    flight.world.update();
                    touched = touched || !flight.world.events().began.empty();
                    QVERIFY2(flight.world.body(flight.id).massCenter.y() > 0,
                             qPrintable(QString("%1 m/s, %2 iterations, update %3").arg(speed).arg(iterations).arg(i)));
                }
                QVERIFY2(touched, qPrintable(QString("%1 m/s").arg(speed)));
            }
        }
    }
};

SPACETOW_TEST(WidePassageTest)
#include "wide_passage_test.moc"
