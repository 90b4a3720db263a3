// What a timeline shows of the object that somebody looks at.

#include "core/game/timeline.h"
#include "tests/support/live_level.h"
#include "tests/support/mark_kinds.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

class TimelineFocusTest : public QObject {
    Q_OBJECT

  private slots:
    void theTouchesOfWhatIsLookedAtAreMarked() {
        Level level; // two balls that fall on a floor
        level.gravity = Vec2(0, -9.81);
        addBodyObject(level, 1, ballAt(Vec2(0, 2)));
        addBodyObject(level, 2, ballAt(Vec2(5, 1)));
        BodyObject floor;
        floor.shapes = {EdgeChain{{Vec2(-9, 0), Vec2(9, 0)}, false, 1}};
        addBodyObject(level, 3, floor);
        Session session(level);
        Timeline timeline(session);
        timeline.setFocus(1);
        const auto run = [&](int updates, const StepInput& input) {
            for (int i = 0; i < updates; ++i) {
                session.step(input);
                timeline.add(input, session);
            }
        };
        run(150, {});
        QVERIFY(!markKinds(timeline).empty() && markKinds(timeline).front() == MarkKind::FocusTouch);
        const std::int64_t fall = timeline.marks().front().update;
        QVERIFY(fall > 25 && fall < 40);                     // 2 m less a radius, at 9.81 m/s²
        run(100, {{}, Grab{1, Vec2(0, 0), Vec2(0, 3)}, {}}); // lifted
        QVERIFY(markKinds(timeline).back() == MarkKind::FocusPart);
        timeline.setFocus(2);
        QVERIFY(markKinds(timeline).empty()); // those of the other body are none of its
        run(60, {});
        QVERIFY(markKinds(timeline).empty()); // it lies where it lay
    }
    void ofManyBodiesTheOneThatIsLookedAtIsFollowed() {
        Level level;
        level.gravity = Vec2(0, 0);
        for (Key key = 1; key <= 100; ++key) {
            BodyObject ball = ballAt(Vec2(0, 2.0 * static_cast<double>(key)));
            ball.velocity = Vec2(1, 0);
            addBodyObject(level, key, ball);
        }
        Session session(level);
        Timeline timeline(session);
        const auto follows = [&](Key key) {
            for (int i = 0; i < 20; ++i) {
                session.step(idle);
                timeline.add({}, session);
            }
            const std::vector<TracedPath> paths = timeline.pathsFrom(timeline.first());
            return std::ranges::any_of(paths, [key](const TracedPath& path) { return path.object == key; });
        };
        QVERIFY(follows(1) && !follows(100)); // there are too many
        timeline.setFocus(100);
        QVERIFY(follows(100) && follows(1));
    }
};

SPACETOW_TEST(TimelineFocusTest)
#include "timeline_focus_test.moc"
