#include "tests/support/contact_scenes.h"
#include "tests/support/gaps.h"

#include <vector>

using namespace spacetow;
using namespace spacetow::test;

namespace {

const char* const things[] = {"ball", "box", "hexagon", "ship"};
constexpr double depths[] = {0, 0.1, 0.5, noBack};

QString nameOf(double depth) {
    return depth == noBack ? QString("infinite depth") : QString("depth %1").arg(depth);
}

void depthRows(bool infinite) {
    QTest::addColumn<QString>("what");
    QTest::addColumn<double>("depth");
    QTest::addColumn<int>("iterations");
    for (const char* what : things) {
        for (const double depth : depths) {
            if (depth == noBack && !infinite) {
                continue;
            }
            for (const int iterations : iterationCounts) {
                QTest::addRow("%s, %s, %d iterations", what, qPrintable(nameOf(depth)), iterations)
                    << what << depth << iterations;
            }
        }
    }
}

/// An edge through the origin, 10 m long, solid for what comes from the turned +y, and one thing that meets it.
struct Meeting {
    Rot turn;
    World world;
    BodyId id;
    Vec2 start;

    /// `at` and `velocity` in the coordinates of the edge.
    Meeting(const QString& what, double depth, int iterations, double degrees, const Vec2& at, const Vec2& velocity)
        : turn(Rot::fromAngle(degrees * pi / 180)), world(withIterations(iterations, {0, 0})), start(turn * at) {
        add(world, edgeBody(turn * Vec2(-5, 0), turn * Vec2(5, 0), depth));
        BodyDef def = dropped(what, start);
        def.angle = 0.4;
        def.velocity = turn * velocity;
        id = add(world, def);
    }

    /// In the coordinates of the edge.
    Vec2 position() const { return turn.inverse() * world.body(id).massCenter; }
    Vec2 velocity() const { return turn.inverse() * world.body(id).velocity; }
    double lowest() const {
        return lowestAlong(world.shapes(id).front(), world.body(id).pose, {0, 0}, turn * Vec2(0, 1));
    }
};

} // namespace

class OneWayTest : public QObject {
    Q_OBJECT

  private slots:
    void anEdgeStopsWhatComesFromTheFront_data() { depthRows(true); }
    void anEdgeStopsWhatComesFromTheFront() {
        QFETCH(QString, what);
        QFETCH(double, depth);
        QFETCH(int, iterations);
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(15, 75)) {
            for (const double speed : {0.5, 5.0, 50.0}) {
                Meeting meeting(what, depth, iterations, degrees, {0.3, 1}, {0, -speed});
                bool touched = false;
                for (int i = 0; i < 200; ++i) {
                    meeting.world.update();
                    touched = touched || !meeting.world.events().began.empty();
                    QVERIFY2(meeting.position().y() > 0 || std::abs(meeting.position().x()) > 5,
                             qPrintable(QString("%1°, %2 m/s, update %3").arg(degrees).arg(speed).arg(i)));
                }
                QVERIFY(touched);
                QVERIFY2(meeting.lowest() > -0.005 || std::abs(meeting.position().x()) > 5,
                         qPrintable(QString("%1°, %2 m/s: %3").arg(degrees).arg(speed).arg(meeting.lowest())));
            }
        }
    }

    void anEdgeLetsPassWhatComesFromBehind_data() { depthRows(false); }
    void anEdgeLetsPassWhatComesFromBehind() {
        QFETCH(QString, what);
        QFETCH(double, depth);
        QFETCH(int, iterations);
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(15, 75)) {
            for (const double speed : {0.2, 0.5, 5.0, 50.0}) {
                Meeting meeting(what, depth, iterations, degrees, {0.3, -depth - 0.6}, {0, speed});
                const Vec2 from = meeting.position();
                const double time = std::ceil((depth + 2) / speed / meeting.world.parameters().seconds);
                for (int i = 0; i < static_cast<int>(time); ++i) {
                    meeting.world.update();
                    QVERIFY2(meeting.world.events().began.empty(),
                             qPrintable(QString("%1°, %2 m/s: touch in update %3").arg(degrees).arg(speed).arg(i)));
                }
                const Vec2 to = from + Vec2(0, time * meeting.world.parameters().seconds * speed);
                QVERIFY2((meeting.position() - to).norm() < 1e-9 &&
                             (meeting.velocity() - Vec2(0, speed)).norm() < 1e-9 * speed,
                         qPrintable(QString("%1°, %2 m/s: at (%3, %4), velocity (%5, %6)")
                                        .arg(degrees)
                                        .arg(speed)
                                        .arg(meeting.position().x())
                                        .arg(meeting.position().y())
                                        .arg(meeting.velocity().x())
                                        .arg(meeting.velocity().y())));
            }
        }
    }

    void whatTurnsBackBeforeItIsThroughIsLetBackToo_data() { depthRows(false); }
    void whatTurnsBackBeforeItIsThroughIsLetBackToo() {
        QFETCH(QString, what);
        QFETCH(double, depth);
        QFETCH(int, iterations);
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(15, 75)) {
            for (const double top : {-depth, -0.5 * depth, 0.0, 0.1}) {
                Meeting meeting(what, depth, iterations, degrees, {0.3, -depth - 0.6}, {0, 1});
                run(meeting.world, depth + 0.6 + top);
                meeting.world.setVelocity(meeting.id, meeting.turn * Vec2(0, -1), 0);
                run(meeting.world, 1.1);
                QVERIFY2(std::abs(meeting.velocity().y() + 1) < 1e-9 && std::abs(meeting.velocity().x()) < 1e-9,
                         qPrintable(QString("%1°, turned at %2: velocity (%3, %4)")
                                        .arg(degrees)
                                        .arg(top)
                                        .arg(meeting.velocity().x())
                                        .arg(meeting.velocity().y())));
            }
        }
    }

    void whatHasPassedAnEdgeFromBehindIsStoppedByItsFront_data() { depthRows(false); }
    void whatHasPassedAnEdgeFromBehindIsStoppedByItsFront() {
        QFETCH(QString, what);
        QFETCH(double, depth);
        QFETCH(int, iterations);
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(15, 75)) {
            for (const double speed : {0.5, 5.0}) {
                Meeting meeting(what, depth, iterations, degrees, {0.3, -depth - 0.6}, {0, speed});
                run(meeting.world, (depth + 1) / speed);
                QVERIFY(meeting.lowest() > 0);
                meeting.world.setVelocity(meeting.id, meeting.turn * Vec2(0, -speed), 0);
                run(meeting.world, 2 / speed);
                QVERIFY2(meeting.lowest() > -0.005,
                         qPrintable(QString("%1°, %2 m/s: lowest %3").arg(degrees).arg(speed).arg(meeting.lowest())));
            }
        }
    }

    void whatComesFromBehindPassesAcrossAJointOfTwoEdges_data() { depthRows(false); }
    void whatComesFromBehindPassesAcrossAJointOfTwoEdges() {
        QFETCH(QString, what);
        QFETCH(double, depth);
        QFETCH(int, iterations);
        for (const double across : {-0.15, -0.05, 0.0, 0.05, 0.15}) {
            World world(withIterations(iterations, {0, 0}));
            add(world, edgeBody({-3, 0}, {0, 0}, depth));
            add(world, edgeBody({0, 0}, {3, 0}, depth));
            BodyDef def = dropped(what, {across, -depth - 0.6});
            def.velocity = {0, 1};
            const BodyId id = add(world, def);
            const double before = world.body(id).massCenter.y();
            for (int i = 0; i < static_cast<int>((depth + 2) / world.parameters().seconds); ++i) {
                world.update();
                QVERIFY2(world.events().began.empty(), qPrintable(QString("at %1: touch").arg(across)));
            }
            QVERIFY(world.body(id).massCenter.y() > before + depth + 1.9);
        }
    }

    void whatIsInsideTheDepthIsPushedOutInFront_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<double>("depth");
        QTest::addColumn<double>("behind");
        QTest::addColumn<int>("iterations");
        for (const char* what : things) {
            for (const double depth : {0.1, 0.5, noBack}) {
                for (const double behind : {0.001, 0.09, 0.3, 0.49, 3.0, 9.0, 30.0}) {
                    for (const int iterations : iterationCounts) {
                        if (behind < depth) {
                            QTest::addRow("%s, %g behind, %s, %d iterations", what, behind, qPrintable(nameOf(depth)),
                                          iterations)
                                << what << depth << behind << iterations;
                        }
                    }
                }
            }
        }
    }
    void whatIsInsideTheDepthIsPushedOutInFront() {
        QFETCH(QString, what);
        QFETCH(double, depth);
        QFETCH(double, behind);
        QFETCH(int, iterations);
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(15, 65)) {
            Meeting meeting(what, depth, iterations, degrees, {0.3, -behind}, {0, 0});
            run(meeting.world, 4);
            const QString where = QString("%1°: lowest point %2, speed %3")
                                      .arg(degrees)
                                      .arg(meeting.lowest())
                                      .arg(meeting.velocity().norm());
            QVERIFY2(meeting.lowest() > -0.005 && std::abs(meeting.position().x() - 0.3) < 0.5, qPrintable(where));
            QVERIFY2(meeting.velocity().norm() < 0.01, qPrintable(where));
        }
    }

    void whatIsDeeperThanTheDepthIsNotTouched_data() { depthRows(false); }
    void whatIsDeeperThanTheDepthIsNotTouched() {
        QFETCH(QString, what);
        QFETCH(double, depth);
        QFETCH(int, iterations);
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(15, 75)) {
            Meeting meeting(what, depth, iterations, degrees, {0.3, -depth - 0.1}, {0, -0.1});
            const Vec2 away = meeting.turn * Vec2(0, -0.1);
            for (int i = 0; i < 50; ++i) {
                meeting.world.update();
                QVERIFY(meeting.world.events().began.empty());
            }
            QCOMPARE(meeting.world.body(meeting.id).velocity.x(), away.x());
            QCOMPARE(meeting.world.body(meeting.id).velocity.y(), away.y());
        }
    }

    void anEdgeWithoutBackStopsWhatIsHoweverDeep_data() { iterationRows(); }
    void anEdgeWithoutBackStopsWhatIsHoweverDeep() {
        QFETCH(int, iterations);
        for (const char* what : things) {
            for (const double behind : {0.1, 1.0, 5.0, 100.0}) {
                for (const double speed : {1.0, 100.0}) {
                    Meeting meeting(what, noBack, iterations, 30, {0, -behind}, {0, -speed});
                    run(meeting.world, behind < 10 ? 4 : 8); // there is a limit to the speed of pushing out
                    QVERIFY2(meeting.lowest() > -0.005, qPrintable(QString("%1 at %2 m/s from %3 behind: %4")
                                                                       .arg(what)
                                                                       .arg(speed)
                                                                       .arg(behind)
                                                                       .arg(meeting.lowest())));
                }
            }
        }
    }

    void anEdgeWithoutBackLeavesAloneWhatIsBesideItsBack_data() { iterationRows(); }
    void anEdgeWithoutBackLeavesAloneWhatIsBesideItsBack() {
        QFETCH(int, iterations);
        for (const char* what : things) {
            for (const double behind : {1.0, 30.0, 1000.0}) {
                for (const double beside : {-6.0, 6.0}) {
                    Meeting meeting(what, noBack, iterations, 30, {beside, -behind}, {0, 0});
                    run(meeting.world, 1);
                    QVERIFY((meeting.position() - Vec2(beside, -behind)).norm() < 1e-6);
                }
            }
        }
    }

    void aRoomWithoutBacksIsLeftByNobodyAndEnteredFromAnyDistance_data() { iterationRows(); }
    void aRoomWithoutBacksIsLeftByNobodyAndEnteredFromAnyDistance() {
        QFETCH(int, iterations);
        // The walls of a twelve-sided room look inward. Behind each corner the backs of two of them leave a gap.
        for (int degrees = 0; degrees < 360; degrees += fullOrQuick(5, 15)) {
            for (const double away : {8.0, 40.0}) {
                World world(withIterations(iterations, {0, 0}));
                const std::vector<Vec2> corners = regularPolygon(12, 6);
                for (std::size_t i = 0; i < corners.size(); ++i) {
                    add(world, edgeBody(corners[i], corners[(i + 1) % corners.size()]));
                }
                const Vec2 out = Rot::fromAngle(degrees * pi / 180).right();
                BodyDef def = ball(away * out, 0.2);
                def.velocity = 10 * out;
                const BodyId id = add(world, def);
                run(world, 5);
                QVERIFY2(
                    world.body(id).massCenter.norm() < 6,
                    qPrintable(
                        QString("%1°, %2 m away: %3").arg(degrees).arg(away).arg(world.body(id).massCenter.norm())));
            }
        }
    }

    void bothFreeEndsStopABall_data() {
        QTest::addColumn<double>("depth");
        QTest::addColumn<bool>("atB");
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("iterations");
        for (const double depth : depths) {
            for (const bool atB : {false, true}) {
                for (const double speed : {0.5, 3.0, 30.0, 300.0}) {
                    for (const int iterations : iterationCounts) {
                        QTest::addRow("%s, end %c, %g m/s, %d iterations", qPrintable(nameOf(depth)), atB ? 'b' : 'a',
                                      speed, iterations)
                            << depth << atB << speed << iterations;
                    }
                }
            }
        }
    }
    void bothFreeEndsStopABall() {
        QFETCH(double, depth);
        QFETCH(bool, atB);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        // Every way in from beyond the end, from a little above the line to below it.
        for (int degrees = -80; degrees <= 80; degrees += fullOrQuick(5, 20)) {
            World world(withIterations(iterations, {0, 0}));
            BodyDef wall = edgeBody({-1, 0}, {1, 0}, depth);
            wall.restitution = 1;
            wall.friction = 0;
            add(world, wall);
            const Vec2 end(atB ? 1 : -1, 0);
            const Vec2 outward = Rot::fromAngle(degrees * pi / 180) * end;
            BodyDef def = ball(end + 1.5 * outward, 0.2);
            def.velocity = -speed * outward;
            def.restitution = 1;
            def.friction = 0;
            const BodyId id = add(world, def);
            run(world, 2.6 / speed + 0.02);
            const Vec2 velocity = world.body(id).velocity;
            QVERIFY2((velocity - speed * outward).norm() < 0.01 * speed,
                     qPrintable(QString("%1°: velocity (%2, %3)").arg(degrees).arg(velocity.x()).arg(velocity.y())));
        }
    }
};

SPACETOW_TEST(OneWayTest)
#include "one_way_test.moc"
