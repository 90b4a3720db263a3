#include "core/level/groups.h"

#include "core/level/bounds.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

Object ball(Key key, Key parent, const Vec2& position = {0, 0}) {
    BodyObject body;
    body.position = position;
    body.shapes = {Circle{{0, 0}, 1}};
    return {key, "ball", body, {}, parent};
}

Object group(Key key, Key parent = 0, bool layer = false) {
    return {key, "group", GroupObject{layer, {}}, {}, parent};
}

/// A layer (1) with a ball (2) and a group (3) of two balls (4, 5); a ball (6) at the top.
Level nested() {
    Level level;
    level.objects.append(group(1, 0, true));
    level.objects.append(ball(2, 1));
    level.objects.append(group(3, 1));
    level.objects.append(ball(4, 3, {2, 0}));
    level.objects.append(ball(5, 3, {6, 0}));
    level.objects.append(ball(6, 0, {20, 0}));
    return level;
}

std::vector<Key> allKeysOf(const Level& level) {
    std::vector<Key> keys;
    for (const Object& object : level.objects) {
        keys.push_back(object.key);
    }
    return keys;
}

const Object& at(const Level& level, Key key) {
    return *level.objects.find(key);
}

using Keys = std::vector<Key>;

} // namespace

class GroupsTest : public QObject {
    Q_OBJECT

  private slots:
    void aGroupPassesHidingAndLockingOnToItsMembers() {
        Level level = withVisible(nested(), Keys{1}, false);
        level = withLocked(std::move(level), Keys{3}, true);
        const GroupTree tree(level);
        QVERIFY(!tree.isVisible(at(level, 5)));
        QVERIFY(!tree.isVisible(at(level, 2)));
        QVERIFY(tree.isVisible(at(level, 6)));
        QVERIFY(tree.isLocked(at(level, 5)));
        QVERIFY(!tree.isLocked(at(level, 2)));
    }

    void aClickAtTheTopReachesTheOutermostGroupButNoLayer() {
        const Level level = nested();
        const GroupTree tree(level);
        QCOMPARE(tree.memberOf(0, at(level, 5))->key, Key{3});
        QCOMPARE(tree.memberOf(0, at(level, 2))->key, Key{2});
        QCOMPARE(tree.memberOf(3, at(level, 5))->key, Key{5});
        QVERIFY(tree.memberOf(3, at(level, 6)) == nullptr);
        QCOMPARE(selectableKeys(level, 0), (Keys{2, 3, 6}));
        QCOMPARE(selectableKeys(level, 3), (Keys{4, 5}));
    }

    void whatIsHiddenOrLockedCannotBeSelected() {
        Level level = withVisible(nested(), Keys{2}, false);
        level = withLocked(std::move(level), Keys{3}, true);
        QCOMPARE(selectableKeys(level, 0), (Keys{6}));
        QVERIFY(selectableKeys(level, 3).empty());
    }

    void aCircleOfParentsCountsAsBeingAtTheTop() {
        Level level;
        level.objects.append(group(1, 2));
        level.objects.append(group(2, 1));
        level.objects.append(group(3, 3));
        level.objects.append(ball(4, 1));
        level.objects.append(ball(5, 4));
        level.objects.append(ball(6, 77));
        const GroupTree tree(level);
        for (const Object& object : level.objects) {
            QVERIFY(tree.parentOf(object) == nullptr);
        }
        QCOMPARE(withMembers(level, Keys{1, 3}), (Keys{1, 3}));
    }

    void withMembersGoesAllTheWayDown() {
        QCOMPARE(withMembers(nested(), Keys{1}), (Keys{1, 2, 3, 4, 5}));
        QCOMPARE(withMembers(nested(), Keys{6, 3}), (Keys{3, 4, 5, 6}));
    }

    void movingAGroupMovesItsMembers() {
        const Level level = moved(nested(), Keys{3}, {1, 2});
        QVERIFY((std::get<BodyObject>(at(level, 4).data).position == Vec2(3, 2)));
        QVERIFY((std::get<BodyObject>(at(level, 5).data).position == Vec2(7, 2)));
        QVERIFY(at(level, 2) == at(nested(), 2));
    }

    void theBoundsOfAGroupAreThoseOfItsMembers() {
        const Level level = nested();
        const Aabb box = boundsOf(level, at(level, 3));
        QVERIFY((box.min == Vec2(1, -1) && box.max == Vec2(7, 1)));
    }

    void removingAGroupRemovesItsMembersAndTheLastMemberItsGroup() {
        QCOMPARE(allKeysOf(removed(nested(), Keys{3})), (Keys{1, 2, 6}));
        QCOMPARE(allKeysOf(removed(nested(), Keys{4, 5})), (Keys{1, 2, 6}));
        QCOMPARE(allKeysOf(removed(nested(), Keys{2, 3})), (Keys{1, 6}));
    }

    void copiesOfAGroupHaveCopiesOfItsMembers() {
        std::vector<Key> copies;
        const Level level = duplicated(nested(), Keys{3}, {{0, 5}, 1}, copies);
        QCOMPARE(level.objects.size(), 9);
        QCOMPARE(copies.size(), std::size_t{1});
        QCOMPARE(at(level, copies.front()).parent, Key{1});
        QCOMPARE(level.objects[7].parent, copies.front());
        QVERIFY((std::get<BodyObject>(level.objects[7].data).position == Vec2(2, 5)));
    }

    void groupingAndUngroupingGivesTheLevelBack() {
        const Level before = nested();
        const Level level = grouped(before, Keys{4, 5}, group(9));
        QCOMPARE(at(level, 9).parent, Key{3});
        QCOMPARE(at(level, 4).parent, Key{9});
        QVERIFY(ungrouped(level, Keys{9}) == before);
    }

    void whatIsGroupedWithItsGroupStaysInIt() {
        const Level level = grouped(nested(), Keys{3, 4, 6}, group(9));
        QCOMPARE(at(level, 4).parent, Key{3});
        QCOMPARE(at(level, 3).parent, Key{9});
        QCOMPARE(at(level, 6).parent, Key{9});
        QCOMPARE(at(level, 9).parent, Key{1});
    }

    void aGroupAtTheTopOfALayerStaysInTheLayer() {
        const Level level = grouped(nested(), Keys{2}, group(9));
        QCOMPARE(at(level, 9).parent, Key{1});
    }

    void regroupingPutsObjectsWhereTheyAreWanted() {
        const Level level = regrouped(nested(), Keys{6}, {3, 5});
        QCOMPARE(allKeysOf(level), (Keys{1, 2, 3, 4, 6, 5}));
        QCOMPARE(at(level, 6).parent, Key{3});
    }

    void whatIsPutIntoAGroupComesToLieOnTopOfItsMembers() {
        const Level level = regrouped(nested(), Keys{6}, {3, 0});
        QCOMPARE(allKeysOf(level), (Keys{1, 2, 3, 4, 5, 6}));
        QCOMPARE(allKeysOf(regrouped(nested(), Keys{2}, {3, 0})), (Keys{1, 3, 4, 5, 2, 6}));
        QCOMPARE(allKeysOf(regrouped(nested(), Keys{4}, {0, 0})), (Keys{1, 2, 3, 5, 6, 4}));
    }

    void aGroupTakesItsMembersAlong() {
        const Level level = regrouped(nested(), Keys{3}, {0, 0});
        QCOMPARE(allKeysOf(level), (Keys{1, 2, 6, 3, 4, 5}));
        QCOMPARE(at(level, 3).parent, Key{0});
        QCOMPARE(at(level, 5).parent, Key{3});
        QCOMPARE(allKeysOf(regrouped(level, Keys{3}, {1, 2})), (Keys{1, 3, 4, 5, 2, 6}));
    }

    void severalKeepTheirOrder() {
        const Level level = regrouped(nested(), Keys{6, 5, 2}, {3, 4});
        QCOMPARE(allKeysOf(level), (Keys{1, 3, 2, 5, 6, 4}));
    }

    void puttingSomethingBeforeItselfChangesNothing() {
        QVERIFY(regrouped(nested(), Keys{4}, {3, 4}) == nested());
        QVERIFY(regrouped(nested(), Keys{2, 3}, {1, 3}) == nested());
    }

    void aLayerStaysAtTheTop() {
        Level level = nested();
        level.objects.append(group(7, 0, true));
        level.objects.append(group(8));
        QVERIFY(regrouped(level, Keys{7}, {8, 0}) == level);
        QCOMPARE(at(regrouped(level, Keys{6, 7}, {8, 0}), 6).parent, Key{8});
        QCOMPARE(allKeysOf(regrouped(level, Keys{7}, {0, 1})), (Keys{7, 1, 2, 3, 4, 5, 6, 8}));
        QVERIFY(grouped(level, Keys{7}, group(9)) == level);
    }

    void whatIsNotMovedKeepsItsPiece() {
        const Level before = nested();
        const Level after = regrouped(before, Keys{2}, {0, 0});
        QVERIFY(after.objects.find(6) == before.objects.find(6));
        QVERIFY(after.objects.find(5) == before.objects.find(5));
    }

    void aGroupCannotComeToBeInItself() {
        const Level before = nested();
        QVERIFY(regrouped(before, Keys{1}, {3, 0}) == before);
        QVERIFY(regrouped(before, Keys{3}, {3, 0}) == before);
        QVERIFY(regrouped(before, Keys{6}, {2, 0}) == before);
        QVERIFY(regrouped(before, Keys{6}, {77, 0}) == before);
    }

    void randomGroupsSurviveTheFile() {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const Level level = randomLevel(seed, 20);
            const LevelFile file = parseLevel(levelText(level));
            QVERIFY2(file.level && *file.level == level, qPrintable(QStringLiteral("seed %1").arg(seed)));
        }
    }
};

SPACETOW_TEST(GroupsTest)
#include "groups_test.moc"
