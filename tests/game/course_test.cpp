// Runs that are turned back, edited and gone on with; what a runner shows of them.

#include "core/game/flights.h"
#include "core/game/runner.h"
#include "tests/support/comes_true.h"
#include "tests/support/game_levels.h"
#include "tests/support/live_level.h"
#include "tests/support/test_main.h"

#include <thread>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// After these inputs, each held for so many updates.
Session freshRun(const Level& level, std::initializer_list<std::pair<StepInput, int>> inputs) {
    Session session(level);
    for (const auto& [input, updates] : inputs) {
        stepOn(session, updates, input);
    }
    return session;
}

StepInput keys(const Controls& controls) {
    return {controls, {}, {}};
}

/// A manual runner that has flown thrust for 100 updates.
struct Flown {
    Runner runner;

    explicit Flown(const Level& level = openSpace()) : runner(level, Runner::Mode::Manual) {
        runner.wantSession(true);
        runner.hold(thrust);
        runner.advance(100);
    }
    std::uint64_t hash() const { return runner.frame()->session->hash(); }
    std::shared_ptr<const TimelineSummary> timeline() const { return runner.frame()->timeline; }
};

} // namespace

class CourseTest : public QObject {
    Q_OBJECT

  private slots:
    void aRecordingKnowsHowItEndsWhereverSomebodyLooks() {
        Course course(std::make_shared<const Level>(spaceWithCeiling()), 1);
        for (int i = 0; i < 150; ++i) {
            course.goOn(keys(i < 90 ? thrust : idle));
        }
        const Replay recorded = course.recording();
        QCOMPARE(course.updates(), recorded.updates());
        QVERIFY(recorded.ended == flightResult(spaceWithCeiling(), recorded));
        QCOMPARE(recorded.ended->end, FlightEnd::Lost);
        course.seek(20);
        QVERIFY(course.recording().ended == recorded.ended);
        course.goOn(keys(idle)); // another future
        QCOMPARE(course.recording().ended->end, FlightEnd::UnderWay);
        course.open(recorded);
        QVERIFY(!course.recording().ended); // which is still to be simulated
        course.simulate(1000);
        QVERIFY(course.recording() == recorded);
    }
    void aMomentThatIsSoughtIsShownAndTheGamePauses() {
        Flown flown;
        QCOMPARE(flown.timeline()->last, std::int64_t(100));
        QCOMPARE(flown.timeline()->shown, std::int64_t(100));
        flown.runner.seek(37);
        const std::shared_ptr<const Frame> frame = flown.runner.frame();
        QVERIFY(frame->paused && frame->before == frame->now);
        QCOMPARE(frame->now->update, std::int64_t(37));
        QCOMPARE(frame->timeline->shown, std::int64_t(37));
        QCOMPARE(frame->timeline->last, std::int64_t(100));
        QCOMPARE(flown.hash(), freshRun(openSpace(), {{keys(thrust), 37}}).hash());
        QVERIFY(frame->timeline->paths && frame->timeline->paths->size() == 1);
        flown.runner.advance(5); // in vain
        QCOMPARE(flown.timeline()->shown, std::int64_t(37));
        flown.runner.seek(-5);
        QCOMPARE(flown.timeline()->shown, std::int64_t(0));
        flown.runner.seek(5000);
        QCOMPARE(flown.timeline()->shown, std::int64_t(100));
    }
    void stepsGoBackAndForthAlongTheRunAsItWas() {
        Flown flown;
        flown.runner.hold(left); // is for later
        for (int i = 1; i <= 30; ++i) {
            flown.runner.stepBack();
            QCOMPARE(flown.timeline()->shown, std::int64_t(100 - i));
        }
        for (int i = 0; i < 30; ++i) {
            flown.runner.stepOnce();
        }
        QCOMPARE(flown.hash(), freshRun(openSpace(), {{keys(thrust), 100}}).hash());
        QVERIFY(flown.timeline()->ghosts.empty());
        flown.runner.stepOnce(); // at the end it is new
        QCOMPARE(flown.hash(), freshRun(openSpace(), {{keys(thrust), 100}, {keys(left), 1}}).hash());
        flown.runner.seek(0);
        flown.runner.stepBack();
        QCOMPARE(flown.timeline()->shown, std::int64_t(0));
    }
    void oneGoesOnFromAnyMomentWithNewInputs() {
        Flown flown;
        flown.runner.seek(40);
        flown.runner.hold(right);
        flown.runner.resume();
        flown.runner.advance(20);
        QCOMPARE(flown.timeline()->last, std::int64_t(60));
        const Session fresh = freshRun(openSpace(), {{keys(thrust), 40}, {keys(right), 20}});
        QCOMPARE(flown.hash(), fresh.hash());
        QCOMPARE(flown.timeline()->ghosts.size(), std::size_t(1));
        QCOMPARE(flown.timeline()->ghosts[0]->from, std::int64_t(40));
        const Replay recording = flown.runner.askRecording()().run;
        QCOMPARE(recording.updates(), std::int64_t(60));
        QCOMPARE(replayed(openSpace(), recording).hash, fresh.hash());
    }
    void whatWasTappedBeforeALookBackDoesNotCountAfterIt() {
        Flown flown;
        flown.runner.hold(left);
        flown.runner.hold(thrust); // let go before the next update
        flown.runner.seek(40);
        flown.runner.resume();
        flown.runner.advance(1);
        QCOMPARE(flown.hash(), freshRun(openSpace(), {{keys(thrust), 41}}).hash());
    }
    void theHandPullsInEachIterationThatIsLookedAt() {
        Runner runner(yard(), Runner::Mode::Manual);
        runner.wantSession(true);
        runner.advance(10);
        const Grab grab{boxKey, Vec2(0, 0), Vec2(5, 5)};
        runner.setGrab(grab);
        runner.stepIteration();
        QVERIFY(runner.frame()->session->grabForce().has_value());
        for (int k = 1; k < yard().iterations; ++k) {
            runner.stepIteration();
        }
        QCOMPARE(runner.frame()->session->hash(), freshRun(yard(), {{{}, 10}, {{{}, grab, {}}, 1}}).hash());
    }
    void aRunCanBeWatchedAgainToItsEnd() {
        Flown flown;
        flown.runner.seek(90);
        flown.runner.hold(left);
        flown.runner.watch();
        flown.runner.advance(4);
        QCOMPARE(flown.timeline()->shown, std::int64_t(94));
        QVERIFY(!flown.runner.frame()->paused);
        flown.runner.advance(20);
        QCOMPARE(flown.timeline()->shown, std::int64_t(100));
        QCOMPARE(flown.timeline()->last, std::int64_t(100));
        QVERIFY(flown.runner.frame()->paused);
        QVERIFY(flown.timeline()->ghosts.empty());
        QCOMPARE(flown.hash(), freshRun(openSpace(), {{keys(thrust), 100}}).hash());
    }
    void anUpdateCanBeGoneThroughByIterations() {
        Flown flown;
        const Session before = freshRun(openSpace(), {{keys(thrust), 100}});
        const Session after = freshRun(openSpace(), {{keys(thrust), 101}});
        QCOMPARE(flown.timeline()->iterations, 10);
        double height = before.ship()->massCenter.y();
        for (int k = 1; k < 10; ++k) {
            flown.runner.stepIteration();
            QCOMPARE(flown.timeline()->iteration, k);
            QCOMPARE(flown.timeline()->shown, std::int64_t(100));
            const double now = flown.runner.frame()->session->ship()->massCenter.y();
            QVERIFY(now > height && now < after.ship()->massCenter.y());
            height = now;
        }
        flown.runner.stepIteration();
        QCOMPARE(flown.timeline()->iteration, 0);
        QCOMPARE(flown.timeline()->shown, std::int64_t(101));
        QCOMPARE(flown.hash(), after.hash());

        Session whole = before, partly = before; // all iterations are the update
        whole.step(thrust);
        partly.stepPartly(keys(thrust), 10);
        QCOMPARE(partly.hash(), whole.hash());

        flown.runner.seek(50); // in the past it is the update as it was
        flown.runner.hold(left);
        flown.runner.stepIteration();
        QCOMPARE(flown.timeline()->iteration, 1);
        flown.runner.stepBack(); // out of it, and back
        QCOMPARE(flown.timeline()->iteration, 0);
        QCOMPARE(flown.hash(), freshRun(openSpace(), {{keys(thrust), 49}}).hash());
        for (int k = 0; k < 10; ++k) {
            flown.runner.stepIteration();
        }
        QCOMPARE(flown.hash(), freshRun(openSpace(), {{keys(thrust), 50}}).hash());
        QCOMPARE(flown.timeline()->last, std::int64_t(101));
    }
    void anEditInThePastChangesWhatComes() {
        Flown flown;
        flown.runner.seek(40);
        Level pulling = openSpace();
        pulling.gravity = Vec2(1, 0);
        flown.runner.setLevel(std::make_shared<const Level>(pulling));
        QCOMPARE(flown.timeline()->shown, std::int64_t(40));
        QCOMPARE(flown.timeline()->last, std::int64_t(100));
        QCOMPARE(flown.timeline()->ghosts.size(), std::size_t(1));
        pulling.gravity = Vec2(-1, 0); // another edit at the same moment: the ghost is that of the run before
        const auto other = std::make_shared<const Level>(pulling);
        flown.runner.setLevel(other);
        QCOMPARE(flown.timeline()->ghosts.size(), std::size_t(1));
        QVERIFY(std::abs(flown.timeline()->ghosts[0]->paths[0].points.back().x()) < 1e-9);
        QVERIFY(flown.timeline()->paths->front().points.back().x() < -0.5);
        QCOMPARE(flown.timeline()->marks.back().kind, MarkKind::Edit);
        flown.runner.seek(100);
        StepInput first = keys(thrust);
        first.level = other;
        QCOMPARE(flown.hash(), freshRun(openSpace(), {{keys(thrust), 40}, {first, 1}, {keys(thrust), 59}}).hash());
        QCOMPARE(replayed(openSpace(), flown.runner.askRecording()().run).hash, flown.hash());
        flown.runner.resume();
        flown.runner.advance(1);
        QCOMPARE(flown.timeline()->last, std::int64_t(101));
    }
    void whoGoesOnFromThePastHasTheLevelAsItIsNow() {
        Flown flown;
        Level pulling = openSpace();
        pulling.gravity = Vec2(1, 0);
        flown.runner.setLevel(std::make_shared<const Level>(pulling));
        flown.runner.advance(10);
        flown.runner.seek(40);
        QVERIFY(flown.runner.frame()->session->level().gravity == Vec2(0, 0));
        flown.runner.resume();
        flown.runner.advance(5);
        QVERIFY(flown.runner.frame()->session->level().gravity == Vec2(1, 0));
        QCOMPARE(replayed(openSpace(), flown.runner.askRecording()().run).hash, flown.hash());
    }
    void whoHasLookedElsewhereComparesWithTheRunAsItIsNow() {
        Flown flown;
        Level pulling = openSpace();
        for (const double pull : {1.0, -1.0}) {
            flown.runner.seek(60);
            flown.runner.seek(40);
            pulling.gravity = Vec2(pull, 0);
            flown.runner.setLevel(std::make_shared<const Level>(pulling));
        }
        QCOMPARE(flown.timeline()->ghosts.size(), std::size_t(2));
        QVERIFY(flown.timeline()->ghosts[1]->paths[0].points.back().x() > 0.5); // pulled to the right
    }
    void anEditWaitsForTheFirstIterationOfTheNextUpdate() {
        Flown flown;
        flown.runner.pause();
        Level pulling = openSpace();
        pulling.gravity = Vec2(1, 0);
        flown.runner.setLevel(std::make_shared<const Level>(pulling));
        flown.runner.stepIteration();
        QCOMPARE(flown.timeline()->iteration, 1);
        QVERIFY(flown.runner.frame()->session->level() == pulling);
        QVERIFY(flown.runner.frame()->session->ship()->velocity.x() > 0);
    }
    void aRecordedRunKeepsItsOwnEditsToTheEnd() {
        Flown flown;
        Level pulling = openSpace();
        pulling.gravity = Vec2(1, 0);
        flown.runner.setLevel(std::make_shared<const Level>(pulling));
        flown.runner.advance(20);
        const Replay recording = flown.runner.askRecording()().run;
        Runner runner(openSpace(), Runner::Mode::Manual);
        runner.wantSession(true);
        runner.advance(3);
        runner.setLevel(std::make_shared<const Level>(openSpace())); // of the run before
        runner.open(recording);
        runner.seek(120);
        runner.resume();
        runner.advance(1);
        QVERIFY(runner.frame()->session->level().gravity == Vec2(1, 0));
    }
    void aPausedEditAtTheEndIsStillThereAfterALookBack() {
        Flown flown;
        flown.runner.pause();
        flown.runner.setLevel(without(openSpace(), payloadKey));
        QVERIFY(!flown.runner.frame()->session->payload());
        flown.runner.seek(50);
        QVERIFY(flown.runner.frame()->session->payload());
        flown.runner.seek(100);
        QVERIFY(!flown.runner.frame()->session->payload());
        QVERIFY(flown.timeline()->ghosts.empty());
    }
    void handsAreRecorded() {
        Runner runner(yard(), Runner::Mode::Manual);
        runner.wantSession(true);
        runner.advance(10);
        for (int i = 0; i < 40; ++i) {
            runner.setGrab(Grab{boxKey, Vec2(0.1, 0), Vec2(0.05 * i, 4)});
            runner.advance();
        }
        runner.setGrab({});
        runner.setLevel(without(yard(), floorKey));
        runner.advance(30);
        const Replay recording = runner.askRecording()().run;
        QCOMPARE(recording.holds.size(), std::size_t(41));
        QCOMPARE(recording.edits.size(), std::size_t(1));
        QCOMPARE(replayed(yard(), recording).hash, runner.frame()->session->hash());
        runner.seek(30);
        QVERIFY(runner.frame()->session->grabForce().has_value());
        Runner again(yard(), Runner::Mode::Manual);
        again.wantSession(true);
        again.follow(recording);
        again.advance(80);
        QCOMPARE(again.frame()->session->hash(), replayed(yard(), recording).hash);
    }
    void aRecordedRunIsOpenedAsAWhole() {
        Flown flown(spaceWithCeiling());
        const Replay recording = flown.runner.askRecording()().run;
        Runner runner(spaceWithCeiling(), Runner::Mode::Manual);
        runner.advance(7);
        runner.wantSession(true);
        runner.open(recording);
        QVERIFY(runner.frame()->paused);
        QCOMPARE(runner.frame()->timeline->shown, std::int64_t(0));
        QCOMPARE(runner.frame()->timeline->last, std::int64_t(100));
        QCOMPARE(runner.frame()->timeline->goal, std::int64_t(100));
        QCOMPARE(runner.frame()->timeline->marks.front().kind, MarkKind::Crash);
        runner.seek(100);
        QCOMPARE(runner.frame()->session->hash(), flown.hash());
        QVERIFY(runner.askRecording()().run == recording);
        runner.restart();
        QCOMPARE(runner.frame()->timeline->last, std::int64_t(0));
    }
    void aLongRunIsSimulatedBesideAndCanBeStoppedAndLookedAtMeanwhile() {
        Level level = yard();
        level.iterations = 50;
        Replay recording;
        recording.runs = {{idle, 6000}}; // two minutes: longer than what is kept of a run that is played
        Runner runner(level);
        runner.wantSession(true);
        runner.open(recording);
        QVERIFY(comesTrue([&] { return runner.frame()->timeline->last > 200; }));
        runner.seek(150);
        QVERIFY(comesTrue([&] { return runner.frame()->timeline->shown == 150; }));
        QCOMPARE(runner.frame()->session->hash(), freshRun(level, {{keys(idle), 150}}).hash());
        runner.seek(5999);
        QVERIFY(comesTrue([&] { return runner.frame()->timeline->shown == 5999; }));
        QVERIFY(comesTrue([&] { return runner.frame()->timeline->last == 6000; }));
        QCOMPARE(runner.frame()->timeline->first, std::int64_t(0));
        Level slow = level; // so that its future is not done before it can be stopped
        slow.iterations = 1000;
        slow.sleeping = false;
        runner.seek(3000);
        runner.setLevel(std::make_shared<const Level>(slow));
        runner.stopSimulating();
        QVERIFY(comesTrue([&] {
            const std::shared_ptr<const TimelineSummary> timeline = runner.frame()->timeline;
            return timeline->shown == 3000 && timeline->goal == timeline->last && timeline->last < 6000;
        }));
        runner.resume();
        QVERIFY(comesTrue([&] {
            const std::shared_ptr<const TimelineSummary> timeline = runner.frame()->timeline;
            return timeline->shown > 3002 && timeline->shown == timeline->last;
        }));
        QCOMPARE(runner.frame()->session->level().iterations, 1000);
    }
    void aStepThatIsNotPausedFirstIsOneUpdateMore() {
        Flown flown;
        flown.runner.stepOnce();
        QVERIFY(!flown.runner.frame()->paused);
        QCOMPARE(flown.timeline()->last, std::int64_t(101));
    }
};

SPACETOW_TEST(CourseTest)
#include "course_test.moc"
