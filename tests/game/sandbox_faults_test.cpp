// What people do to a sandbox that nobody meant: left alone for an hour, bodies thrown as fast as a mouse can.
#include "core/game/course.h"
#include "core/level/file.h"
#include "tests/support/test_main.h"

#include <cmath>

using namespace spacetow;

namespace {

/// A ball that jumps in a box for ever.
std::shared_ptr<const Level> jumpingBall() {
    Level level;
    level.gravity = Vec2(0, -2);
    level.iterations = 2;
    level.updateSeconds = 0.1;
    BodyObject box{.shapes = {EdgeChain{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, true, 1}}, .restitution = 1};
    BodyObject ball{.kind = BodyKind::Dynamic, .shapes = {Circle{{0, 0}, 0.3}}, .velocity = {0.7, 0}, .restitution = 1};
    level.objects.append({1, "box", box, {}});
    level.objects.append({2, "ball", ball, {}});
    return std::make_shared<const Level>(level);
}

bool isSomewhere(const Session& session) {
    const std::optional<BodyId> ball = session.bodyOf(2);
    const BodyState state = ball ? session.world().body(*ball) : BodyState();
    return ball && state.massCenter.allFinite() && state.velocity.allFinite() && std::isfinite(state.angularVelocity);
}

} // namespace

class SandboxFaultsTest : public QObject {
    Q_OBJECT

  private slots:
    void anHourLeftRunningTakesNoMoreMemoryThanTenMinutes() {
        Course course(jumpingBall(), 1);
        constexpr int minute = 600; // updates
        for (int i = 0; i < 10 * minute; ++i) {
            course.goOn({});
        }
        const std::size_t before = course.timeline().bytes();
        const std::size_t sessions = course.timeline().savedSessions();
        for (int i = 0; i < 50 * minute; ++i) {
            course.goOn({});
        }
        QCOMPARE(course.session().updates(), std::int64_t(60 * minute));
        QVERIFY2(course.timeline().bytes() < before + before / 20, qPrintable(QString::number(before)));
        QVERIFY(course.timeline().savedSessions() <= sessions + 1);
        QCOMPARE(course.recording().runs.size(), std::size_t(1)); // nobody has touched anything
        QVERIFY(isSomewhere(course.session()));
    }

    void whatIsThrownAtAMillionMetresASecondIsStillSomewhereAndCanBeTurnedBack() {
        const std::shared_ptr<const Level> level = jumpingBall();
        const std::string before = levelText(*level);
        Course course(level, 1);
        for (int i = 0; i < 120; ++i) {
            StepInput input;
            if (i >= 20 && i < 60) {
                input.grab = Grab{2, {0.1, 0}, {1e5 * (i - 20), -1e5 * (i % 3)}}; // in a tenth of a second each
            }
            course.goOn(input);
            QVERIFY2(isSomewhere(course.session()), qPrintable(QString::number(i)));
        }
        const std::uint64_t end = course.session().hash();
        course.seek(30);
        QCOMPARE(course.session().updates(), std::int64_t(30));
        course.seek(120);
        QCOMPARE(course.session().hash(), end);
        QVERIFY(levelText(course.session().level()) == before);
    }
};

SPACETOW_TEST(SandboxFaultsTest)
#include "sandbox_faults_test.moc"
