// The fan of where the ship can be, as the window shows it.

#include "editor/window/reach_view.h"

#include "core/level/edits.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// The level of the window is one with a ship, and the fan is on.
void showFan(TestWindow& test) {
    test.document().reset(openSpace());
    test.canvas().fitLevel();
    test.trigger(Act::Reach);
    test.window->reach().finish();
}

} // namespace

class ReachViewTest : public QObject {
    Q_OBJECT

  private slots:
    void whileEditingItBeginsAtTheShipsStartAndFollowsIt() {
        TestWindow test;
        showFan(test);
        QVERIFY(test.canvas().reach() != nullptr);
        QCOMPARE(test.canvas().reach()->outlines.size(), std::size_t(2));
        const double before = test.canvas().reach()->outlines[1].ship.front().x();
        const std::vector<Key> ship{shipKey};
        const Level level = moved(test.level(), ship, Vec2(3, 0));
        test.document().commit({"move", 1}, {std::make_shared<const Level>(level), Selection(ship)});
        test.window->reach().finish();
        QVERIFY(std::abs(test.canvas().reach()->outlines[1].ship.front().x() - before - 3) < 1e-9);
        test.trigger(Act::Reach);
        QVERIFY(test.canvas().reach() == nullptr);
    }

    void itLooksOneToFiveSecondsAhead() {
        TestWindow test;
        showFan(test);
        for (int i = 0; i < 6; ++i) {
            test.trigger(Act::ReachLonger);
        }
        test.window->reach().finish();
        QCOMPARE(test.canvas().reach()->outlines.size(), std::size_t(5));
        for (int i = 0; i < 6; ++i) {
            test.trigger(Act::ReachShorter);
        }
        test.window->reach().finish();
        QCOMPARE(test.canvas().reach()->outlines.size(), std::size_t(1));
    }

    void whileARunIsPausedItBeginsWhereTheShipIs() {
        TestWindow test;
        Level level = openSpace();
        level.gravity = Vec2(0, -1);
        test.document().reset(level);
        test.trigger(Act::Reach);
        test.trigger(Act::Play);
        QVERIFY(test.canvas().reach() == nullptr); // it would lag behind
        QTest::keyPress(&test.canvas(), Qt::Key_Up);
        QTRY_VERIFY(test.window->liveRun().updates() > 30);
        QTest::keyRelease(&test.canvas(), Qt::Key_Up);
        test.trigger(Act::Pause);
        const auto isOfShownMoment = [&test] {
            const auto session = test.window->liveRun().session();
            const ShownReach* const fan = test.canvas().reach();
            return session && session->ship() && fan != nullptr && !fan->path.ship.empty() &&
                   (fan->path.ship.front() - session->ship()->massCenter).norm() < 1e-9;
        };
        QTRY_VERIFY(isOfShownMoment());
        const Vec2 first = test.canvas().reach()->path.ship.front();
        test.window->liveRun().seek(10);
        QTRY_VERIFY(isOfShownMoment() && (test.canvas().reach()->path.ship.front() - first).norm() > 1e-6);
        test.trigger(Act::Pause);
        QTRY_VERIFY(test.canvas().reach() == nullptr);
        test.trigger(Act::Stop);
        test.window->reach().finish();
        QVERIFY(test.canvas().reach() != nullptr);
    }

    void itIsPaintedOverTheLevel() {
        TestWindow test;
        showFan(test);
        test.canvas().finishPainting();
        const QImage with = test.canvas().grab().toImage();
        test.trigger(Act::Reach);
        test.canvas().finishPainting();
        const QImage without = test.canvas().grab().toImage();
        test.trigger(Act::Reach);
        test.window->reach().finish();
        const Vec2 rim = test.canvas().reach()->outlines[1].ship.front();
        const QPoint at = test.at(rim.x(), rim.y());
        bool differs = false;
        for (int dx = -2; dx <= 2; ++dx) {
            differs = differs || with.pixel(at + QPoint(dx, 0)) != without.pixel(at + QPoint(dx, 0));
        }
        QVERIFY(differs);
    }

    void aLevelWithoutAShipHasNone() {
        TestWindow test;
        test.document().reset(Level());
        test.trigger(Act::Reach);
        test.window->reach().finish();
        QVERIFY(test.canvas().reach() == nullptr || test.canvas().reach()->outlines.empty());
    }
};

SPACETOW_TEST(ReachViewTest)
#include "reach_view_test.moc"
