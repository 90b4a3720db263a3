// Going on with a chain that is there: from either end, to a new end or to its other one.

#include "editor/editing/draw_tool.h"

#include "core/level/edits.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using ChainPoints = std::vector<Vec2>;

/// A level with a one-way wall from (0, 0) over (2, 0) to (2, 2).
Level withChain() {
    return added(Level{}, bodyWith(1, EdgeChain{{{0, 0}, {2, 0}, {2, 2}}, false, 0.5}));
}

struct Extender : Drive {
    explicit Extender(const Level& level = withChain(), ToolId tool = ToolId::Edge) : Drive(level) {
        toolbox.choose(tool);
    }
    const EdgeChain& chain() const {
        return std::get<EdgeChain>(std::get<BodyObject>(level().objects[0].data).shapes.front());
    }
    std::string hintCode() const { return toolbox.hint().code; }
};

std::vector<OverlayLine> solidSides(const Drive& drive) {
    std::vector<OverlayLine> lines = drive.toolbox.overlay().lines;
    std::erase_if(lines, [](const OverlayLine& line) { return line.style != OverlayStyle::SolidSide; });
    return lines;
}

} // namespace

class ExtendChainTest : public QObject {
    Q_OBJECT

  private slots:
    void itsLastEndGoesOn() {
        Extender drive;
        drive.move({2.05, 2.05});
        QCOMPARE(drive.hintCode(), std::string("draw-edge.extend"));
        QCOMPARE(drive.toolbox.cursor(), CursorShape::Pointing);
        drive.click({{2.05, 2.05}, {0, 2}, {-1, 3}});
        drive.key(ToolKey::Enter);
        QCOMPARE(drive.level().objects.size(), 1);
        QVERIFY(worldPoints(drive.level().objects[0]) == (ChainPoints{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {-1, 3}}));
        QCOMPARE(drive.chain().depth, 0.5);
        QVERIFY(!drive.chain().closed);
        QCOMPARE(drive.document.history(), (std::vector<Label>{{"extend-chain", 1}}));
        QVERIFY(drive.document.selection() == Selection({1}));
        drive.document.undo();
        QVERIFY(drive.level() == withChain());
    }

    void itsFirstEndGoesOnAndItsWallsKeepTheirDirection() {
        Extender drive;
        drive.click({{0, 0}, {-2, 0}});
        drive.move({-2, 2});
        const std::vector<OverlayLine> shades = solidSides(drive);
        QCOMPARE(shades.size(), std::size_t{1});
        QVERIFY(shades.front().points == (ChainPoints{{-2, 2}, {-2, 0}, {0, 0}}));
        QCOMPARE(shades.front().depth, 0.5);
        drive.click({-2, 2});
        QVERIFY(drive.secondaryClick({5, 5}));
        QVERIFY(worldPoints(drive.level().objects[0]) == (ChainPoints{{-2, 2}, {-2, 0}, {0, 0}, {2, 0}, {2, 2}}));
    }

    void aPointThatSnapsToTheEndGoesOnWithTheChainToo() {
        Extender drive;
        drive.toolbox.snap.step = 1;
        drive.click({{2.4, 2.4}, {0, 3}}); // 37 pixels away, and no nearer grid point
        drive.key(ToolKey::Enter);
        QCOMPARE(drive.level().objects.size(), 1);
        drive.held.ctrl = true; // nothing snaps
        drive.click({{0.4, 3.4}, {0, 4}});
        drive.key(ToolKey::Enter);
        QCOMPARE(drive.level().objects.size(), 2);
    }

    void aDragFromTheEndDrawsASegment() {
        Extender drive;
        drive.drag({2, 2}, {0, 3});
        drive.key(ToolKey::Enter);
        QVERIFY(worldPoints(drive.level().objects[0]) == (ChainPoints{{0, 0}, {2, 0}, {2, 2}, {0, 3}}));
    }

    void drawingToItsOtherEndClosesIt_data() {
        QTest::addColumn<bool>("fromFirst");
        QTest::newRow("from the last") << false;
        QTest::newRow("from the first") << true;
    }
    void drawingToItsOtherEndClosesIt() {
        QFETCH(bool, fromFirst);
        Extender drive;
        drive.click({fromFirst ? Vec2(0, 0) : Vec2(2, 2), Vec2(0, 2)});
        const Vec2 other = fromFirst ? Vec2(2, 2) : Vec2(0, 0);
        drive.move(other + Vec2(0.05, 0));
        QCOMPARE(drive.hintCode(), std::string("draw-edge.close-chain"));
        QVERIFY(std::ranges::any_of(drive.toolbox.overlay().points, [&](const OverlayPoint& point) {
            return point.style == OverlayStyle::HotHandle && point.at == other;
        }));
        drive.click(other + Vec2(0.05, 0));
        QVERIFY(drive.chain().closed);
        QCOMPARE(drive.chain().vertices.size(), std::size_t{4});
        QVERIFY(drive.chain().vertices[fromFirst ? 0 : 3] == Vec2(0, 2));
        QVERIFY(!drive.toolbox.isBusy());
    }

    void aChainOfTwoPointsIsNotClosedOntoItself() {
        Extender drive(added(Level{}, bodyWith(1, EdgeChain{{{0, 0}, {2, 0}}})));
        drive.click({2, 0});
        drive.move({0, 0});
        QVERIFY(drive.hintCode() != "draw-edge.close-chain");
        drive.click({{2, 2}, {0, 0}});
        QVERIFY(drive.chain().closed);
        QCOMPARE(drive.chain().vertices.size(), std::size_t{3});
    }

    void aTurnedBodyGetsItsPointsWhereTheyWereDrawn() {
        const Level turned = rotated(withChain(), std::array{Key{1}}, {0, 0}, std::numbers::pi / 2);
        Extender drive(turned);
        drive.click({{-2, 2}, {-4, 2}});
        drive.key(ToolKey::Enter);
        const ChainPoints points = worldPoints(drive.level().objects[0]);
        QCOMPARE(points.size(), std::size_t{4});
        QVERIFY((points.back() - Vec2(-4, 2)).norm() < 1e-12);
        QVERIFY(drive.chain().vertices.back() == Vec2(2, 4));
    }

    void backspaceAndEscapeLeaveTheChainAsItWas() {
        Extender drive;
        drive.click({{2, 2}, {0, 2}});
        drive.key(ToolKey::Backspace);
        drive.key(ToolKey::Enter); // nothing was added
        QVERIFY(!drive.toolbox.isBusy());
        drive.click({{2, 2}, {0, 2}});
        drive.key(ToolKey::Escape);
        QVERIFY(drive.level() == withChain());
        QVERIFY(drive.document.history().empty());
    }

    void altBeginsAChainOfItsOwn() {
        Extender drive;
        drive.held.alt = true;
        drive.move({2, 2});
        QCOMPARE(drive.hintCode(), std::string("draw-edge.start"));
        drive.click({{2, 2}, {4, 2}});
        drive.key(ToolKey::Enter);
        QCOMPARE(drive.level().objects.size(), 2);
    }

    void onlyChainsOfTheKindAreExtended_data() {
        QTest::addColumn<ToolId>("tool");
        QTest::newRow("line") << ToolId::Line;
        QTest::newRow("polygon") << ToolId::Polygon;
    }
    void onlyChainsOfTheKindAreExtended() {
        QFETCH(ToolId, tool);
        Extender drive(withChain(), tool);
        drive.click({{2, 2}, {4, 2}, {4, 4}});
        drive.key(ToolKey::Enter);
        QCOMPARE(drive.level().objects.size(), 2);
        QVERIFY(drive.level().objects[0] == withChain().objects[0]);
    }

    void linesGoOnToo() {
        Extender drive(added(Level{}, bodyWith(1, LineChain{{{0, 0}, {2, 0}}, false})), ToolId::Line);
        drive.click({{2, 0}, {2, 2}});
        drive.key(ToolKey::Enter);
        QVERIFY(worldPoints(drive.level().objects[0]) == (ChainPoints{{0, 0}, {2, 0}, {2, 2}}));
    }

    void lockedHiddenAndClosedChainsAreLeftAlone_data() {
        QTest::addColumn<int>("how");
        QTest::newRow("locked") << 0;
        QTest::newRow("hidden") << 1;
        QTest::newRow("closed") << 2;
    }
    void lockedHiddenAndClosedChainsAreLeftAlone() {
        QFETCH(int, how);
        Object object = withChain().objects[0];
        object.locked = how == 0;
        object.visible = how != 1;
        std::get<EdgeChain>(std::get<BodyObject>(object.data).shapes.front()).closed = how == 2;
        Extender drive(withObject(withChain(), object));
        drive.click({{2, 2}, {4, 2}});
        drive.key(ToolKey::Enter);
        QCOMPARE(drive.level().objects.size(), 2);
    }

    void ofTwoEndsInOnePlaceThatOfTheSelectedChainGoesOn() {
        const Level level = added(withChain(), bodyWith(2, EdgeChain{{{2, 2}, {5, 5}}}));
        for (const Key key : {Key{1}, Key{2}}) {
            Extender drive(level);
            drive.document.select(Selection({key}));
            drive.click({{2, 2}, {0, 4}});
            drive.key(ToolKey::Enter);
            QCOMPARE(worldPoints(*drive.level().objects.find(key)).size(), std::size_t{key == 1 ? 4u : 3u});
        }
    }

    void whatWasDrawnIsKeptWhenTheChainIsUndoneMeanwhile() {
        Drive drive;
        drive.toolbox.choose(ToolId::Edge);
        drive.click({{0, 0}, {2, 0}});
        drive.key(ToolKey::Enter);
        drive.click({{2, 0}, {2, 2}});
        drive.document.undo();
        QVERIFY(drive.level().objects.empty());
        drive.key(ToolKey::Enter);
        QVERIFY(worldPoints(drive.newest()) == (ChainPoints{{2, 0}, {2, 2}}));
    }
};

SPACETOW_TEST(ExtendChainTest)
#include "extend_chain_test.moc"
