// A runner whose level is edited, and whose bodies are held, while it runs.

#include "core/game/runner.h"
#include "tests/support/comes_true.h"
#include "tests/support/live_level.h"
#include "tests/support/test_main.h"

#include <thread>

using namespace spacetow;
using namespace spacetow::test;

class LiveRunnerTest : public QObject {
    Q_OBJECT

  private slots:
    void framesHaveTheSessionWhenItIsWanted() {
        Runner runner(yard(), Runner::Mode::Manual);
        runner.advance(3);
        QVERIFY(!runner.frame()->session);
        runner.wantSession(true);
        QVERIFY(runner.frame()->session); // at once
        QCOMPARE(runner.frame()->session->updates(), std::int64_t(3));
        const std::shared_ptr<const Session> kept = runner.frame()->session;
        runner.advance(10);
        QCOMPARE(kept->updates(), std::int64_t(3));
        QCOMPARE(runner.frame()->session->updates(), std::int64_t(13));
        Session fresh(yard());
        stepOn(fresh, 13);
        QCOMPARE(runner.frame()->session->hash(), fresh.hash());
        runner.wantSession(false);
        runner.advance();
        QVERIFY(!runner.frame()->session);
    }
    void aDeferredRunnerDoesWhatItWasToldBeforeItsSessionIsThere() {
        Runner runner(yard(), Runner::Mode::Deferred);
        runner.pause();
        runner.wantSession(true);
        runner.stepOnce();
        runner.stepOnce();
        QVERIFY(comesTrue([&] { return runner.frame() && runner.frame()->now->update == 2; }));
        Session fresh(yard());
        stepOn(fresh, 2);
        QVERIFY(comesTrue([&] { return runner.frame()->session && runner.frame()->session->updates() == 2; }));
        QCOMPARE(runner.frame()->session->hash(), fresh.hash());
        QVERIFY(runner.frame()->paused);
        QCOMPARE(runner.askRecording()().start->objects.size(), yard().objects.size());
    }
    void whatIsHeldIsPulledUntilItIsLetGo() {
        Runner runner(yard(), Runner::Mode::Manual);
        runner.wantSession(true);
        runner.setGrab(Grab{boxKey, Vec2(0, 0), Vec2(0, 6)});
        runner.advance(100);
        QVERIFY(stateOf(*runner.frame()->session, boxKey).pose.position.y() > 5);
        QVERIFY(runner.frame()->session->grabForce().has_value());
        runner.setGrab({});
        runner.advance(200);
        QVERIFY(stateOf(*runner.frame()->session, boxKey).pose.position.y() < 1);
        QVERIFY(!runner.frame()->session->grabForce());
    }
    void anEditIsSeenAtOnceThoughTheGameIsPaused() {
        Runner runner(yard(), Runner::Mode::Manual);
        runner.wantSession(true);
        runner.advance(10);
        runner.pause();
        const double height = stateOf(*runner.frame()->session, ballKey).pose.position.y();
        const auto higher = [&](double by) {
            return edited<BodyObject>(yard(), ballKey, [by](BodyObject& ball) { ball.position.y() += by; });
        };
        runner.setLevel(higher(1));
        runner.setLevel(higher(4));
        QVERIFY(std::abs(stateOf(*runner.frame()->session, ballKey).pose.position.y() - height - 4) < 1e-9);
        QCOMPARE(runner.frame()->now->bodies(), std::size_t(3));
        runner.resume();
        runner.advance();
        Session fresh(yard());
        stepOn(fresh, 10);
        fresh.step(withLevel(higher(4)));
        QCOMPARE(runner.frame()->session->hash(), fresh.hash());
    }
    void aRestartBeginsWithTheEditedLevel() {
        Runner runner(yard(), Runner::Mode::Manual, 9);
        runner.wantSession(true);
        runner.advance(10);
        const auto after = without(yard(), ballKey);
        runner.setLevel(after);
        runner.restart();
        QVERIFY(runner.frame()->session->hash() == Session(after, 9).hash());
        runner.advance(5);
        runner.setLevel(std::make_shared<const Level>(yard()));
        runner.advance(5);
        runner.restart();
        QVERIFY(runner.frame()->session->hash() == Session(yard(), 9).hash());
    }
    void slowMotionSpreadsTheUpdatesOverTime() {
        Runner runner(yard(), Runner::Mode::Manual);
        QCOMPARE(runner.frame()->period, 0.02);
        runner.setSpeed(0.25);
        QCOMPARE(runner.frame()->period, 0.08);
        QCOMPARE(runner.frame()->speed, 0.25);
        runner.setSpeed(100);
        QCOMPARE(runner.frame()->speed, Runner::fastest);
        runner.setSpeed(std::nan(""));
        QCOMPARE(runner.frame()->speed, Runner::slowest);
        runner.restart();
        QCOMPARE(runner.frame()->speed, Runner::slowest); // restarting does not touch it
        QCOMPARE(runner.frame()->period, 0.32);
        Level quick = yard();
        quick.updateSeconds = 0.01;
        runner.setLevel(std::make_shared<const Level>(quick));
        runner.advance();
        QCOMPARE(runner.frame()->period, 0.16);
    }
    void allOfItReachesTheThread() {
        Runner runner(yard());
        runner.wantSession(true);
        runner.setSpeed(8);
        runner.setGrab(Grab{boxKey, Vec2(0, 0), Vec2(0, 6)});
        QVERIFY(comesTrue([&] {
            const std::shared_ptr<const Session> session = runner.frame()->session;
            return session && stateOf(*session, boxKey).pose.position.y() > 5;
        }));
        runner.setLevel(without(yard(), ballKey));
        QVERIFY(comesTrue([&] { return !runner.frame()->session->bodyOf(ballKey); }));
        runner.pause();
        QVERIFY(comesTrue([&] { return runner.frame()->paused; }));
        QCOMPARE(runner.frame()->session->updates(), runner.frame()->now->update);
    }
};

SPACETOW_TEST(LiveRunnerTest)
#include "live_runner_test.moc"
