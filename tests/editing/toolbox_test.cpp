#include "editor/editing/toolbox.h"

#include "core/base/random.h"
#include "editor/editing/codes.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level oneBall() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 0.5}));
    return level;
}

/// Tools ask each other, so it may be another one's.
bool isHintOfATool(const std::string& code) {
    return std::ranges::find(sharedHintCodes, code) != sharedHintCodes.end() ||
           std::ranges::any_of(toolRows(), [&code](const ToolRow& tool) {
               return std::ranges::find(tool.hints, code) != tool.hints.end();
           });
}

Vec2 ballPlace(const Drive& drive) {
    return std::get<BodyObject>(drive.level().objects.find(1)->data).position;
}

} // namespace

class ToolboxTest : public QObject {
    Q_OBJECT

  private slots:
    void aDragStartsAfterFourPixels_data();
    void aDragStartsAfterFourPixels();
    void aDragInOneJumpCounts();
    void escapePeelsOneLayerAPress();
    void deleteRemovesTheSelection_data();
    void deleteRemovesTheSelection();
    void keysDoNothingDuringADrag();
    void aLostReleaseDoesNotStick();
    void aReleaseWithoutAPressDoesNothing();
    void undoDuringADragEndsIt();
    void choosingAToolDropsWhatIsHalfDone();
    void theSecondaryButtonOpensNoMenuDuringADrag();
    void verbsAreFinishedHere();
    void everyContextHasAnotherSeed();
    void theSameSeedGivesTheSameKeys();
    void theLastLookAtTheDocumentOutlivesTheToolbox();
    void anyInputLeavesASoundState();
};

void ToolboxTest::aDragStartsAfterFourPixels_data() {
    QTest::addColumn<double>("pixels");
    QTest::addColumn<bool>("drags");
    QTest::newRow("four") << 4.0 << false;
    QTest::newRow("a little more") << 4.1 << true;
}

void ToolboxTest::aDragStartsAfterFourPixels() {
    QFETCH(double, pixels);
    QFETCH(bool, drags);
    Drive drive(oneBall());
    drive.toolbox.snap.grid = false;
    const Vec2 way(pixels * drive.view.pixel(), 0);
    drive.press({0, 0});
    drive.move(way);
    QCOMPARE(drive.document.hasPreview(), drags);
    drive.release(way);
    QCOMPARE(ballPlace(drive) != Vec2(0, 0), drags);
    drive.document.undo();
    drive.press({0, 0});
    drive.move({1, 0});
    drive.move({0, 0.02}); // once it is a drag it stays one
    drive.release({0, 0.02});
    QVERIFY(ballPlace(drive) == Vec2(0, 0.02));
}

void ToolboxTest::aDragInOneJumpCounts() {
    Drive drive(oneBall());
    drive.press({0, 0});
    drive.release({2, 0});
    QVERIFY(ballPlace(drive) == Vec2(2, 0));
}

void ToolboxTest::escapePeelsOneLayerAPress() {
    Drive drive(oneBall());
    drive.document.select(Selection({1}));
    drive.toolbox.choose(ToolId::Edge);
    drive.click({{2, 0}, {3, 0}});
    drive.press({3, 3});
    drive.move({4, 4});

    drive.key(ToolKey::Escape); // the drag
    drive.release({4, 4});
    QVERIFY(drive.toolbox.isBusy());
    drive.key(ToolKey::Escape); // the shape
    QVERIFY(!drive.toolbox.isBusy());
    QCOMPARE(drive.document.selection().size(), 1);
    drive.key(ToolKey::Escape); // the selection
    QVERIFY(drive.document.selection().empty());
    QCOMPARE(drive.toolbox.current(), ToolId::Edge);
    drive.key(ToolKey::Escape); // the tool
    QCOMPARE(drive.toolbox.current(), ToolId::Select);
    drive.key(ToolKey::Escape);
    QVERIFY(drive.level() == oneBall());
}

void ToolboxTest::deleteRemovesTheSelection_data() {
    QTest::addColumn<int>("tool");
    QTest::addColumn<bool>("backspace");
    for (const auto& [tool, make, hints] : toolRows()) {
        for (const bool backspace : {false, true}) {
            QTest::addRow("tool %d %s", static_cast<int>(tool), backspace ? "backspace" : "delete")
                << static_cast<int>(tool) << backspace;
        }
    }
}

void ToolboxTest::deleteRemovesTheSelection() {
    QFETCH(int, tool);
    QFETCH(bool, backspace);
    Drive drive(oneBall());
    drive.toolbox.choose(static_cast<ToolId>(tool));
    const ToolKey key = backspace ? ToolKey::Backspace : ToolKey::Delete;
    drive.key(key);
    QVERIFY(drive.document.history().empty());
    drive.document.select(Selection({1}));
    drive.key(key);
    QVERIFY(drive.level().objects.empty());
    QVERIFY(drive.document.selection().empty());
    QCOMPARE(drive.document.history(), (std::vector<Label>{{"delete", 1}}));
}

void ToolboxTest::keysDoNothingDuringADrag() {
    Drive drive(oneBall());
    drive.press({0, 0});
    drive.move({1, 0});
    drive.key(ToolKey::Delete);
    drive.key(ToolKey::Enter);
    drive.release({1, 0});
    QVERIFY(ballPlace(drive) == Vec2(1, 0));
    QCOMPARE(drive.document.history().size(), std::size_t{1});
}

void ToolboxTest::aLostReleaseDoesNotStick() {
    Drive drive(oneBall());
    drive.press({0, 0});
    drive.move({1, 0});
    drive.click({5, 5}); // a press although the button never came up
    QVERIFY(drive.level() == oneBall());
    QVERIFY(!drive.document.hasPreview());
    drive.move({2, 0});
    QVERIFY(drive.level() == oneBall());
}

void ToolboxTest::aReleaseWithoutAPressDoesNothing() {
    for (const auto& [tool, make, hints] : toolRows()) {
        Drive drive(oneBall());
        drive.toolbox.choose(tool);
        drive.release({0, 0});
        QVERIFY(drive.level() == oneBall());
        QVERIFY(!drive.toolbox.isBusy());
        QVERIFY(drive.document.selection().empty());
    }
}

void ToolboxTest::undoDuringADragEndsIt() {
    Drive drive(oneBall());
    drive.drag({0, 0}, {1, 0});
    drive.press({1, 0});
    drive.move({3, 0});
    drive.document.undo();
    QVERIFY(drive.level() == oneBall());
    drive.move({4, 0});
    drive.release({4, 0});
    QVERIFY(drive.level() == oneBall());
    QVERIFY(drive.document.canRedo());
}

void ToolboxTest::choosingAToolDropsWhatIsHalfDone() {
    Drive drive(oneBall());
    drive.toolbox.choose(ToolId::Polygon);
    drive.click({{2, 0}, {3, 0}});
    drive.toolbox.choose(ToolId::Select);
    drive.toolbox.choose(ToolId::Polygon);
    QVERIFY(!drive.toolbox.isBusy());
    drive.toolbox.choose(ToolId::Select);
    drive.press({0, 0});
    drive.move({2, 0});
    drive.toolbox.choose(ToolId::Line);
    QVERIFY(drive.level() == oneBall());
    QVERIFY(!drive.document.hasPreview());
}

void ToolboxTest::theSecondaryButtonOpensNoMenuDuringADrag() {
    Drive drive(oneBall());
    QVERIFY(!drive.secondaryClick({0, 0}));
    drive.press({0, 0});
    drive.move({2, 0});
    QVERIFY(drive.secondaryClick({2, 0}));
    drive.release({2, 0});
    QVERIFY(ballPlace(drive) == Vec2(2, 0));
}

void ToolboxTest::verbsAreFinishedHere() {
    Drive drive(oneBall());
    QVERIFY(!drive.toolbox.finish(std::nullopt));
    Level level = oneBall();
    level.name = "named";
    QVERIFY(drive.toolbox.finish(FinishedEdit{{"move", 1}, {std::make_shared<const Level>(level), {}}}));
    QVERIFY(drive.level() == level);
    QCOMPARE(drive.document.history().size(), std::size_t{1});
}

void ToolboxTest::everyContextHasAnotherSeed() {
    Drive drive;
    std::set<std::uint64_t> seeds;
    for (int i = 0; i < 100; ++i) {
        QVERIFY(seeds.insert(drive.toolbox.context().seed).second);
    }
}

void ToolboxTest::theSameSeedGivesTheSameKeys() {
    const auto draw = [](std::uint64_t seed) {
        Document document;
        Toolbox toolbox(document, seed);
        toolbox.choose(ToolId::Circle);
        toolbox.press({{0, 0}, {0, 0}, {}, 0.01});
        toolbox.release({{1, 0}, {100, 0}, {}, 0.01});
        return document.level().objects[0].key;
    };
    QCOMPARE(draw(5), draw(5));
    QVERIFY(draw(5) != draw(6));
}

void ToolboxTest::theLastLookAtTheDocumentOutlivesTheToolbox() {
    Document document;
    { const Toolbox toolbox(document); }
    document.markSaved(); // tells nobody who is gone
    QVERIFY(!document.isModified());
}

/// A monkey at the mouse: whatever it does, hints are known, undo takes everything back, and no preview is left over.
void ToolboxTest::anyInputLeavesASoundState() {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        Random random(seed);
        Drive drive(oneBall());
        const auto somewhere = [&random] {
            return Vec2(0.5 * (random.below(13) - 6.0), 0.5 * (random.below(9) - 4.0));
        };
        for (int i = 0; i < 120; ++i) {
            drive.held = {random.below(4) == 0, random.below(4) == 0, random.below(4) == 0};
            switch (random.below(12)) {
            case 0:
                drive.toolbox.choose(toolRows()[random.below(toolRows().size())].id);
                break;
            case 1:
                drive.press(somewhere());
                break;
            case 2:
                drive.release(somewhere());
                break;
            case 3:
                drive.doubleClick(somewhere());
                break;
            case 4:
                drive.secondaryClick(somewhere());
                break;
            case 5:
                drive.key(static_cast<ToolKey>(random.below(4)));
                break;
            case 6:
                drive.document.undo();
                break;
            case 7:
                drive.drag(somewhere(), somewhere());
                break;
            case 8:
                drive.document.redo();
                break;
            case 9:
                drive.move(somewhere());
                break;
            default:
                drive.click(somewhere());
            }
            const Hint hint = drive.toolbox.hint();
            QVERIFY2(isHintOfATool(hint.code), hint.code.c_str());
            const Overlay overlay = drive.toolbox.overlay();
            QVERIFY(overlay.lines.size() < 5000);
            QVERIFY(drive.document.selection() == drive.document.selection().within(drive.level()));
        }
        drive.toolbox.cancel();
        QVERIFY2(!drive.document.hasPreview() && !drive.toolbox.isBusy(), qPrintable(QString("seed %1").arg(seed)));
        drive.document.goTo(0);
        QVERIFY2(drive.level() == oneBall(), qPrintable(QString("seed %1").arg(seed)));
    }
}

SPACETOW_TEST(ToolboxTest)
#include "toolbox_test.moc"
