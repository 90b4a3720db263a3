#include "editor/editing/node_tool.h"

#include "editor/editing/node_verbs.h"
#include "editor/editing/verbs.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

using Points = std::vector<Vec2>;
using Nodes = std::vector<NodeRef>;

constexpr Modifiers ctrlAlt{false, true, true};
constexpr Modifiers shiftAlt{true, false, true};

/// A wall (1), a line from its second node on (2), and a polygon (3).
Level drawing() {
    Level level;
    level.objects.append(bodyWith(1, EdgeChain{{{0, 0}, {2, 0}, {2, 2}}}));
    level.objects.append(bodyWith(2, LineChain{{{0, 0}, {2, -2}}}, {2, 0}));
    level.objects.append(bodyWith(3, Polygon{{{0, 0}, {2, 0}, {1, 2}}}, {-4, 0}));
    return level;
}

struct Edited : Drive {
    explicit Edited(std::vector<Key> keys, Level level = drawing()) : Drive(std::move(level)) {
        document.select(Selection(std::move(keys)));
        toolbox.choose(ToolId::Nodes);
    }
    Points points(Key key) const { return worldPoints(*level().objects.find(key)); }
    const Nodes& nodes() const { return document.selection().nodes(); }
    const std::vector<Key>& keys() const { return document.selection().keys(); }
    void with(const Modifiers& modifiers, const Vec2& at) {
        held = modifiers;
        click(at);
        held = none;
    }
    std::string hintCode() const { return toolbox.hint().code; }
};

} // namespace

class NodeToolTest : public QObject {
    Q_OBJECT

  private slots:
    void aClickSelectsANodeAndShiftAddsAnother() {
        Edited drive({1});
        drive.click({2, 0});
        QCOMPARE(drive.nodes(), (Nodes{{1, 0, 1}}));
        drive.move({5, 5});
        QCOMPARE(drive.hintCode(), std::string("nodes.one-selected"));
        drive.with(shift, {0, 0});
        QCOMPARE(drive.nodes(), (Nodes{{1, 0, 0}, {1, 0, 1}}));
        drive.with(ctrl, {2, 0});
        QCOMPARE(drive.nodes(), (Nodes{{1, 0, 0}}));
        QVERIFY(drive.document.history().empty());
    }
    void aClickOnASegmentSelectsBothItsNodes() {
        Edited drive({3});
        drive.click({-2.5, 1});
        QCOMPARE(drive.nodes(), (Nodes{{3, 0, 1}, {3, 0, 2}}));
    }
    void aClickOnAnotherObjectGoesOnToIt() {
        Edited drive({1});
        drive.click({3, -1});
        QCOMPARE(drive.keys(), (std::vector<Key>{2}));
        drive.with(shift, {1, 0});
        QCOMPARE(drive.keys(), (std::vector<Key>{1, 2}));
    }
    void aBandSelectsNodes() {
        Edited drive({1, 2});
        drive.drag({-0.5, -0.5}, {2.5, 0.5});
        QCOMPARE(drive.nodes(), (Nodes{{1, 0, 0}, {1, 0, 1}, {2, 0, 0}}));
        drive.held = shift;
        drive.drag({3.5, -2.5}, {4.5, -1.5});
        QCOMPARE(drive.nodes().size(), std::size_t{4});
        QVERIFY(drive.document.history().empty());
    }
    void aLassoSelectsWhatItGoesRound() {
        Edited drive({1});
        drive.held = shiftAlt;
        drive.press({-0.5, -0.5});
        for (const Vec2& point : {Vec2(2.5, -0.5), Vec2(2.5, 0.5), Vec2(0.5, 0.5), Vec2(0.5, 2.5)}) {
            drive.move(point);
        }
        drive.release({-0.5, 2.5});
        QCOMPARE(drive.nodes(), (Nodes{{1, 0, 0}, {1, 0, 1}}));
    }
    void aDragMovesTheNodeOnTheGrid() {
        Edited drive({1});
        drive.drag({2, 2}, {3.1, 2.6});
        QCOMPARE(drive.points(1), (Points{{0, 0}, {2, 0}, {3, 2.5}}));
        QCOMPARE(drive.document.history().size(), std::size_t{1});
        drive.document.undo();
        QCOMPARE(drive.level(), drawing());
    }
    void nodesInTheSamePlaceComeAlongUnlessAltIsHeld() {
        Edited drive({1});
        drive.drag({2, 0}, {2, 1});
        QCOMPARE(drive.points(2), (Points{{2, 1}, {4, -2}}));
        drive.document.undo();
        drive.press({2, 0});
        drive.held = alt;
        drive.move({2, 0.5});
        drive.release({2, 1});
        QCOMPARE(drive.points(1), (Points{{0, 0}, {2, 1}, {2, 2}}));
        QCOMPARE(drive.points(2), (Points{{2, 0}, {4, -2}}));
    }
    void aDragOfASegmentMovesBothItsNodes() {
        Edited drive({3});
        drive.drag({-3, 0}, {-3, -1});
        QCOMPARE(drive.points(3), (Points{{-4, -1}, {-2, -1}, {-3, 2}}));
    }
    void shiftPressedAfterTheStartKeepsToAnAxis() {
        Edited drive({1});
        drive.press({2, 2});
        drive.held = shift;
        drive.move({3, 2.5});
        drive.release({4, 2.5});
        QCOMPARE(drive.points(1).back(), Vec2(4, 2));
    }
    void allSelectedNodesGoTogether() {
        Edited drive({1});
        drive.click({0, 0});
        drive.with(shift, {2, 2});
        drive.drag({2, 2}, {2, 3});
        QCOMPARE(drive.points(1), (Points{{0, 1}, {2, 0}, {2, 3}}));
    }
    void aDoubleClickInsertsANodeOnTheSegment() {
        Edited drive({1});
        drive.doubleClick({1.02, 0.03});
        QCOMPARE(drive.points(1), (Points{{0, 0}, {1, 0}, {2, 0}, {2, 2}}));
        QCOMPARE(drive.nodes(), (Nodes{{1, 0, 1}}));
    }
    void ctrlAltClickInsertsANodeToo() {
        Edited drive({3});
        drive.with(ctrlAlt, {-3, 0});
        QCOMPARE(drive.points(3), (Points{{-4, 0}, {-3, 0}, {-2, 0}, {-3, 2}}));
    }
    void deleteRemovesNodesAndLeavesTheObject() {
        Edited drive({1});
        drive.click({2, 0});
        drive.key(ToolKey::Delete);
        QCOMPARE(drive.points(1), (Points{{0, 0}, {2, 2}}));
        QCOMPARE(drive.keys(), (std::vector<Key>{1}));
        QVERIFY(drive.nodes().empty());
    }
    void escapeLeavesNodesThenTheToolThenTheSelection() {
        Edited drive({1});
        drive.click({2, 0});
        drive.key(ToolKey::Escape);
        QVERIFY(drive.nodes().empty() && drive.toolbox.current() == ToolId::Nodes);
        drive.key(ToolKey::Escape);
        QCOMPARE(drive.toolbox.current(), ToolId::Select);
        QCOMPARE(drive.keys(), (std::vector<Key>{1}));
        drive.key(ToolKey::Escape);
        QVERIFY(drive.keys().empty());
    }
    void escapeDuringADragLeavesEverythingAsItWas() {
        Edited drive({1});
        drive.press({2, 0});
        drive.move({3, 1});
        drive.key(ToolKey::Escape);
        drive.release({3, 1});
        QCOMPARE(drive.level(), drawing());
    }
    void aPolygonDraggedThroughItselfSaysSo() {
        Level level = drawing();
        level.objects.append(bodyWith(4, Polygon{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {-8, 0}));
        Edited drive({4}, level);
        drive.press({-6, 2});
        drive.move({-7, 3});
        QCOMPARE(drive.hintCode(), std::string("nodes.moving"));
        drive.move({-9, 1});
        QCOMPARE(drive.hintCode(), std::string("nodes.crosses"));
        drive.move({-6, 0});
        QCOMPARE(drive.hintCode(), std::string("nodes.together"));
        drive.release({-9, 1});
        QCOMPARE(drive.points(4)[2], Vec2(-9, 1));
    }
    void membersOfASelectedGroupAreEdited() {
        Level level;
        level.objects.append({9, "", GroupObject(), ""});
        Object member = bodyWith(1, LineChain{{{0, 0}, {2, 0}}});
        member.parent = 9;
        level.objects.append(member);
        Edited drive({9}, level);
        drive.drag({2, 0}, {2, 1});
        QCOMPARE(drive.points(1), (Points{{0, 0}, {2, 1}}));
    }
    void verbsActOnNodesWhereNodesAreSelected() {
        Edited drive({1});
        drive.click({2, 2});
        drive.toolbox.finish(nudgeSelected(drive.toolbox.context(), {0.5, 0}));
        QCOMPARE(drive.points(1), (Points{{0, 0}, {2, 0}, {2.5, 2}}));
        drive.document.undo();
        drive.document.select(selectAllNodes(drive.document.current()));
        drive.toolbox.finish(rotateSelected(drive.toolbox.context(), 1.5707963267948966));
        QCOMPARE(drive.points(1), (Points{{2, 0}, {2, 2}, {0, 2}}));
    }
    void aSingleNodeStandsForItsChainWhenTurnedRound() {
        Edited drive({1});
        drive.click({2, 0});
        drive.toolbox.finish(reverseSelected(drive.toolbox.context()));
        QCOMPARE(drive.points(1), (Points{{2, 2}, {2, 0}, {0, 0}}));
    }
    void nextNodesGoRound() {
        Edited drive({1});
        Nodes seen;
        for (int i = 0; i < 4; ++i) {
            drive.document.select(nextNode(drive.document.current(), 1));
            seen.push_back(drive.nodes().front());
        }
        QCOMPARE(seen, (Nodes{{1, 0, 0}, {1, 0, 1}, {1, 0, 2}, {1, 0, 0}}));
        drive.document.select(nextNode(drive.document.current(), -1));
        QCOMPARE(drive.nodes(), (Nodes{{1, 0, 2}}));
    }
    void aDoubleClickWithTheSelectToolEntersNodeEditing() {
        Drive drive(drawing());
        drive.doubleClick({1, 0});
        QCOMPARE(drive.toolbox.current(), ToolId::Nodes);
        QCOMPARE(drive.document.selection().keys(), (std::vector<Key>{1}));
    }
    void whatLooksLikeAHandleIsOneInTheSelectToolToo() {
        Level level = drawing();
        level.objects.append({5, "", FinishObject{{-4, -4}, {-2, -4}}, ""});
        Edited drive({1}, level);
        drive.toolbox.choose(ToolId::Select);
        drive.drag({2, 2}, {3, 3});
        QCOMPARE(drive.points(1), (Points{{0, 0}, {2, 0}, {3, 3}}));
        drive.document.select(Selection({5}));
        drive.drag({-2, -4}, {-2, -3});
        const auto& finish = std::get<FinishObject>(drive.level().objects.find(5)->data);
        QCOMPARE(finish.a, Vec2(-4, -4));
        QCOMPARE(finish.b, Vec2(-2, -3));
    }
    void smallObjectsAreStillMovedWithTheSelectTool() {
        Level level;
        level.objects.append(bodyWith(1, Polygon{{{0, 0}, {0.1, 0}, {0, 0.1}}}));
        Drive drive(level);
        drive.document.select(Selection({1}));
        drive.drag({0, 0}, {1, 0});
        QCOMPARE(std::get<BodyObject>(drive.level().objects.find(1)->data).position, Vec2(1, 0));
    }
    void handlesScaleTheSelectedNodesAndTurnThemAfterAnotherClick() {
        Edited drive({1});
        drive.document.select(selectAllNodes(drive.document.current()));
        const double outside = 14 * drive.view.pixel();
        drive.drag({2 + outside, 2 + outside}, {4 + outside, 3 + outside});
        QCOMPARE(drive.points(1), (Points{{0, 0}, {4, 0}, {4, 3}}));
        QCOMPARE(drive.points(2).front(), Vec2(4, 0)); // in the same place, so it came along
        QCOMPARE(drive.document.undoLabel().code.text(), std::string("scale-nodes"));
        drive.document.undo();
        drive.click({2, 2});
        drive.held = ctrl;
        drive.drag({2 + outside, 2 + outside}, {0 - outside, 2 + outside});
        QCOMPARE(drive.points(1), (Points{{2, 0}, {2, 2}, {0, 2}}));
    }
    void nodesAreNotScaledDownToNothing() {
        Edited drive({3});
        drive.document.select(selectAllNodes(drive.document.current()));
        const double outside = 14 * drive.view.pixel();
        drive.drag({-2 + outside, 1}, {-9, 1});
        QCOMPARE(drive.points(3), (Points{{-4, 0}, {-3.75, 0}, {-3.875, 2}}));
    }
    void theCursorTellsWhatADragWouldDo() {
        Edited drive({1});
        drive.move({2, 2});
        QCOMPARE(drive.toolbox.cursor(), CursorShape::Move);
        drive.move({1, 0});
        QCOMPARE(drive.toolbox.cursor(), CursorShape::Insert);
        drive.move({5, 5});
        QCOMPARE(drive.toolbox.cursor(), CursorShape::Arrow);
    }
    void theKnifeCutsWhatIsSelectedOrEverything() {
        Edited drive({1});
        drive.toolbox.choose(ToolId::Knife);
        drive.drag({1, 1}, {1, -1});
        QCOMPARE(std::get<BodyObject>(drive.level().objects.find(1)->data).shapes.size(), std::size_t{2});
        drive.document.undo();
        drive.drag({-5, 1}, {5, 1});
        QCOMPARE(std::get<BodyObject>(drive.level().objects.find(3)->data).shapes.size(), std::size_t{1});
        drive.document.undo();
        drive.document.select({});
        drive.drag({-5, 1}, {5, 1});
        QCOMPARE(std::get<BodyObject>(drive.level().objects.find(1)->data).shapes.size(), std::size_t{2});
        QCOMPARE(std::get<BodyObject>(drive.level().objects.find(3)->data).shapes.size(), std::size_t{2});
        QCOMPARE(drive.document.undoLabel().code.text(), std::string("knife"));
        drive.document.undo();
        QCOMPARE(drive.level(), drawing());
    }
    void theKnifeSaysHowManyCutsItMakes() {
        Drive drive(drawing());
        drive.toolbox.choose(ToolId::Knife);
        drive.press({1, 1});
        drive.move({1, 0.5});
        QCOMPARE(drive.toolbox.hint(), (Hint{"knife.nothing", {}}));
        drive.move({1, -1});
        QCOMPARE(drive.toolbox.hint(), (Hint{"knife.cutting", {"1"}}));
        drive.release({1, 0.5});
        QVERIFY(drive.document.history().empty());
    }
};

SPACETOW_TEST(NodeToolTest)
#include "node_tool_test.moc"
