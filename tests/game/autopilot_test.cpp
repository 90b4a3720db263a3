#include "core/game/autopilot.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level openSky() {
    Level level = openSpaceWithPayloadAt(Vec2(0, -1.2));
    level.gravity = Vec2(0, -0.95);
    level.objects.erase(2); // no finish to end the flight
    return level;
}

double distance(const Vec2& a, const Vec2& b) {
    return (a - b).norm();
}

} // namespace

class AutopilotTest : public QObject {
    Q_OBJECT

  private slots:
    void hoversWhereItStarted() {
        Session session(openSky());
        Autopilot pilot({{{Vec2(0, 0.3), 0.5}}, {}});
        double farthest = 0;
        for (int i = 0; i < 1500; ++i) {
            Controls controls = pilot.next(session);
            controls.tow = false;
            session.step(controls);
            if (i > 500) {
                farthest = std::max(farthest, distance(session.ship()->massCenter, Vec2(0, 0.3)));
            }
        }
        QCOMPARE(session.phase(), Phase::Flying);
        QVERIFY2(farthest < 0.1, qPrintable(QString::number(farthest)));
    }
    void reachesRandomWaypointsAlongTheRoute() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Random random(seed);
            FlightPlan plan;
            Vec2 at(0, 0);
            for (int i = 0; i < 5; ++i) {
                at += Vec2(random.uniform(-3, 3), random.uniform(-2, 3));
                plan.toPayload.push_back({at, random.uniform(0.4, 1)});
            }
            Level level = openSky();
            level.objects.erase(1); // nothing to run into
            Session session(level);
            Autopilot pilot(plan);
            std::size_t reached = 0;
            double nearest = 1e9;
            for (int i = 0; i < 6000 && reached < plan.toPayload.size(); ++i) {
                session.step(pilot.next(session));
                const double now = distance(session.ship()->massCenter, plan.toPayload[reached].position);
                nearest = std::min(nearest, now);
                reached += now < 0.5 ? 1u : 0u;
            }
            QVERIFY2(reached == plan.toPayload.size(), qPrintable(QString("seed %1").arg(seed)));
        }
    }
    void takesThePayloadInTowAndCarriesItWithoutLettingItSwingWildly() {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            Random random(seed);
            const Vec2 goal(random.uniform(-6, 6), random.uniform(1, 5));
            Session session(openSky());
            Autopilot pilot({{{Vec2(0, 0.05), 0.5}}, {{Vec2(0, 0.5), 0.4}, {goal, 0.6}}});
            double widest = 0;
            for (int i = 0; i < 4000; ++i) {
                session.step(pilot.next(session));
                if (session.phase() == Phase::Towing) {
                    const Vec2 rope = session.payload()->massCenter - session.ship()->massCenter;
                    widest = std::max(widest, std::abs(std::atan2(rope.x(), -rope.y())));
                }
            }
            const QByteArray name = QString("seed %1").arg(seed).toUtf8();
            QVERIFY2(session.phase() == Phase::Towing, name);
            QVERIFY2(widest < 1.0, name);
            QVERIFY2(distance(session.ship()->massCenter, goal) < 0.25, name);
        }
    }
    void withoutAPlanItStaysWhereItIs() {
        Session session(openSky());
        Autopilot pilot({});
        for (int i = 0; i < 800; ++i) {
            Controls controls = pilot.next(session);
            controls.tow = false;
            session.step(controls);
        }
        QVERIFY(distance(session.ship()->massCenter, Vec2(0, 0)) < 0.5);
    }
    void leavesTheKeysAloneWhereThereIsNothingToFly() {
        Session sandbox{Level{}};
        Autopilot pilot({{{Vec2(1, 1), 1}}, {}});
        for (int i = 0; i < 10; ++i) {
            const Controls controls = pilot.next(sandbox);
            QVERIFY(controls == idle);
            sandbox.step(controls);
        }
    }
};

SPACETOW_TEST(AutopilotTest)
#include "autopilot_test.moc"
