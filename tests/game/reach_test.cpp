#include "core/game/reach.h"

#include "tests/support/cpu_time.h"
#include "tests/support/full_run.h"
#include "tests/support/game_levels.h"
#include "tests/support/reach_runs.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

double highest(const std::vector<Vec2>& outline) {
    double top = outline.front().y();
    for (const Vec2& point : outline) {
        top = std::max(top, point.y());
    }
    return top;
}

} // namespace

class ReachTest : public QObject {
    Q_OBJECT

  private slots:
    void whateverIsSteeredEndsWithin() {
        const int runs = fullOrQuick(10'000, usualOrThin(400, 40));
        int within = 0;
        QString first;
        for (int run = 0; run < runs; ++run) {
            const bool inside = endsWithinItsReach(static_cast<std::uint64_t>(run) + 1);
            within += inside ? 1 : 0;
            first = inside || !first.isEmpty() ? first : seedText(static_cast<std::uint64_t>(run) + 1);
        }
        qInfo("%d of %d flights end within their outline", within, runs);
        QVERIFY2(within >= 0.99 * runs, qPrintable(first));
    }

    void theOutlineIsNoWiderThanTheShipCanFly() {
        Session session(reachSpace());
        const ReachOutline outline = reachOutlines(session, {2.0}).front();
        const double start = session.ship()->massCenter.y();
        hold(session, thrust, 100);
        const double flown = session.ship()->massCenter.y() - start;
        QVERIFY(flown > 1);
        QVERIFY2(highest(outline.ship) - start < 1.01 * flown, qPrintable(QString::number(highest(outline.ship))));
    }

    void onTheRopeItIsNotMuchWider() {
        Session session = onTheRope();
        const ReachOutline outline = reachOutlines(session, {1.0}).front();
        Session up = session;
        hold(up, thrust, 50);
        QVERIFY(highest(outline.ship) - up.ship()->massCenter.y() < 0.5);
        QVERIFY(highest(outline.payload) - up.payload()->massCenter.y() < 1);
    }

    void whoWaitsCanStillBeAtTheStartThoughTheShipWouldFallFasterThanItFlies() {
        Level level = reachSpace();
        level.gravity = Vec2(0, -30);
        const Session session(level);
        for (const ReachOutline& outline : reachOutlines(session, {0.5, 2})) {
            QVERIFY(isWithin(outline.ship, session.ship()->massCenter));
        }
    }

    void laterOutlinesAreLargerAndThoseOfAWaitingShipHoldItsStart() {
        const Session session(reachSpace());
        const std::vector<ReachOutline> outlines = reachOutlines(session, {0.5, 1, 1.5, 2});
        QCOMPARE(outlines.size(), std::size_t(4));
        for (const ReachOutline& outline : outlines) {
            QVERIFY(isWithin(outline.ship, session.ship()->massCenter));
            for (const Vec2& point : outlines.front().ship) {
                QVERIFY(isWithin(outline.ship, point));
            }
        }
    }

    void thePathWithTheKeysHeldIsTheOneThatIsFlown() {
        Random random(5);
        Session session = onTheRope();
        steerAtRandom(session, random, 40);
        const Controls keys{.left = true, .thrust = true};
        const HeldPath path = heldPath(session, keys, 1);
        QCOMPARE(path.ship.size(), std::size_t(51));
        QCOMPARE(path.payload.size(), std::size_t(51));
        QVERIFY(!path.ends);
        for (std::size_t i = 0; i < path.ship.size(); ++i) {
            QVERIFY(path.ship[i] == session.ship()->massCenter);
            QVERIFY(path.payload[i] == session.payload()->massCenter);
            session.step(keys);
        }
    }

    void aPathThatCrashesEndsThere() {
        Session session(spaceWithCeiling());
        session.step(thrust);
        const HeldPath path = heldPath(session, thrust, 5);
        QVERIFY(path.ends && path.ship.size() > 2 && path.ship.size() < 250);
        QVERIFY(path.ship.back().y() < 1);
    }

    void whatNobodySteersHasNoReach() {
        Session session(spaceWithCeiling());
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        QVERIFY(reachOutlines(session, {1}).empty() && heldPath(session, thrust, 1).ship.empty());
        QVERIFY(reachOutlines(Session(Level()), {1}).empty());
    }

    void theFanTakesLittleTime() {
        const Session session = onTheRope();
        double best = 1;
        for (int i = 0; i < 5; ++i) {
            const CpuTimer timer;
            QCOMPARE(reachOutlines(session, {1, 2, 3, 4, 5}).size(), std::size_t(5));
            best = std::min(best, timer.seconds());
        }
        qInfo("the outlines of five seconds take %.2f ms", 1000 * best);
        QVERIFY(isSanitized || best < 0.016);
    }
};

SPACETOW_TEST(ReachTest)
#include "reach_test.moc"
