#include "editor/editing/group_picking.h"

#include "core/level/groups.h"
#include "core/level/object_geometry.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using PickedKeys = std::vector<Key>;

/// Balls of radius 0.5: 1 at (0, 0) and 2 at (2, 0) in group 10, which is in group 11 with 3 at (4, 0); 4 at (8, 0).
Level nested() {
    Level level;
    for (const Key key : PickedKeys{1, 2, 3, 4}) {
        level.objects.append(bodyWith(key, Circle{{0, 0}, 0.5}, {key == 4 ? 8.0 : 2.0 * (key - 1), 0}));
    }
    level = grouped(std::move(level), PickedKeys{1, 2}, {10, "pair", GroupObject{}, {}});
    return grouped(std::move(level), PickedKeys{10, 3}, {11, "three", GroupObject{}, {}});
}

struct Groups : Drive {
    Groups() : Drive(nested()) {}
    const PickedKeys& keys() const { return document.selection().keys(); }
    Key entered() const { return document.selection().entered(); }
    Vec2 placeOf(Key key) const { return *spacetow::placeOf(level().objects.find(key)->data); }
};

} // namespace

class GroupPickingTest : public QObject {
    Q_OBJECT

  private slots:
    void aClickSelectsTheOutermostGroupAndADragMovesAllOfIt() {
        Groups drive;
        drive.click({0, 0});
        QCOMPARE(drive.keys(), (PickedKeys{11}));
        drive.drag({2, 0}, {2, 1.1});
        QVERIFY(drive.placeOf(1) == Vec2(0, 1));
        QVERIFY(drive.placeOf(3) == Vec2(4, 1));
        QVERIFY(drive.placeOf(4) == Vec2(8, 0));
    }

    void aDoubleClickEntersAndEscapeLeavesOneLevelAtATime() {
        Groups drive;
        drive.doubleClick({0, 0});
        QCOMPARE(drive.entered(), Key{11});
        QCOMPARE(drive.keys(), (PickedKeys{10}));
        drive.doubleClick({0, 0});
        QCOMPARE(drive.entered(), Key{10});
        QCOMPARE(drive.keys(), (PickedKeys{1}));
        drive.move({0, 3});
        QCOMPARE(drive.toolbox.hint(), (Hint{"select.in-named-group", {"1", "pair"}}));
        QVERIFY(drive.toolbox.overlay().spotlight.contains(Vec2(2, 0)));
        QVERIFY(!drive.toolbox.overlay().spotlight.contains(Vec2(4, 0)));
        drive.click({2, 0});
        QCOMPARE(drive.keys(), (PickedKeys{2}));
        drive.key(ToolKey::Escape);
        QCOMPARE(drive.entered(), Key{11});
        QCOMPARE(drive.keys(), (PickedKeys{10}));
        drive.key(ToolKey::Escape);
        QCOMPARE(drive.entered(), Key{0});
        QCOMPARE(drive.keys(), (PickedKeys{11}));
        drive.key(ToolKey::Escape);
        QVERIFY(drive.keys().empty());
        QVERIFY(drive.document.history().empty());
        QVERIFY(drive.toolbox.overlay().spotlight.isEmpty());
    }

    void aClickOutsideLeavesTheGroup() {
        Groups drive;
        drive.doubleClick({0, 0});
        drive.click({8, 0});
        QCOMPARE(drive.entered(), Key{0});
        QCOMPARE(drive.keys(), (PickedKeys{4}));
        drive.doubleClick({0, 0});
        drive.doubleClick({0, 5}); // on empty ground
        QCOMPARE(drive.entered(), Key{0});
        QCOMPARE(drive.keys(), (PickedKeys{11}));
    }

    void ctrlClickSelectsInGroupsDirectly() {
        Groups drive;
        drive.held = {false, true, false};
        drive.click({2, 0});
        QCOMPARE(drive.keys(), (PickedKeys{2}));
        QCOMPARE(drive.entered(), Key{10});
        drive.click({0, 0}); // a member of the group that is entered now: added
        QCOMPARE(drive.keys(), (PickedKeys{1, 2}));
    }

    void aBandSelectsWhatIsAMemberWhereOneIs() {
        Groups drive;
        drive.drag({-1, -1}, {9, 1});
        QCOMPARE(drive.keys(), (PickedKeys{4, 11}));
        drive.doubleClick({0, 0});
        drive.drag({-1, -1}, {9, 1});
        QCOMPARE(drive.keys(), (PickedKeys{3, 10}));
        QCOMPARE(drive.entered(), Key{11});
    }

    void aBandThatEnclosesWantsAllOfTheGroup() {
        Groups drive;
        drive.press({-1, -1});
        drive.held = {false, false, true};
        drive.move({3, 1}); // round 1 and 2 only
        QVERIFY(drive.keys().empty());
        drive.move({5, 1});
        QCOMPARE(drive.keys(), (PickedKeys{11}));
    }

    void altClicksGoThroughWhatLiesUnderThePointer() {
        Groups drive;
        Level level = nested();
        level.objects.append(bodyWith(5, Circle{{0, 0}, 1}, {0, 0}));
        drive.document.reset(level);
        drive.held = {false, false, true};
        drive.click({0, 0});
        QCOMPARE(drive.keys(), (PickedKeys{11}));
        drive.click({0, 0});
        QCOMPARE(drive.keys(), (PickedKeys{5}));
        drive.click({0, 0});
        QCOMPARE(drive.keys(), (PickedKeys{11}));
    }

    void aLassoTakesWhatItTouchesOrWithCtrlWhatItEncloses() {
        Groups drive;
        drive.held = {true, false, true};
        const Vec2 center(8, 0);
        drive.press(center + Vec2(0.4, 0));
        for (int i = 1; i < 24; ++i) {
            drive.move(center + 0.4 * (Rot::fromAngle(i * std::numbers::pi / 12) * Vec2(1, 0)));
        }
        QCOMPARE(drive.keys(), (PickedKeys{4}));
        QCOMPARE(drive.toolbox.hint(), (Hint{"select.lasso", {"1"}}));
        drive.held = {true, true, true};
        drive.move(center + Vec2(0.4, -0.05));
        QVERIFY(drive.keys().empty());
        drive.held = {true, false, true};
        drive.release(center + Vec2(0.4, -0.05));
        QCOMPARE(drive.keys(), (PickedKeys{4}));
        drive.press({-1, -1});
        for (const Vec2& point : {Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
            drive.move(point);
        }
        drive.release({-1, 0.5});
        QCOMPARE(drive.keys(), (PickedKeys{4, 11}));
        QVERIFY(drive.document.history().empty());
    }
};

SPACETOW_TEST(GroupPickingTest)
#include "group_picking_test.moc"
