#include "editor/editing/connector_tool.h"

#include "core/level/edits.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr Key boxKey = 1;
constexpr Key ballKey = 2;
constexpr Key beamKey = 3;

/// A fixed box, a loose ball called "weight", and a fixed one-way wall, and far off the ship.
Level twoBodies() {
    Level level = added(Level{}, bodyWith(boxKey, Polygon{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}, {0, 4}));
    Object ball = bodyWith(ballKey, Circle{{0, 0}, 0.5}, {3, 0});
    ball.name = "weight";
    std::get<BodyObject>(ball.data).kind = BodyKind::Dynamic;
    level = added(level, ball);
    level = added(level, bodyWith(beamKey, EdgeChain{{{0, 0}, {3, 0}}}, {-6, 0}));
    Object ship;
    ship.key = 4;
    ship.data = ShipObject{{-4, 4}, 0};
    return added(level, ship);
}

struct Connecting : Drive {
    Connecting() : Drive(twoBodies()) { toolbox.choose(ToolId::Connector); }
    const ConnectorObject& connector() const { return std::get<ConnectorObject>(newest().data); }
    std::string hintCode() const { return toolbox.hint().code; }
};

} // namespace

class ConnectorToolTest : public QObject {
    Q_OBJECT

  private slots:
    void aDragJoinsTwoBodies() {
        Connecting drive;
        drive.press({0.5, 3.5});
        drive.move({2, 2});
        QCOMPARE(drive.level().objects.size(), 4);
        drive.move({3.05, 0.05});                  // near the middle of the ball
        QCOMPARE(drive.level().objects.size(), 5); // while dragging
        drive.release({3.05, 0.05});
        QCOMPARE(drive.connector().a, boxKey);
        QCOMPARE(drive.connector().b, ballKey);
        QVERIFY(drive.connector().anchorA == Vec2(0.5, -0.5));
        QVERIFY(drive.connector().anchorB == Vec2(0, 0));
        QVERIFY(!drive.connector().length); // as long as the bodies are apart
        QCOMPARE(drive.document.history(), (std::vector<Label>{{"draw-connector", 1}}));
        QVERIFY(drive.document.selection() == Selection({drive.newest().key}));
    }

    void twoClicksJoinThemToo() {
        Connecting drive;
        drive.click({3, 0});
        QVERIFY(drive.toolbox.isBusy());
        drive.click({-4.5, 0.02});
        QCOMPARE(drive.connector().a, ballKey);
        QCOMPARE(drive.connector().b, beamKey);
        QVERIFY(drive.connector().anchorB == Vec2(1.5, 0)); // on the wall
        QVERIFY(!drive.toolbox.isBusy());
    }

    void anchorsSnap_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<bool>("ctrl");
        QTest::addColumn<double>("anchorX");
        QTest::addColumn<double>("anchorY");
        QTest::newRow("to a corner") << 0.93 << 4.94 << false << 1.0 << 1.0;
        QTest::newRow("to the grid inside") << 0.3 << 4.3 << false << 0.25 << 0.25;
        QTest::newRow("not with ctrl") << 0.3 << 4.3 << true << 0.3 << 0.3;
    }
    void anchorsSnap() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(bool, ctrl);
        QFETCH(double, anchorX);
        QFETCH(double, anchorY);
        Connecting drive;
        drive.held.ctrl = ctrl;
        drive.click({{x, y}, {3, 0}});
        QVERIFY((drive.connector().anchorA - Vec2(anchorX, anchorY)).norm() < 1e-9);
    }

    void anAnchorTurnsWithItsBody() {
        Connecting drive;
        drive.toolbox.choose(ToolId::Select);
        drive.document.commit({"rotate"}, {std::make_shared<const Level>(rotated(drive.level(), std::array{boxKey},
                                                                                 {0, 4}, std::numbers::pi / 2)),
                                           {}});
        drive.toolbox.choose(ToolId::Connector);
        drive.click({{0.5, 4.25}, {3, 0}});
        QVERIFY((drive.connector().anchorA - Vec2(0.25, -0.5)).norm() < 1e-12);
    }

    void anAnchorLiesOnItsBodyEvenWhereTheGridDoesNot() {
        Connecting drive;
        drive.toolbox.snap.step = 10;
        drive.click({{3.3, 0.2}, {0, 4}});
        QVERIFY((drive.connector().anchorA - Vec2(0.3, 0.2)).norm() < 1e-9);
    }

    void theAnchorOfAnotherConnectorIsFoundOnItsBodyAndBesideIt() {
        Level level = twoBodies();
        Object rope;
        rope.key = 9;
        rope.data = ConnectorObject{.a = boxKey, .b = ballKey, .anchorA = {0.37, 0.37}, .anchorB = {2, 0.13}};
        Drive drive(added(level, rope));
        drive.toolbox.choose(ToolId::Connector);
        drive.click({{0.4, 4.4}, {5.05, 0.13}}); // the second one is a metre and a half outside of the ball
        const auto& connector = std::get<ConnectorObject>(drive.newest().data);
        QCOMPARE(connector.b, ballKey);
        QVERIFY((connector.anchorA - Vec2(0.37, 0.37)).norm() < 1e-9);
        QVERIFY((connector.anchorB - Vec2(2, 0.13)).norm() < 1e-9);
    }

    void whatAnEndHasSnappedToIsMarked_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("kind");
        QTest::addColumn<Key>("key");
        const auto row = [](const char* name, const Vec2& at, SnapKind kind, Key key) {
            QTest::newRow(name) << at.x() << at.y() << static_cast<int>(kind) << key;
        };
        row("a corner", {0.93, 4.94}, SnapKind::Vertex, boxKey);
        row("a middle", {3.05, 0.05}, SnapKind::Center, ballKey);
        row("another connector", {0.4, 4.4}, SnapKind::Anchor, boxKey);
        row("the grid", {-0.3, 3.7}, SnapKind::Grid, boxKey);
        row("a slope", {-6.6, -3.55}, SnapKind::Edge, 5);
        row("nothing", {8, 8}, SnapKind::None, 0);
    }
    void whatAnEndHasSnappedToIsMarked() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, kind);
        QFETCH(Key, key);
        Level level = twoBodies();
        Object rope;
        rope.key = 9;
        rope.data = ConnectorObject{.a = boxKey, .b = ballKey, .anchorA = {0.37, 0.37}, .anchorB = {2, 0.13}};
        level = added(level, bodyWith(5, LineChain{{{-8, -4}, {-5, -3.1}}}));
        Drive drive(added(level, rope));
        drive.toolbox.choose(ToolId::Connector);
        const auto look = [&] {
            const std::optional<SnapAnswer> snap = drive.toolbox.overlay().snap;
            QCOMPARE(snap ? static_cast<int>(snap->kind) : 0, kind);
            QCOMPARE(snap ? snap->key : Key{0}, key);
        };
        drive.move({x, y});
        look();
        drive.click({-4.5, 0}); // the second end, too
        drive.move({x, y});
        look();
        drive.toolbox.cancel();
        drive.press({3.3, 0.2});
        drive.move({x, y});
        look();
    }

    void theHintSaysWhatIsUnderThePointer() {
        Connecting drive;
        drive.move({8, 8});
        QCOMPARE(drive.hintCode(), std::string("connector.start"));
        drive.move({0, 4});
        QCOMPARE(drive.hintCode(), std::string("connector.from-static"));
        drive.move({3, 0});
        QCOMPARE(drive.toolbox.hint(), (Hint{"connector.from-named", {"weight"}}));
        drive.move({-4, 4});
        QCOMPARE(drive.hintCode(), std::string("connector.no-body"));
        drive.click({0, 4});
        drive.move({3, 0});
        QCOMPARE(drive.toolbox.hint(), (Hint{"connector.to-named", {"5.00", "weight"}}));
        drive.move({-4.5, 0});
        QCOMPARE(drive.hintCode(), std::string("connector.nothing-moves"));
        drive.move({0.5, 4});
        QCOMPARE(drive.hintCode(), std::string("connector.same-body"));
        drive.move({8, 8});
        QCOMPARE(drive.hintCode(), std::string("connector.nothing-here"));
    }

    void emptySpaceIsRefusedWithASentence() {
        Connecting drive;
        drive.drag({0, 4}, {8, 8});
        QCOMPARE(drive.hintCode(), std::string("connector.ended-nowhere"));
        drive.drag({8, 8}, {3, 0});
        QCOMPARE(drive.hintCode(), std::string("connector.began-nowhere"));
        drive.click({8, 8});
        QCOMPARE(drive.hintCode(), std::string("connector.nothing-here"));
        drive.click({0, 4});
        drive.click({8, 8});
        QVERIFY(drive.toolbox.isBusy()); // the first end stays
        drive.click({0, 4});
        QCOMPARE(drive.hintCode(), std::string("connector.same-body"));
        QCOMPARE(drive.level().objects.size(), 4);
        QVERIFY(drive.document.history().empty());
        drive.click({3, 0});
        QCOMPARE(drive.level().objects.size(), 5);
    }

    void cancellingTakesTheFirstEndBack() {
        Connecting drive;
        for (const ToolKey key : {ToolKey::Escape, ToolKey::Backspace}) {
            drive.click({0, 4});
            drive.key(key);
            QVERIFY(!drive.toolbox.isBusy());
        }
        drive.click({0, 4});
        QVERIFY(drive.secondaryClick({8, 8}));
        QVERIFY(!drive.toolbox.isBusy());
        QCOMPARE(drive.level().objects.size(), 4);
    }

    void hiddenAndLockedBodiesAreNotJoined() {
        Level level = twoBodies();
        Object box = level.objects[0];
        box.locked = true;
        level = withObject(level, box);
        Object ball = level.objects[1];
        ball.visible = false;
        level = withObject(level, ball);
        Drive drive(level);
        drive.toolbox.choose(ToolId::Connector);
        drive.drag({0, 4}, {3, 0});
        QCOMPARE(drive.level().objects.size(), 4);
    }

    void undoOfTheFirstBodyForgetsTheFirstEnd() {
        Connecting drive;
        drive.toolbox.choose(ToolId::Circle);
        drive.drag({7, 0}, {8, 0});
        drive.toolbox.choose(ToolId::Connector);
        drive.click({7, 0});
        drive.document.undo();
        drive.move({3, 0});
        QVERIFY(!drive.toolbox.isBusy());
        QCOMPARE(drive.hintCode(), std::string("connector.from-named"));
    }
};

SPACETOW_TEST(ConnectorToolTest)
#include "connector_tool_test.moc"
