// What is selected and locked is told apart on the canvas.
#include "core/level/groups.h"
#include "tests/support/board.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A ball of radius 1 about the origin, key 1, alone in group 2.
Level lockableBall() {
    Level level;
    level.objects.append({2, {}, GroupObject{}, {}});
    Object ball{1, {}, BodyObject{.shapes = {Circle{{0, 0}, 1}}}, {}};
    ball.parent = 2;
    level.objects.append(ball);
    return level;
}

BoardRequest lockRequest(const Level& level) {
    Viewport view;
    view.size = Vec2(200, 200);
    view.scale = 40;
    BoardRequest request = boardRequest(std::make_shared<const Level>(level), view);
    request.selection = Selection({1});
    return request;
}

/// Whether the padlock is painted: on the highest point, and so within the outline.
bool showsLock(const QImage& image) {
    return image.pixelColor(100, 100 - 40 + 4) == editingTheme().selection;
}

} // namespace

class LockedMarkTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsLockedBearsAPadlockAndDashes() {
        const Level level = lockableBall();
        QVERIFY(!showsLock(fromScratch(lockRequest(level))));
        for (const Key key : {Key{1}, Key{2}}) { // by itself or with its group
            QVERIFY(showsLock(fromScratch(lockRequest(withLocked(level, std::array{key}, true)))));
        }
    }

    void lockingAndUnlockingIsSeenAtOnce() {
        const Level level = lockableBall();
        Board board([] {});
        for (const bool locked : {false, true, false}) {
            const BoardRequest request = lockRequest(withLocked(level, std::array{Key{1}}, locked));
            QCOMPARE(showsLock(finishedBy(board, request)), locked);
        }
    }
};

SPACETOW_TEST(LockedMarkTest)
#include "locked_mark_test.moc"
