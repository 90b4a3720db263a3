// What a timeline marks of a run, also after it has been turned back.

#include "core/game/timeline.h"
#include "tests/support/live_level.h"
#include "tests/support/mark_kinds.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <memory>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct MarkedRun {
    Session session;
    Timeline timeline;

    explicit MarkedRun(const Level& level, const Timeline::Limits& limits = {})
        : session(level), timeline(session, limits) {}
    void go(const StepInput& input, int updates = 1) {
        for (int i = 0; i < updates; ++i) {
            session.step(input);
            timeline.add(input, session);
        }
    }
    void goUntil(const Controls& controls, Phase phase) {
        for (int i = 0; i < 500 && session.phase() != phase; ++i) {
            go({controls, {}, {}});
        }
    }
    void turnBackTo(std::int64_t update) {
        session = *timeline.at(update);
        timeline.goOnFrom(session);
    }
    std::vector<MarkKind> kinds() const { return markKinds(timeline); }
};

/// Two balls, one behind the other, hit the payload, which waits.
Level spaceWithBalls() {
    Level level = openSpace();
    addBall(level, Vec2(1, -1), 0.2, Vec2(-1, 0));
    addBall(level, Vec2(4, -1), 0.2, Vec2(-1, 0));
    return level;
}

} // namespace

class TimelineMarksTest : public QObject {
    Q_OBJECT

  private slots:
    void crashAndTheNextAttemptAreMarked() {
        MarkedRun run(spaceWithCeiling());
        run.goUntil(thrust, Phase::Crashed);
        const std::int64_t crash = run.session.updates();
        run.go({});
        run.goUntil(tow, Phase::AwaitingInput);
        QVERIFY(run.kinds() == (std::vector{MarkKind::Crash, MarkKind::Attempt}));
        QCOMPARE(run.timeline.marks().front().update, crash);
        MarkedRun pushed(openSpace());
        pushed.go({thrust, {}, {}}, 200);
        QVERIFY(pushed.kinds().empty());
    }
    void whatShipOrPayloadTouchIsMarkedOnceInAWhile() {
        MarkedRun run(spaceWithBalls());
        run.go({}, 200);
        QVERIFY(!run.kinds().empty());
        QCOMPARE(std::ranges::count(run.kinds(), MarkKind::Touch), std::ptrdiff_t(run.kinds().size()));
        const std::span<const TimelineMark> marks = run.timeline.marks().all();
        for (std::size_t i = 1; i < marks.size(); ++i) {
            QVERIFY(marks[i].update - marks[i - 1].update > 10);
        }
        const std::int64_t first = marks.front().update;
        run.turnBackTo(first - 2);
        QVERIFY(run.kinds().empty());
        run.go({}, 3);
        QCOMPARE(run.kinds().size(), std::size_t(1)); // the same again
        QCOMPARE(run.timeline.marks().front().update, first);
    }
    void whoTurnsBackFromACrashHasNotBegunAnotherAttempt() {
        MarkedRun run(spaceWithCeiling());
        run.goUntil(thrust, Phase::Crashed);
        run.turnBackTo(0);
        run.go({}, 5);
        QVERIFY(run.kinds().empty());
    }
    void aTuneOfTheUpdatesLengthChangesHowManyAreAMinute() {
        MarkedRun run(yard(), {.seconds = 4, .bytes = std::size_t{64} << 20, .leastInterval = 1});
        run.go({}, 100);
        QCOMPARE(run.timeline.first(), std::int64_t(0));
        Level slower = yard();
        slower.updateSeconds = 0.1;
        run.go(withLevel(std::make_shared<const Level>(slower)));
        run.go({}, 9);
        QCOMPARE(run.timeline.first(), run.timeline.last() - 40);
    }
    void whatIsTooLongAgoToGoBackToIsKeptNoLonger() {
        MarkedRun run(yard(), {.seconds = 1});
        run.go({}, 60);
        const std::int64_t between = 43; // no multiple of the interval: simulated, and kept near the moment
        const std::weak_ptr<const Session> near = run.timeline.at(between);
        QVERIFY(!near.expired());
        run.turnBackTo(45);
        QCOMPARE(run.timeline.ghosts().size(), std::size_t(1));
        run.go({}, 40);
        QVERIFY(run.timeline.first() < between);
        QVERIFY(!near.expired());
        QCOMPARE(run.timeline.ghosts().size(), std::size_t(1));
        run.go({}, 30);
        QVERIFY(run.timeline.first() > 45);
        QVERIFY(near.expired());
        QVERIFY(run.timeline.ghosts().empty());
    }
    void aMarkAfterHoursIsPutBehindThoseThatThereAre() {
        MarkList list;
        int moved = 0;
        for (std::int64_t i = 0; i < 10'000; ++i) {
            const MarkList read = list; // as whoever shows it has
            const TimelineMark* const before = list.all().data();
            list.append({i, MarkKind::Edit});
            moved += before != list.all().data() ? 1 : 0;
            QVERIFY(read.size() == static_cast<std::size_t>(i) && (i == 0 || read.back().update == i - 1));
        }
        QVERIFY2(moved < 15, qPrintable(QString::number(moved)));
        MarkedRun run(yard());
        const TimelineMark* before = nullptr;
        moved = 0;
        for (int i = 0; i < 300; ++i) {
            Level other = yard();
            other.gravity = Vec2(0, -0.01 * i);
            run.go(withLevel(std::make_shared<const Level>(other)));
            moved += std::exchange(before, run.timeline.marks().all().data()) != before ? 1 : 0;
        }
        QCOMPARE(run.timeline.marks().size(), std::size_t(300));
        QVERIFY2(moved < 10, qPrintable(QString::number(moved)));
    }
    void listsOfMarksThatGoDifferentWaysDoNotMeet() {
        MarkList one;
        for (std::int64_t i = 0; i < 5; ++i) {
            one.append({i, MarkKind::Touch});
        }
        MarkList other = one;
        one.append({5, MarkKind::Win});
        other.append({5, MarkKind::Crash});
        QCOMPARE(one.back().kind, MarkKind::Win);
        QCOMPARE(other.back().kind, MarkKind::Crash);
        MarkList back = one;
        back.dropAfter(2);
        back.append({3, MarkKind::Edit});
        back.dropBefore(1);
        back.eraseIf([](const TimelineMark& mark) { return mark.update == 2; });
        QCOMPARE(back.size(), std::size_t(2));
        QVERIFY(back.front().update == 1 && back.back().kind == MarkKind::Edit);
        QVERIFY(one.size() == 6 && one.all()[3].kind == MarkKind::Touch && !(one == other));
        back.append({4, MarkKind::Tow});
        QCOMPARE(back.back().kind, MarkKind::Tow);
    }
};

SPACETOW_TEST(TimelineMarksTest)
#include "timeline_marks_test.moc"
