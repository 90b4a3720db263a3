// What runs is shown in the canvas in which one edits.
#include "core/level/bounds.h"
#include "core/level/file.h"
#include "tests/support/folders.h"
#include "tests/support/game_view.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDockWidget>
#include <QLabel>
#include <QLocale>

#include <array>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Without gravity: a ball that flies to the right by a metre a second from the origin, and a wall that stands.
Level ballAndWall() {
    Level level;
    level.gravity = Vec2(0, 0);
    level.iterations = 10;
    Object ball;
    ball.key = 1;
    ball.data = BodyObject{.kind = BodyKind::Dynamic, .shapes = {Circle{{0, 0}, 0.3}}, .velocity = {1, 0}};
    level.objects.append(ball);
    Object wall;
    wall.key = 2;
    wall.data = BodyObject{.shapes = {Circle{{0, 0}, 0.5}}, .position = {0, -2}};
    level.objects.append(wall);
    return level;
}

bool sameView(const Viewport& a, const Viewport& b) {
    return (a.center - b.center).norm() < 2 * a.pixel() && a.scale == b.scale;
}

} // namespace

class OneCanvasTest : public QObject {
    Q_OBJECT

  private slots:
    void aGameInALevelThatWasInSightAsAWholeShowsAllOfItAndStandsStill() {
        TestWindow test;
        const LevelFile file = readLevel(sourceFolder().toStdString() + "/levels/01_first_haul.json").value();
        test.document().reset(*file.level);
        test.canvas().fitLevel();
        test.trigger(Act::Play);
        QApplication::processEvents();
        const auto sees = [&] {
            const Aabb seen = test.canvas().view().visible();
            return seen.contains(boundsOf(*file.level)) &&
                   (seen.center() - boundsOf(*file.level).center()).norm() < 0.1;
        };
        QVERIFY(sees());
        const Viewport before = test.canvas().view();
        QTest::keyPress(&test.canvas(), Qt::Key_W);
        const auto updates = [&] { return test.window->liveRun().updates(); };
        QTRY_VERIFY(updates() > 20);
        QVERIFY(test.window->liveView().isFollowing() && sameView(test.canvas().view(), before));
        test.window->resize(test.window->size() - QSize(200, 60));
        QApplication::processEvents();
        QVERIFY(sees());
    }

    void aBarThatOpensInAGameLeavesTheViewWithTheShip() {
        TestWindow test;
        test.document().reset(openSpace());
        test.trigger(Act::Play);
        QApplication::processEvents();
        const double height = test.canvas().height();
        test.window->messageBar().say(MessageBar::Tone::Warning, QStringLiteral("Something is amiss."));
        QApplication::processEvents();
        QVERIFY(test.canvas().height() < height);
        QVERIFY(test.window->liveView().isFollowing());
    }

    void playingKeepsTheViewAndStoppingBringsItBack() {
        TestWindow test;
        test.document().reset(openSpace());
        Viewport view = test.canvas().view();
        view.center = Vec2(0.4, -0.3);
        view.scale = 90;
        test.canvas().setView(view);
        const Viewport before = test.canvas().view();
        const QPoint ship = test.canvas().mapToGlobal(test.at(0, 0));
        test.trigger(Act::Play);
        QVERIFY(test.window->isInGame() && test.canvas().isLive());
        QCOMPARE(test.canvas().view().scale, before.scale);
        QApplication::processEvents();
        QVERIFY((test.canvas().mapToGlobal(test.at(0, 0)) - ship).manhattanLength() <= 3);
        test.canvas().zoom(2);
        test.trigger(Act::Stop);
        QVERIFY(!test.canvas().isLive());
        QVERIFY(sameView(test.canvas().view(), before));
    }
    void aViewInWhichTheShipCannotBeFlownGivesWayToTheClassicOne_data() {
        QTest::addColumn<Vec2>("center");
        QTest::addColumn<double>("scale");
        QTest::addRow("a dot") << Vec2(0, 0) << 5.0;
        QTest::addRow("elsewhere") << Vec2(500, 0) << 60.0;
    }
    void aViewInWhichTheShipCannotBeFlownGivesWayToTheClassicOne() {
        QFETCH(Vec2, center);
        QFETCH(double, scale);
        Game game;
        Viewport view = game.view().view();
        view.center = center;
        view.scale = scale;
        game.scene().hide();
        game.view().setView(view);
        game.start(openSpace(), LiveRun::Kind::Game, false);
        const Aabb seen = game.viewport().visible();
        QVERIFY(seen.contains(Vec2(0, 0)));
        QVERIFY(std::abs(seen.size().y() - 10) < 0.5 || std::abs(seen.size().x() - 13.33) < 0.5);
        game.scene().hide();
        QCOMPARE(game.view().view().scale, scale);
        QVERIFY((game.view().view().center - center).norm() < 1e-9);
    }
    void theViewStandsStillWhileTheShipIsWellInside() {
        Game game;
        const Vec2 before = game.viewport().center;
        QTest::keyPress(&game.view(), Qt::Key_W);
        double moved = 0;
        while (moved == 0 && game.picture()->update < 2000) {
            game.run(1);
            const Viewport view = game.viewport();
            moved = (view.center - before).norm();
            const Vec2 ship = game.body(shipKey).pose.position;
            const bool inside = std::abs(ship.y() - before.y()) < 0.55 * view.size.y() / 2 / view.scale;
            QVERIFY2(!inside || moved == 0, qPrintable(QString::number(ship.y())));
        }
        QVERIFY(moved > 0);
    }
    void aViewThatTheUserMovesStopsFollowingUntilF() {
        Game game;
        QVERIFY(game.scene().isFollowing());
        game.view().setView(game.view().view().panned(Vec2(40, 0)));
        QVERIFY(!game.scene().isFollowing());
        game.view().resize(700, 500); // no move
        QTest::keyClick(&game.view(), Qt::Key_F);
        QVERIFY(game.scene().isFollowing());
        game.view().resize(880, 660);
        QVERIFY(game.scene().isFollowing());
    }
    void panelsStepAsideForAGameAndComeBackAlive() {
        TestWindow test;
        test.document().reset(openSpace());
        test.document().select(Selection({shipKey}));
        QVERIFY(test.window->inspector().isVisible());
        test.trigger(Act::Play);
        QVERIFY(!test.window->inspector().isVisible());
        QTest::keyClick(&test.canvas(), Qt::Key_Tab);
        QVERIFY(test.window->inspector().isVisible() && test.window->inspector().isEnabled());
        QVERIFY(test.window->isInGame());
        QTest::keyClick(&test.canvas(), Qt::Key_Tab);
        QVERIFY(!test.window->inspector().isVisible());
        test.trigger(Act::Stop);
        QVERIFY(test.window->inspector().isVisible());
    }
    void aSimulationLeavesPanelsAndToolsInUse() {
        TestWindow test;
        test.document().reset(openSpace());
        test.trigger(Act::Simulate);
        QVERIFY(test.window->isPlaying() && !test.window->isInGame());
        QVERIFY(test.window->inspector().isVisible() && test.window->inspector().isEnabled());
        QVERIFY(test.window->actions()[ToolId::Circle].isEnabled());
        QVERIFY(test.window->actions()[Act::Pause].isEnabled());
        QVERIFY(!test.window->actions()[Act::Simulate].isEnabled());
        QTRY_VERIFY(test.window->liveRun().updates() > 2);
        QVERIFY(test.window->statusLine().hint().contains("Simulation"));
        test.trigger(ToolId::Circle);
        QVERIFY(!test.window->statusLine().hint().contains("Simulation"));
        test.drag(3, 0, 4, 0);
        QCOMPARE(test.level().objects.size(), openSpace().objects.size() + 1);
        test.trigger(Act::Undo);
        test.trigger(Act::Stop);
        QVERIFY(!test.window->isPlaying());
    }
    void aLevelWithoutAShipIsSimulatedByPlayToo() {
        TestWindow test;
        test.document().reset(ballAndWall());
        const SnapSettings snap = test.window->toolbox().snap;
        test.trigger(Act::Play);
        QVERIFY(test.window->isPlaying() && !test.window->isInGame());
        QVERIFY(test.window->windowTitle().contains("(simulating)"));
        QVERIFY(!test.window->toolbox().snap.grid && !test.window->toolbox().snap.smart);
        test.trigger(Act::Play); // nothing to change to: it begins anew
        QVERIFY(test.window->isPlaying());
        test.trigger(Act::Stop);
        QVERIFY(test.window->toolbox().snap == snap);
    }
    void whatIsDrawnBesideASimulationMovesAndIsRockOtherwise() {
        TestWindow test;
        test.document().reset(ballAndWall());
        const auto drawnKind = [&](ToolId tool) {
            test.trigger(tool);
            if (tool == ToolId::Polygon) {
                test.click(3, 0);
                test.click(4, 0);
                test.click(4, 1);
                QTest::keyClick(&test.canvas(), Qt::Key_Return);
            } else {
                test.drag(3, 0, 4, 1);
            }
            const BodyKind kind = std::get<BodyObject>(test.level().objects[test.level().objects.size() - 1].data).kind;
            test.trigger(Act::Undo);
            return kind;
        };
        const std::array solids{ToolId::Polygon, ToolId::Rectangle, ToolId::Circle};
        for (const ToolId tool : solids) {
            QVERIFY(drawnKind(tool) == BodyKind::Static);
            QVERIFY(!test.window->statusLine().hint().contains("will move"));
        }
        test.trigger(Act::Simulate);
        for (const ToolId tool : solids) {
            QVERIFY(drawnKind(tool) == BodyKind::Dynamic);
            QVERIFY(test.window->statusLine().hint().contains("will move"));
        }
        test.trigger(ToolId::Edge);
        QVERIFY(!test.window->statusLine().hint().contains("will move"));
        test.trigger(Act::Stop);
        QVERIFY(drawnKind(ToolId::Circle) == BodyKind::Static);
    }
    void aClickSelectsWhatIsThereNow() {
        Game game(ballAndWall());
        game.run(100); // to (2, 0)
        QTest::mouseClick(&game.view(), Qt::LeftButton, {}, game.at({0, 0}));
        QVERIFY(game.document().selection().empty());
        QTest::mouseClick(&game.view(), Qt::LeftButton, {}, game.at({2, 0}));
        QVERIFY(game.document().selection().keys() == std::vector<Key>{1});
        QTest::mouseClick(&game.view(), Qt::LeftButton, Qt::ShiftModifier, game.at({0, -2}));
        QCOMPARE(game.document().selection().size(), 2);
        game.drag({-1, 1}, {3, -1}); // a band round the ball
        QVERIFY(game.document().selection().keys() == std::vector<Key>{1});
    }
    void aClickMeansWhatWasUnderThePress() {
        Game game(ballAndWall());
        const QPoint place = game.at({0, 0});
        QTest::mousePress(&game.view(), Qt::LeftButton, {}, place);
        game.run(100);
        QTest::mouseRelease(&game.view(), Qt::LeftButton, {}, place);
        QVERIFY(game.document().selection().keys() == std::vector<Key>{1});
    }
    void theInspectorSaysHowWhatIsSelectedMovesNow() {
        TestWindow test;
        test.document().reset(ballAndWall());
        test.document().select(Selection({1}));
        const MotionLine& motion = test.window->inspector().motion();
        QVERIFY(!motion.isVisible());
        test.trigger(Act::Simulate);
        QTRY_VERIFY(test.window->liveRun().updates() > 5);
        test.trigger(Act::Pause);
        QTRY_VERIFY(motion.isVisible() && motion.text().contains("(x 1.000 · y 0.000)"));
        QVERIFY2(!motion.text().contains("x 0.000 · y 0.000 m"), qPrintable(motion.text()));
        test.document().select(Selection());
        QVERIFY(!motion.isVisible());
        test.document().select(Selection({2}));
        QVERIFY2(motion.isVisible() && motion.text().contains("x 0.000 · y -2.000 m"), qPrintable(motion.text()));
        test.trigger(Act::Stop);
        QVERIFY(!motion.isVisible());
    }
    void theInspectorSaysHowHardAConnectorPulls() {
        TestWindow test;
        Level level = ballAndWall();
        Object spring;
        spring.key = 3;
        spring.data = ConnectorObject{.a = 1, .b = 2, .length = 1, .stiffness = 2};
        level.objects.append(spring);
        test.document().reset(level);
        test.document().select(Selection({3}));
        test.trigger(Act::Simulate);
        const MotionLine& motion = test.window->inspector().motion();
        QTRY_VERIFY2(motion.isVisible() && motion.text().contains("1.000 m at rest"), qPrintable(motion.text()));
        QTRY_VERIFY2(motion.text().contains("pulls with"), qPrintable(motion.text()));
    }
    void playingFromThePointerStartsTheShipThere() {
        TestWindow test;
        test.document().reset(openSpace());
        QTest::mouseMove(&test.canvas(), test.at(1.5, 0.5));
        test.trigger(Act::PlayFromHere);
        QVERIFY(test.window->isInGame());
        const auto shipAt = [&] {
            for (const BodyPicture& body : test.window->liveView().picture().moving) {
                if (body.look->key == shipKey) {
                    return body.pose.position;
                }
            }
            return Vec2(0, 0);
        };
        QVERIFY((shipAt() - Vec2(1.5, 0.5)).norm() < 0.03);
        QVERIFY(test.level() == openSpace());
        test.trigger(Act::Stop);
        test.trigger(Act::Play);
        QVERIFY((shipAt() - Vec2(0, 0)).norm() < 0.03);
    }
    void theStatusBarSaysHowManyFramesAreShown() {
        TestWindow test;
        test.document().reset(ballAndWall());
        test.trigger(Act::Simulate);
        QTRY_VERIFY(test.window->statusLine().pace().contains("fps"));
        test.trigger(Act::Stop);
        QVERIFY(test.window->statusLine().pace().isEmpty());
    }
    void whatIsSelectedIsOutlinedWhereItIsNow() {
        Game game(ballAndWall());
        game.run(100);
        game.viewport();
        const QImage plain = game.view().grab().toImage();
        game.document().select(Selection({1}));
        const QImage marked = game.view().grab().toImage();
        const auto differs = [&](const Vec2& world) {
            const QRect spot(game.at(world) - QPoint(3, 3), QSize(7, 7));
            return plain.copy(spot) != marked.copy(spot);
        };
        QVERIFY(differs({2.3, 0}));
        QVERIFY(!differs({0.3, 0}));
    }
    void draggingWhatStandsStillIsAnEditOfTheLevel() {
        Game game(ballAndWall());
        game.run(100);
        game.drag({0, -2}, {1, -3});
        const Vec2 place = std::get<BodyObject>(game.document().level().objects.find(2)->data).position;
        QVERIFY((place - Vec2(1, -3)).norm() < 0.05);
        QCOMPARE(game.document().historySize(), 1);
        game.live().setPaused(true);
        game.drag({2, 0}, {2, 1}); // what moves can be taken while it is held
        const Vec2 start = std::get<BodyObject>(game.document().level().objects.find(1)->data).position;
        QVERIFY((start - Vec2(0, 1)).norm() < 0.05);
        QCOMPARE(game.document().historySize(), 2);
    }
    void theSizeOfTheSelectionIsThatOfWhatRuns() {
        TestWindow test;
        test.document().reset(ballAndWall());
        test.document().select(Selection({1, 2}));
        const auto* words = test.window->findChild<QLabel*>(QStringLiteral("selection"));
        const auto wide = [words] { // what stands before ×
            return QLocale().toDouble(words->text().section(QStringLiteral(", "), 1).section(QLatin1Char(' '), 0, 0));
        };
        QCOMPARE(wide(), 1.0);
        test.trigger(Act::Simulate);
        QTRY_VERIFY(wide() > 1.1); // the ball flies away
        test.trigger(Act::Stop);
        QCOMPARE(wide(), 1.0);
    }
    void whereItsPanelsAreShownAGameCanUndoWhatWasTuned() {
        TestWindow test;
        test.document().reset(openSpace());
        test.trigger(Act::Play);
        Level tuned = test.level();
        tuned.rules.thrust *= 2;
        test.document().commit({"change", 1}, {std::make_shared<const Level>(tuned), {}});
        QVERIFY(!test.window->actions()[Act::Undo].isEnabled());
        test.window->setPanelsHidden(false);
        QVERIFY(test.window->actions()[Act::Undo].isEnabled());
        test.trigger(Act::Undo);
        QVERIFY(test.level() == openSpace());
        test.trigger(Act::Redo);
        QVERIFY(test.level() == tuned);
        test.window->setPanelsHidden(true);
        QVERIFY(!test.window->actions()[Act::Undo].isEnabled());
    }
    void inAGameNothingIsEditedByASlipOfTheHand() {
        Level level = openSpace();
        addWall(level, {-2, -3}, {2, -3});
        Game game(level);
        game.drag({0, -3}, {0, -4});
        QVERIFY(game.document().level() == level);
    }
    void arrowsSteerAShipThatIsSimulated() {
        Game game(openSpace(), {880, 660}, LiveRun::Kind::Simulation);
        QVERIFY(!game.live().isGame());
        QTest::keyPress(&game.view(), Qt::Key_Up);
        game.run(3);
        QVERIFY(game.picture()->controls == thrust);
        QTest::keyRelease(&game.view(), Qt::Key_Up);
        game.run(1);
        QVERIFY(game.picture()->controls == idle);
        game.document().select(Selection({payloadKey}));
        QTest::keyClick(&game.view(), Qt::Key_Right); // nudges
        QVERIFY(!(game.document().level() == openSpace()));
    }
};

SPACETOW_TEST(OneCanvasTest)
#include "one_canvas_test.moc"
