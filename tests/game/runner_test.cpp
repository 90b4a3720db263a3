#include "core/game/runner.h"
#include "tests/support/comes_true.h"
#include "tests/support/full_run.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

#include <fstream>
#include <thread>

#ifdef __linux__
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level ballsAtOnePoint(int count) {
    Level level;
    for (int i = 0; i < count; ++i) {
        Object ball;
        ball.key = static_cast<Key>(i + 1);
        ball.data = BodyObject{.kind = BodyKind::Dynamic, .shapes = {Circle{{0, 0}, 0.5}}};
        level.objects.append(ball);
    }
    return level;
}

} // namespace

class RunnerTest : public QObject {
    Q_OBJECT

  private slots:
    void aManualRunnerMovesWhenToldOnly() {
        Runner runner(openSpace(), Runner::Mode::Manual);
        QCOMPARE(runner.frame()->now->update, std::int64_t(0));
        QVERIFY(runner.frame()->before == runner.frame()->now);
        runner.advance(3);
        QCOMPARE(runner.frame()->now->update, std::int64_t(3));
        QCOMPARE(runner.frame()->before->update, std::int64_t(2));
        runner.pause();
        runner.advance(5);
        QVERIFY(runner.frame()->paused);
        QCOMPARE(runner.frame()->now->update, std::int64_t(3));
        runner.stepOnce();
        QCOMPARE(runner.frame()->now->update, std::int64_t(4));
        runner.resume();
        runner.advance(1);
        QCOMPARE(runner.frame()->now->update, std::int64_t(5));
        QVERIFY(!runner.frame()->paused);
    }
    void aKeyThatIsLetGoBeforeTheUpdateStillCounts() {
        Runner runner(openSpace(), Runner::Mode::Manual);
        runner.hold(right);
        runner.hold(idle);
        runner.advance(1);
        QCOMPARE(runner.frame()->now->phase, Phase::Flying);
        QVERIFY(runner.frame()->now->controls == right);
        runner.advance(1);
        QVERIFY(runner.frame()->now->controls == idle);
    }
    void aKeyThatIsHeldWhenAStepIsAskedForCountsInIt() {
        Level level = openSpace();
        for (int i = 0; i < 3000; ++i) { // the runner has much to do before it comes to the steps
            addWall(level, Vec2(i, 100), Vec2(i + 1, 100));
        }
        Runner runner(level, Runner::Mode::Deferred);
        runner.pause();
        runner.hold(right);
        runner.stepOnce();
        runner.stepOnce(); // still held, and let go at once
        runner.hold(idle);
        runner.stepOnce();
        QVERIFY(comesTrue([&] { return runner.frame() && runner.frame()->now->update == 3; }));
        QVERIFY(runner.askRecording()().run.runs == (std::vector<Replay::Run>{{right, 2}, {idle, 1}}));
    }
    void nobodyWaitsToAskForTheRecordingAndItIsThereWhenTheRunIsGone() {
        Level level = openSpace();
        for (int i = 0; i < 3000; ++i) {
            addWall(level, Vec2(i, 100), Vec2(i + 1, 100));
        }
        auto runner = std::make_unique<Runner>(level, Runner::Mode::Deferred);
        runner->pause();
        runner->hold(right);
        runner->stepOnce();
        const std::function<Recording()> answer = runner->askRecording(); // it is still being built
        runner->stepOnce();
        runner.reset();
        const Recording recorded = answer();
        QVERIFY(recorded.run.runs == (std::vector<Replay::Run>{{right, 1}}));
        QVERIFY(recorded.start && recorded.start->objects.size() == level.objects.size());
        QVERIFY(recorded.updates == 1 && recorded.isWhole());
    }
    void theRecordingFliesTheSameGame() {
        Level level = openSpace();
        addWall(level, Vec2(3, 1), Vec2(-3, 1));
        Runner runner(level, Runner::Mode::Manual, 21);
        for (int i = 0; i < 300; ++i) {
            runner.hold({.left = i % 50 < 4, .thrust = i % 3 != 0, .tow = i % 7 == 0});
            runner.advance();
        }
        const Replay recording = runner.askRecording()().run;
        QCOMPARE(recording.updates(), std::int64_t(300));
        Session session(level, recording.seed);
        for (const Replay::Run& run : recording.runs) {
            hold(session, run.controls, static_cast<int>(run.count));
        }
        const std::shared_ptr<const Frame> frame = runner.frame();
        const auto again = session.snapshot();
        QCOMPARE(again->moving.size(), frame->now->moving.size());
        QCOMPARE(again->phase, frame->now->phase);
        for (std::size_t i = 0; i < again->moving.size(); ++i) {
            QVERIFY(again->moving[i].pose.position == frame->now->moving[i].pose.position);
        }
    }
    void aRecordingThatIsFollowedIsFlownAgainAndThenThePlayerIsAtTheHelm() {
        Runner recorded(openSpace(), Runner::Mode::Manual, 21);
        for (int i = 0; i < 100; ++i) {
            recorded.hold({.left = i % 50 < 4, .thrust = i % 3 != 0});
            recorded.advance();
        }
        Runner again(openSpace(), Runner::Mode::Manual, 21);
        again.advance(7);
        again.follow(recorded.askRecording()().run.runs);
        QCOMPARE(again.frame()->now->update, std::int64_t(0));
        again.hold(right); // counts for nothing yet
        again.advance(100);
        QVERIFY(again.askRecording()().run == recorded.askRecording()().run);
        const auto bodies = [](Runner& runner) { return runner.frame()->now->moving; };
        for (std::size_t i = 0; i < bodies(recorded).size(); ++i) {
            QVERIFY(bodies(again)[i].pose.position == bodies(recorded)[i].pose.position);
        }
        again.advance(1);
        QVERIFY(again.frame()->now->controls == right);
        again.restart();
        again.advance(100);
        QVERIFY(again.askRecording()().run == recorded.askRecording()().run);
    }
    void restartingBeginsAgainWithAnEmptyRecording() {
        Runner runner(openSpace(), Runner::Mode::Manual);
        runner.hold(thrust);
        runner.advance(50);
        runner.restart();
        QCOMPARE(runner.frame()->now->update, std::int64_t(0));
        QVERIFY(runner.frame()->before == runner.frame()->now);
        QCOMPARE(runner.askRecording()().run.updates(), std::int64_t(0));
        QCOMPARE(runner.frame()->now->phase, Phase::AwaitingInput);
    }
    void soundsAreCollectedUntilTheyAreTaken() {
        Runner runner(openSpace(), Runner::Mode::Manual);
        runner.hold(thrust);
        runner.advance(3);
        const auto start = static_cast<std::uint32_t>(Sound::Start),
                   flame = static_cast<std::uint32_t>(Sound::Thruster);
        QCOMPARE(runner.takeSounds(), start | flame);
        QCOMPARE(runner.takeSounds(), 0u);
    }
    void aThreadedRunnerKeepsPaceWithTheClock() {
        const auto begin = std::chrono::steady_clock::now(); // before the thread can have begun
        Runner runner(openSpace());
        QVERIFY(comesTrue([&] { return runner.frame()->now->update >= 25; }));
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        // Never ahead of the clock; how far behind depends on what else the machine does.
        QVERIFY(passed.count() > 24 * 0.02);
    }
    void pausingAndSteppingReachTheThread() {
        Runner runner(openSpace());
        runner.pause();
        QVERIFY(comesTrue([&] { return runner.frame()->paused; }));
        const std::int64_t at = runner.frame()->now->update;
        for (int i = 1; i <= 20; ++i) {
            runner.stepOnce();
            QVERIFY(comesTrue([&] { return runner.frame()->now->update == at + i; }));
        }
        QCOMPARE(runner.askRecording()().run.updates(), at + 20); // nothing moved by itself meanwhile
        runner.resume();
        QVERIFY(comesTrue([&] { return runner.frame()->now->update > at + 22; }));
    }
    void keysReachTheThread() {
        Runner runner(openSpace());
        runner.hold(thrust);
        runner.hold(idle);
        QVERIFY(comesTrue([&] { return runner.frame()->now->phase == Phase::Flying; }));
        runner.restart();
        QVERIFY(comesTrue([&] { return runner.frame()->now->phase == Phase::AwaitingInput; }));
    }
    void whatMovesWaitsWithTheShipForItsPilot() {
        Level level = openSpace();
        BodyObject platform{.kind = BodyKind::Kinematic, .shapes = {Circle{{0, 0}, 0.3}}, .velocity = {1, 0}};
        platform.position = Vec2(3, 3);
        level.objects.append({900, {}, platform, {}});
        for (const bool moves : {true, false}) {
            Runner runner(moves ? level : openSpace());
            runner.waitForPilot(true);
            if (!moves) {
                QVERIFY(comesTrue([&] { return runner.frame()->now->update > 1; })); // nobody would see it
                continue;
            }
            QVERIFY(comesTrue([&] { return runner.frame()->paused; }));
            QCOMPARE(runner.frame()->now->update, std::int64_t(0));
            runner.stepOnce();
            QVERIFY(comesTrue([&] { return runner.frame()->now->update == 1; }));
            runner.hold(thrust);
            runner.hold(idle);
            QVERIFY(comesTrue([&] { return runner.frame()->now->update > 5; }));
            QVERIFY(runner.frame()->now->phase == Phase::Flying && !runner.frame()->paused);
            runner.restart();
            QVERIFY(comesTrue([&] { return runner.frame()->paused && runner.frame()->now->update == 0; }));
        }
    }
    /// Copies of it take a while.
    static Level manyBalls() {
        Level level = openSpace();
        BodyObject platform{.kind = BodyKind::Kinematic, .shapes = {Circle{{0, 0}, 0.3}}, .velocity = {1, 0}};
        for (int i = 0; i < 2000; ++i) {
            platform.position = Vec2(10 + i, 10);
            level.objects.append({static_cast<Key>(900 + i), {}, platform, {}});
        }
        return level;
    }
    void theSessionOfAGameThatWaitsForItsPilotIsThatOfNow() {
        const Level level = manyBalls();
        Runner runner(level);
        runner.waitForPilot(true);
        runner.wantSession(true);
        for (int i = 1; i <= 10; ++i) {
            QVERIFY(comesTrue([&] { return runner.frame()->paused && runner.frame()->session; }));
            Level edited = level;
            edited.gravity.x() = i;
            runner.setLevel(std::make_shared<const Level>(edited));
            QVERIFY(comesTrue([&] {
                const std::shared_ptr<const Frame> frame = runner.frame();
                return frame->paused && frame->session && frame->ofSession == frame->now &&
                       frame->session->level().gravity.x() == i;
            }));
        }
    }
    void aSessionThatIsGivenBackWhileTheGameIsPausedIsFreed() {
        const auto level = std::make_shared<const Level>(manyBalls());
        Runner runner(level);
        runner.pause();
        QVERIFY(comesTrue([&] { return runner.frame()->paused; }));
        const long users = level.use_count();
        runner.wantSession(true);
        QVERIFY(comesTrue([&] { return runner.frame()->session != nullptr; }));
        QVERIFY(level.use_count() > users);
        std::shared_ptr<const Frame> last = runner.frame();
        runner.wantSession(false);
        QVERIFY(comesTrue([&] { return runner.frame()->session == nullptr; }));
        last.reset();
        QVERIFY(comesTrue([&] { return level.use_count() == users; }));
    }
    void aGameThatNobodyLooksAtWaits() {
        Runner runner(openSpace());
        runner.hold(thrust);
        runner.attend();
        QVERIFY(comesTrue([&] { return runner.frame()->now->update > 0; }));
        QVERIFY(comesTrue([&] { return runner.frame()->paused; })); // half a second later
        const std::int64_t at = runner.frame()->now->update;
        QVERIFY(at < 200);
        QVERIFY(comesTrue([&] {
            runner.attend();
            return runner.frame()->now->update > at + 1;
        }));
        QVERIFY(!runner.frame()->paused);
    }
    void bodiesInOnePlaceEndTheGameBeforeTheyFillTheMemory() {
        for (const Runner::Mode mode : {Runner::Mode::Manual, Runner::Mode::Threaded}) {
            Runner runner(ballsAtOnePoint(2500), mode);
            if (mode == Runner::Mode::Manual) {
                runner.advance(3);
            }
            QVERIFY(comesTrue([&] { return runner.fault() != RunnerFault::None; }));
            QVERIFY(runner.fault() == RunnerFault::Crowd);
            QCOMPARE(runner.frame()->now->update, std::int64_t(0));
            runner.hold(thrust); // in vain, but harmless
            runner.stepOnce();
            runner.restart();
            QVERIFY(runner.askRecording()().run == Replay{});
        }
    }
    void aGameWithoutMemoryEndsAndTheProgramDoesNot() {
#ifdef __linux__
        if (isSanitized) {
            return; // a sanitizer takes address space of its own, without end
        }
        const pid_t child = fork();
        if (child == 0) {
            std::ifstream pages("/proc/self/statm");
            rlim_t used = 0;
            pages >> used;
            constexpr rlim_t room = 100'000'000; // bytes
            const rlim_t most = used * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + room;
            const rlimit limit{most, most};
            setrlimit(RLIMIT_AS, &limit);
            Runner runner(ballsAtOnePoint(1500), Runner::Mode::Manual);
            runner.advance(1);
            _exit(runner.fault() == RunnerFault::Memory ? 0 : 1);
        }
        int status = -1;
        QCOMPARE(waitpid(child, &status, 0), child);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 0);
#endif
    }
    void anyNumberOfThreadsMayAskAtOnce() {
        Runner runner(openSpace());
        std::atomic<bool> stop = false;
        std::vector<std::jthread> threads;
        for (int t = 0; t < 3; ++t) {
            threads.emplace_back([&, t] {
                double sum = 0;
                for (int i = 0; !stop; ++i) {
                    const std::shared_ptr<const Frame> frame = runner.frame();
                    for (const BodyPicture& body : frame->now->moving) {
                        sum += body.pose.position.x();
                    }
                    runner.hold(controlsFromBits(static_cast<std::uint8_t>((i + t) % 16)));
                    if (i % 50 == 0) {
                        t == 0 ? runner.pause() : runner.resume();
                        runner.wantSession(i % 100 == 0);
                    }
                    runner.takeSounds();
                    std::this_thread::yield();
                }
                QVERIFY(std::isfinite(sum));
            });
        }
        QVERIFY(comesTrue([&] {
            runner.stepOnce();
            return runner.askRecording()().run.updates() > 40;
        }));
        stop = true;
    }
    void stoppingWaitsForNothing() {
        for (int i = 0; i < 20; ++i) {
            Runner runner(openSpace());
            if (i % 2 == 0) {
                runner.pause();
            }
        }
    }
};

SPACETOW_TEST(RunnerTest)
#include "runner_test.moc"
