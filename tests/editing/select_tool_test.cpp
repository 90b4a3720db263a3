#include "editor/editing/select_tool.h"

#include "core/base/random.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Balls of radius 0.5: 1 at (0, 0), 2 at (3, 0), 3 at (0, 3), and 4 with radius 1 under 3. Key 5 is off the grid.
Level balls() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 0.5}, {0, 0}));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 0.5}, {3, 0}));
    level.objects.append(bodyWith(4, Circle{{0, 0}, 1}, {0, 3}));
    level.objects.append(bodyWith(3, Circle{{0, 0}, 0.5}, {0, 3}));
    level.objects.append(bodyWith(5, Circle{{0, 0}, 0.2}, {-3.1, 0.05}));
    return level;
}

Vec2 placeOf(const Drive& drive, Key key) {
    return std::get<BodyObject>(drive.level().objects.find(key)->data).position;
}

std::vector<Key> keysOf(const Drive& drive) {
    return drive.document.selection().keys();
}

} // namespace

class SelectToolTest : public QObject {
    Q_OBJECT

  private slots:
    void aClickSelects_data();
    void aClickSelects();
    void altClicksGoDownThePile();
    void aDragMoves_data();
    void aDragMoves();
    void aDragOnSomethingElseSelectsAndMovesIt();
    void altDragMovesTheSelectionFromAnywhere();
    void shiftPressedAfterTheStartKeepsToAnAxis();
    void ctrlInvertsTheGridWhileMoving();
    void whatIsOffTheGridLandsOnIt();
    void aBandSelects_data();
    void aBandSelects();
    void aBandIsNoHistoryEntry();
    void escapeLeavesEverythingAsItWas();
    void aMoveThatComesBackIsNoEntry();
    void aMoveIsOneEntryHoweverManySteps();
    void aConnectorIsSelectedButStaysWithItsBodies();
    void theMenuIsAboutWhatIsUnderThePointer();
    void hintAndCursorTellWhatADragWouldDo();
};

void SelectToolTest::aClickSelects_data() {
    QTest::addColumn<std::vector<Key>>("before");
    QTest::addColumn<Vec2>("at");
    QTest::addColumn<Modifiers>("held");
    QTest::addColumn<std::vector<Key>>("after");

    using Keys = std::vector<Key>;
    QTest::newRow("object") << Keys{} << Vec2(0, 0) << none << Keys{1};
    QTest::newRow("another") << Keys{1} << Vec2(3, 0) << none << Keys{2};
    QTest::newRow("ground") << Keys{1, 2} << Vec2(1.5, 1.5) << none << Keys{};
    QTest::newRow("within six pixels") << Keys{} << Vec2(0.5 + 5.0 / 66, 0) << none << Keys{1};
    QTest::newRow("seven pixels off") << Keys{} << Vec2(0.5 + 7.0 / 66, 0) << none << Keys{};
    QTest::newRow("top of the pile") << Keys{} << Vec2(0, 3) << none << Keys{3};
    QTest::newRow("shift adds") << Keys{1} << Vec2(3, 0) << shift << Keys{1, 2};
    QTest::newRow("shift takes away") << Keys{1, 2} << Vec2(3, 0) << shift << Keys{1};
    QTest::newRow("ctrl adds") << Keys{1} << Vec2(3, 0) << ctrl << Keys{1, 2};
    QTest::newRow("ctrl takes away") << Keys{1, 2} << Vec2(0, 0) << ctrl << Keys{2};
    QTest::newRow("shift on the ground") << Keys{1, 2} << Vec2(1.5, 1.5) << shift << Keys{1, 2};
    QTest::newRow("ctrl on the ground") << Keys{1, 2} << Vec2(1.5, 1.5) << ctrl << Keys{1, 2};
}

void SelectToolTest::aClickSelects() {
    QFETCH(std::vector<Key>, before);
    QFETCH(Vec2, at);
    QFETCH(Modifiers, held);
    QFETCH(std::vector<Key>, after);
    Drive drive(balls());
    drive.document.select(Selection(before));
    drive.held = held;
    drive.click(at);
    QCOMPARE(keysOf(drive), after);
    QVERIFY(drive.document.history().empty());
}

void SelectToolTest::altClicksGoDownThePile() {
    Drive drive(balls());
    drive.held = alt;
    drive.click({0, 3});
    QCOMPARE(keysOf(drive), (std::vector<Key>{3}));
    drive.click({0, 3});
    QCOMPARE(keysOf(drive), (std::vector<Key>{4}));
    drive.click({0, 3});
    QCOMPARE(keysOf(drive), (std::vector<Key>{3}));
}

void SelectToolTest::aDragMoves_data() {
    QTest::addColumn<std::vector<Key>>("selected");
    QTest::addColumn<Vec2>("to");
    QTest::addColumn<Vec2>("delta");

    using Keys = std::vector<Key>;
    QTest::newRow("one") << Keys{1} << Vec2(1, 2) << Vec2(1, 2);
    QTest::newRow("several") << Keys{1, 2, 4} << Vec2(1, 2) << Vec2(1, 2);
    QTest::newRow("by grid steps") << Keys{1} << Vec2(1.1, -0.4) << Vec2(1, -0.5);
    QTest::newRow("by less than half a step") << Keys{1} << Vec2(0.1, 0) << Vec2(0, 0);
}

void SelectToolTest::aDragMoves() {
    QFETCH(std::vector<Key>, selected);
    QFETCH(Vec2, to);
    QFETCH(Vec2, delta);
    Drive drive(balls());
    drive.toolbox.snap.smart = false; // the others are in line with this or that
    drive.document.select(Selection(selected));
    drive.drag({0, 0}, to);
    for (const Object& object : balls().objects) {
        const bool moves = std::find(selected.begin(), selected.end(), object.key) != selected.end();
        const Vec2 start = std::get<BodyObject>(object.data).position;
        QVERIFY(placeOf(drive, object.key) == (moves ? Vec2(start + delta) : start));
    }
    QCOMPARE(keysOf(drive), selected);
}

void SelectToolTest::aDragOnSomethingElseSelectsAndMovesIt() {
    Drive drive(balls());
    drive.document.select(Selection({1}));
    drive.drag({3.2, 0.1}, {4.2, 0.1});
    QCOMPARE(keysOf(drive), (std::vector<Key>{2}));
    QVERIFY(placeOf(drive, 2) == Vec2(4, 0));
    QVERIFY(placeOf(drive, 1) == Vec2(0, 0));
    drive.document.undo();
    QCOMPARE(keysOf(drive), (std::vector<Key>{1}));
}

void SelectToolTest::altDragMovesTheSelectionFromAnywhere() {
    Drive drive(balls());
    drive.document.select(Selection({1}));
    drive.held = alt;
    drive.drag({3, 0}, {4, 1}); // begins on ball 2
    QVERIFY(placeOf(drive, 1) == Vec2(1, 1));
    QVERIFY(placeOf(drive, 2) == Vec2(3, 0));
    drive.drag({-2, -2}, {-2, -3}); // begins on the ground
    QVERIFY(placeOf(drive, 1) == Vec2(1, 0));
    QCOMPARE(keysOf(drive), (std::vector<Key>{1}));
}

void SelectToolTest::shiftPressedAfterTheStartKeepsToAnAxis() {
    Drive drive(balls());
    drive.press({0, 0});
    drive.move({1, 0.6});
    drive.held = shift;
    drive.move({2, 0.9});
    QVERIFY(placeOf(drive, 1) == Vec2(2, 0));
    drive.move({0.9, -2});
    QVERIFY(placeOf(drive, 1) == Vec2(0, -2));
    drive.held = {true, true, false};
    drive.move({2.1, 0.9});
    QVERIFY(placeOf(drive, 1) == Vec2(2.1, 0));
    drive.release({2.1, 0.9});
    QVERIFY(placeOf(drive, 1) == Vec2(2.1, 0));
}

void SelectToolTest::ctrlInvertsTheGridWhileMoving() {
    Drive drive(balls());
    drive.press({0, 0});
    drive.held = ctrl;
    drive.move({1.1, 0.3});
    drive.release({1.1, 0.3});
    QVERIFY(placeOf(drive, 1) == Vec2(1.1, 0.3));
    drive.toolbox.snap.grid = drive.toolbox.snap.smart = drive.toolbox.snap.alignment = false;
    drive.held = none;
    drive.press({1.1, 0.3});
    drive.held = ctrl;
    drive.release({2.1, 0.3});
    QVERIFY(placeOf(drive, 1) == Vec2(2, 0.25));
}

void SelectToolTest::whatIsOffTheGridLandsOnIt() {
    Drive drive(balls());
    drive.drag({-3.1, 0.05}, {-2.6, 0.05});
    QVERIFY((placeOf(drive, 5) - Vec2(-2.5, 0)).norm() < 1e-12);
}

void SelectToolTest::aBandSelects_data() {
    QTest::addColumn<std::vector<Key>>("before");
    QTest::addColumn<Vec2>("from");
    QTest::addColumn<Vec2>("to");
    QTest::addColumn<Modifiers>("held");
    QTest::addColumn<std::vector<Key>>("after");

    using Keys = std::vector<Key>;
    QTest::newRow("touches") << Keys{} << Vec2(-1, -1) << Vec2(2.6, 1) << none << Keys{1, 2};
    QTest::newRow("backwards") << Keys{} << Vec2(2.6, 1) << Vec2(-1, -1) << none << Keys{1, 2};
    QTest::newRow("replaces") << Keys{4, 5} << Vec2(-1, -1) << Vec2(2.6, 1) << none << Keys{1, 2};
    QTest::newRow("alt encloses") << Keys{} << Vec2(-1, -1) << Vec2(2.6, 1) << alt << Keys{1};
    QTest::newRow("shift adds") << Keys{4} << Vec2(-1, -1) << Vec2(2.6, 1) << shift << Keys{1, 2, 4};
    QTest::newRow("ctrl adds") << Keys{4} << Vec2(-1, -1) << Vec2(2.6, 1) << ctrl << Keys{1, 2, 4};
    QTest::newRow("shift on an object") << Keys{} << Vec2(0, 0) << Vec2(3, 0.2) << shift << Keys{1, 2};
    QTest::newRow("of nothing") << Keys{1} << Vec2(-1, -1) << Vec2(-2, -2) << none << Keys{};
}

void SelectToolTest::aBandSelects() {
    QFETCH(std::vector<Key>, before);
    QFETCH(Vec2, from);
    QFETCH(Vec2, to);
    QFETCH(Modifiers, held);
    QFETCH(std::vector<Key>, after);
    Drive drive(balls());
    drive.document.select(Selection(before));
    drive.held = held;
    drive.press(from);
    drive.move(0.5 * (from + to));
    drive.move(to);
    QCOMPARE(keysOf(drive), after); // while the band is drawn
    QCOMPARE(drive.toolbox.overlay().lines.size(), std::size_t{1});
    QCOMPARE(drive.toolbox.hint(), (Hint{"select.band", {std::to_string(after.size())}}));
    drive.release(to);
    QCOMPARE(keysOf(drive), after);
    QVERIFY(drive.level() == balls());
}

void SelectToolTest::aBandIsNoHistoryEntry() {
    Drive drive(balls());
    drive.drag({-1, -1}, {5, 5});
    QVERIFY(drive.document.history().empty());
    QVERIFY(!drive.document.hasPreview());
}

void SelectToolTest::escapeLeavesEverythingAsItWas() {
    for (const Vec2& from : {Vec2(3, 0), Vec2(1.5, 1.5)}) { // a move, a band
        Drive drive(balls());
        drive.document.select(Selection({1}));
        drive.press(from);
        drive.move(from + Vec2(2, 2));
        drive.key(ToolKey::Escape);
        QVERIFY(drive.level() == balls());
        QCOMPARE(keysOf(drive), (std::vector<Key>{1}));
        drive.move(from + Vec2(3, 3));
        drive.release(from + Vec2(3, 3));
        QVERIFY(drive.level() == balls());
        QCOMPARE(keysOf(drive), (std::vector<Key>{1}));
        QVERIFY(drive.document.history().empty());
    }
}

void SelectToolTest::aMoveThatComesBackIsNoEntry() {
    Drive drive(balls());
    drive.press({0, 0});
    drive.move({2, 1});
    drive.move({0, 0});
    drive.release({0, 0});
    QVERIFY(drive.document.history().empty());
    QVERIFY(!drive.document.isModified());
    QCOMPARE(keysOf(drive), (std::vector<Key>{1}));
}

void SelectToolTest::aMoveIsOneEntryHoweverManySteps() {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        Random random(seed);
        Drive drive(balls());
        drive.press({0, 0});
        for (std::uint32_t i = 0; i < 2 + random.below(50); ++i) {
            drive.move({random.uniform(-5, 5), random.uniform(-5, 5)});
        }
        drive.release({2, -1});
        QCOMPARE(drive.document.history(), (std::vector<Label>{{"move", 1}}));
        QVERIFY2(placeOf(drive, 1) == Vec2(2, -1), qPrintable(QString("seed %1").arg(seed)));
        drive.document.undo();
        QVERIFY(drive.level() == balls());
    }
}

void SelectToolTest::aConnectorIsSelectedButStaysWithItsBodies() {
    Level level = balls();
    ConnectorObject connector;
    connector.a = 1;
    connector.b = 2;
    level.objects.append({8, "rope", connector, {}});
    Drive drive(level);
    drive.click({1.5, 0.05});
    QCOMPARE(keysOf(drive), (std::vector<Key>{8}));
    drive.drag({1.5, 0}, {1.5, 2});
    QVERIFY(drive.level() == level);
    QVERIFY(drive.document.history().empty());
    drive.toolbox.snap.smart = false;
    drive.document.select(Selection({1, 8}));
    drive.drag({1.5, 0}, {1.6, 2.1});
    QVERIFY(placeOf(drive, 1) == Vec2(0, 2));
}

void SelectToolTest::theMenuIsAboutWhatIsUnderThePointer() {
    Drive drive(balls());
    drive.document.select(Selection({1, 2}));
    QVERIFY(!drive.secondaryClick({0, 0}));
    QCOMPARE(keysOf(drive), (std::vector<Key>{1, 2}));
    QVERIFY(!drive.secondaryClick({0, 3}));
    QCOMPARE(keysOf(drive), (std::vector<Key>{3}));
    QVERIFY(!drive.secondaryClick({1.5, 1.5}));
    QCOMPARE(keysOf(drive), (std::vector<Key>{3}));
}

void SelectToolTest::hintAndCursorTellWhatADragWouldDo() {
    Drive drive(balls());
    drive.move({1.5, 1.5});
    QCOMPARE(drive.toolbox.hint().code, std::string("select.idle"));
    QCOMPARE(drive.toolbox.cursor(), CursorShape::Arrow);
    drive.move({0, 0});
    QCOMPARE(drive.toolbox.hint().code, std::string("select.object"));
    QCOMPARE(drive.toolbox.cursor(), CursorShape::Pointing);
    drive.click({0, 0});
    QCOMPARE(drive.toolbox.hint(), (Hint{"select.selected", {"1"}}));
    QCOMPARE(drive.toolbox.cursor(), CursorShape::Move);
    drive.press({0, 0});
    drive.move({1.1, -0.5});
    QCOMPARE(drive.toolbox.hint(), (Hint{"select.moving", {"1.00", "-0.50"}}));
    QCOMPARE(drive.toolbox.cursor(), CursorShape::Move);
}

SPACETOW_TEST(SelectToolTest)
#include "select_tool_test.moc"
