// Recorded runs that are looked at, gone on from and edited while they are still being simulated.

#include "core/game/course.h"
#include "tests/support/live_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class CourseFutureTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsStillToBeSimulatedIsNotLostByLookingAtIt() {
        Replay recording;
        recording.runs = {{thrust, 300}};
        Course course(std::make_shared<const Level>(openSpace()), 1);
        course.open(recording);
        QVERIFY(course.isSimulating());
        const int iterations = course.session().world().parameters().iterations;
        for (int i = 0; i < iterations; ++i) {
            course.stepIteration({left, {}, {}}); // of the update as it was
        }
        Session fresh(openSpace());
        fresh.step(thrust);
        QCOMPARE(course.session().hash(), fresh.hash());
        QVERIFY(course.isSimulating());
        course.simulate(99);
        QCOMPARE(course.recording().updates(), std::int64_t(300));
        course.stopSimulating();
        QCOMPARE(course.recording().updates(), std::int64_t(100));
        QVERIFY(course.recording().runs == (std::vector<Replay::Run>{{thrust, 100}}));
    }
    void aFutureThatNobodyHasSeenIsNoGhost() {
        Replay recording;
        recording.runs = {{thrust, 300}};
        Course course(std::make_shared<const Level>(openSpace()), 1);
        course.open(recording);
        course.simulate(50);
        course.seek(20);
        course.goOn({left, {}, {}});
        QVERIFY(course.timeline().ghosts().empty());
        QCOMPARE(course.recording().updates(), std::int64_t(21));
    }
    void anEditInARecordedRunKeepsAllOfItsInputs() {
        Replay recording;
        recording.runs = {{thrust, 100}, {left, 100}};
        Course course(std::make_shared<const Level>(openSpace()), 1);
        course.open(recording);
        course.simulate(30);
        course.seek(20);
        Level pulling = openSpace();
        pulling.gravity = Vec2(1, 0);
        course.setLevel(std::make_shared<const Level>(pulling));
        while (course.isSimulating()) {
            course.simulate(10);
        }
        QCOMPARE(course.timeline().last(), std::int64_t(200));
        QVERIFY(course.recording().runs == recording.runs);
    }
};

SPACETOW_TEST(CourseFutureTest)
#include "course_future_test.moc"
