#include "core/level/arrange.h"

#include "core/geometry/polygon.h"
#include "core/level/arrays.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "core/level/groups.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using ArrangeKeys = std::vector<Key>;

Object boxWith(Key key, const Vec2& position, const Vec2& size, Key parent = 0) {
    BodyObject body;
    body.position = position;
    body.shapes = {Polygon{{{0, 0}, {size.x(), 0}, size, {0, size.y()}}}};
    return {key, "box", body, {}, parent};
}

/// Three arrangedBoxes: 1 at (0, 0) 1 × 1, 2 at (2, 1) 2 × 1, 3 at (7, 3) 1 × 2.
Level arrangedBoxes() {
    Level level;
    level.objects.append(boxWith(1, {0, 0}, {1, 1}));
    level.objects.append(boxWith(2, {2, 1}, {2, 1}));
    level.objects.append(boxWith(3, {7, 3}, {1, 2}));
    return level;
}

Aabb boxOf(const Level& level, Key key) {
    return placedBounds(level, ArrangeKeys{key});
}

ArrangeKeys arrangedKeys(const Level& level) {
    ArrangeKeys keys;
    for (const Object& object : level.objects) {
        keys.push_back(object.key);
    }
    return keys;
}

} // namespace

class ArrangeTest : public QObject {
    Q_OBJECT

  private slots:
    void lockedMembersKeepTheirGroupFromBeingTouched() {
        Level level = arrangedBoxes();
        level = grouped(std::move(level), ArrangeKeys{1, 2}, {9, "group", GroupObject{}, {}});
        QCOMPARE(unlockedKeys(level, ArrangeKeys{9, 3}), (ArrangeKeys{1, 2, 3, 9}));
        level = withLocked(std::move(level), ArrangeKeys{2}, true);
        QCOMPARE(unlockedKeys(level, ArrangeKeys{9, 3}), (ArrangeKeys{1, 3}));
        level = withLocked(std::move(level), ArrangeKeys{9}, true);
        QCOMPARE(unlockedKeys(level, ArrangeKeys{9, 3}), (ArrangeKeys{3}));
        QCOMPARE(unlockedKeys(level, ArrangeKeys{77}), ArrangeKeys());
    }

    void flippingSwapsSidesWithinTheBounds() {
        const Level level = flipped(arrangedBoxes(), ArrangeKeys{1, 2}, FlipAxis::Horizontal);
        QVERIFY(boxOf(level, 1).min == Vec2(3, 0));
        QVERIFY(boxOf(level, 2).min == Vec2(0, 1));
        QVERIFY(boxOf(level, 3).min == Vec2(7, 3));
        const Level upright = flipped(arrangedBoxes(), ArrangeKeys{1, 2}, FlipAxis::Vertical);
        QVERIFY(boxOf(upright, 1).min == Vec2(0, 1));
        QVERIFY(boxOf(upright, 2).min == Vec2(2, 0));
    }

    void flippingTwiceIsNoChangeAndKeepsPolygonsTheRightWayRound() {
        const Level once = flipped(arrangedBoxes(), ArrangeKeys{1, 2, 3}, FlipAxis::Horizontal);
        const auto& body = std::get<BodyObject>(once.objects.find(2)->data);
        QVERIFY(signedArea(std::get<Polygon>(body.shapes.front()).vertices) > 0);
        const Level twice = flipped(once, ArrangeKeys{1, 2, 3}, FlipAxis::Horizontal);
        for (const Key key : ArrangeKeys{1, 2, 3}) {
            QVERIFY(boxOf(twice, key).min == boxOf(arrangedBoxes(), key).min);
        }
    }

    void aligningBringsSidesTogetherAndMovesNothingElse_data() {
        QTest::addColumn<int>("side");
        QTest::addColumn<double>("value");
        QTest::newRow("left") << int(AlignTo::Left) << 0.0;
        QTest::newRow("right") << int(AlignTo::Right) << 8.0;
        QTest::newRow("bottom") << int(AlignTo::Bottom) << 0.0;
        QTest::newRow("top") << int(AlignTo::Top) << 5.0;
        QTest::newRow("middle across") << int(AlignTo::MiddleAcross) << 4.0;
        QTest::newRow("middle upright") << int(AlignTo::MiddleUpright) << 2.5;
    }

    void aligningBringsSidesTogetherAndMovesNothingElse() {
        QFETCH(int, side);
        QFETCH(double, value);
        const auto to = static_cast<AlignTo>(side);
        const Level level = aligned(arrangedBoxes(), ArrangeKeys{1, 2, 3}, to);
        for (const Key key : ArrangeKeys{1, 2, 3}) {
            const Aabb box = boxOf(level, key);
            const Aabb before = boxOf(arrangedBoxes(), key);
            const bool across = to == AlignTo::Left || to == AlignTo::Right || to == AlignTo::MiddleAcross;
            const double found = to == AlignTo::Left           ? box.min.x()
                                 : to == AlignTo::Right        ? box.max.x()
                                 : to == AlignTo::Bottom       ? box.min.y()
                                 : to == AlignTo::Top          ? box.max.y()
                                 : to == AlignTo::MiddleAcross ? box.center().x()
                                                               : box.center().y();
            QCOMPARE(found, value);
            QCOMPARE(box.min[across ? 1 : 0], before.min[across ? 1 : 0]);
            QVERIFY((box.size() - before.size()).norm() < 1e-12);
        }
    }

    void groupsAreAlignedAsAWhole() {
        Level level = grouped(arrangedBoxes(), ArrangeKeys{1, 2}, {9, "group", GroupObject{}, {}});
        level = aligned(std::move(level), ArrangeKeys{9, 3}, AlignTo::Right);
        QVERIFY(boxOf(level, 1).min == Vec2(4, 0));
        QVERIFY(boxOf(level, 2).min == Vec2(6, 1));
        QVERIFY(boxOf(level, 3).min == Vec2(7, 3));
    }

    void whatIsLockedIsNotAligned() {
        Level level = withLocked(arrangedBoxes(), ArrangeKeys{2}, true);
        level = aligned(std::move(level), ArrangeKeys{1, 2, 3}, AlignTo::Left);
        QVERIFY(boxOf(level, 2).min == Vec2(2, 1));
        QVERIFY(boxOf(level, 3).min == Vec2(0, 3));
    }

    void distributingKeepsTheOutermostAndSpacesTheRest() {
        QCOMPARE(boxOf(distributed(arrangedBoxes(), ArrangeKeys{1, 2, 3}, {Spread::Edges, true}), 2).min.x(), 3.5);
        QCOMPARE(boxOf(distributed(arrangedBoxes(), ArrangeKeys{1, 2, 3}, {Spread::Middles, true}), 2).center().x(),
                 4.0);
        // 8 m, of which 4 m are taken: gaps of 2 m.
        QCOMPARE(boxOf(distributed(arrangedBoxes(), ArrangeKeys{1, 2, 3}, {Spread::Gaps, true}), 2).min.x(), 3.0);
        QCOMPARE(boxOf(distributed(arrangedBoxes(), ArrangeKeys{1, 2, 3}, {Spread::Gaps, false}), 2).min.y(), 1.5);
        const Level level = distributed(arrangedBoxes(), ArrangeKeys{3, 1, 2}, {Spread::Gaps, true});
        QVERIFY(boxOf(level, 1).min == Vec2(0, 0));
        QVERIFY(boxOf(level, 3).min == Vec2(7, 3));
        QVERIFY(distributed(arrangedBoxes(), ArrangeKeys{1, 2}, {Spread::Gaps, true}) == arrangedBoxes());
    }

    void orderGoesToTheEndsOrPastTheNextThatOverlaps() {
        Level level; // 1, 2 and 4 overlap; 3 lies apart
        for (const Key key : ArrangeKeys{1, 2, 3, 4}) {
            level.objects.append(boxWith(key, {key == 3 ? 10.0 : 0.1 * key, 0}, {1, 1}));
        }
        QCOMPARE(arrangedKeys(reordered(level, ArrangeKeys{1, 2}, OrderTo::Front)), (ArrangeKeys{3, 4, 1, 2}));
        QCOMPARE(arrangedKeys(reordered(level, ArrangeKeys{3, 4}, OrderTo::Back)), (ArrangeKeys{3, 4, 1, 2}));
        QCOMPARE(arrangedKeys(reordered(level, ArrangeKeys{1}, OrderTo::Forward)), (ArrangeKeys{2, 1, 3, 4}));
        QCOMPARE(arrangedKeys(reordered(level, ArrangeKeys{2}, OrderTo::Forward)), (ArrangeKeys{1, 3, 4, 2}));
        QCOMPARE(arrangedKeys(reordered(level, ArrangeKeys{1, 2}, OrderTo::Forward)), (ArrangeKeys{3, 4, 1, 2}));
        QCOMPARE(arrangedKeys(reordered(level, ArrangeKeys{4}, OrderTo::Backward)), (ArrangeKeys{1, 4, 2, 3}));
        QCOMPARE(arrangedKeys(reordered(level, ArrangeKeys{4}, OrderTo::Forward)), (ArrangeKeys{1, 2, 3, 4}));
        QCOMPARE(arrangedKeys(reordered(level, ArrangeKeys{3}, OrderTo::Backward)), (ArrangeKeys{1, 2, 3, 4}));
    }

    void isolatingHidesAllElseButNotWhatHoldsItTogether() {
        Level level = grouped(arrangedBoxes(), ArrangeKeys{1, 2}, {9, "group", GroupObject{}, {}});
        ConnectorObject connector;
        connector.a = 1;
        connector.b = 2;
        level.objects.append({5, "rope", connector, {}});
        const Level alone = isolated(level, ArrangeKeys{1});
        const GroupTree tree(alone);
        const auto visible = [&](Key key) { return tree.isVisible(*alone.objects.find(key)); };
        QVERIFY(visible(1) && !visible(2) && !visible(3) && !visible(5));
        const Level group = isolated(level, ArrangeKeys{9});
        const GroupTree all(group);
        QVERIFY(all.isVisible(*group.objects.find(2)) && all.isVisible(*group.objects.find(5)));
        QVERIFY(!all.isVisible(*group.objects.find(3)));
    }

    void arraysStandInARowOrRoundACentre() {
        std::vector<Key> copies;
        const Level row = arrayed(arrangedBoxes(), ArrangeKeys{1, 2}, {LinearArray{3, {0, 2}}, 1}, copies);
        QCOMPARE(copies.size(), std::size_t{6});
        QVERIFY(boxOf(row, copies[4]).min == Vec2(0, 6));
        QVERIFY(boxOf(row, copies[5]).min == Vec2(2, 7));
        const double quarter = std::numbers::pi / 2;
        const Level ring = arrayed(arrangedBoxes(), ArrangeKeys{1}, {RadialArray{3, quarter, {0, 0}, true}, 1}, copies);
        QVERIFY((boxOf(ring, copies[1]).min - Vec2(-1, -1)).norm() < 1e-9);
        QVERIFY(std::abs(std::get<BodyObject>(ring.objects.find(copies[0])->data).angle - quarter) < 1e-12);
        const Level upright =
            arrayed(arrangedBoxes(), ArrangeKeys{1}, {RadialArray{1, 2 * quarter, {0, 0}, false}, 1}, copies);
        QVERIFY(boxOf(upright, copies[0]).min == Vec2(-1, -1));
        QVERIFY(std::get<BodyObject>(upright.objects.find(copies[0])->data).angle == 0);
    }

    void arraysOfGroupsHaveGroupsAndConnectorsOfTheirOwn() {
        Level level = grouped(arrangedBoxes(), ArrangeKeys{1, 2}, {9, "group", GroupObject{}, {}});
        ConnectorObject connector;
        connector.a = 1;
        connector.b = 2;
        level.objects.append({5, "rope", connector, {}, 9});
        std::vector<Key> copies;
        const Level row = arrayed(level, ArrangeKeys{9}, {LinearArray{2, {0, 2}}, 1}, copies);
        QCOMPARE(copies.size(), std::size_t{2});
        QCOMPARE(row.objects.size(), level.objects.size() + 8);
        QCOMPARE(arraySize(level, ArrangeKeys{9}, LinearArray{1'000'000, {0, 2}}), std::int64_t{4'000'000});
        for (const Object& object : row.objects) {
            const auto* rope = std::get_if<ConnectorObject>(&object.data);
            if (rope != nullptr) {
                QCOMPARE(row.objects.find(rope->a)->parent, object.parent);
                QCOMPARE(row.objects.find(rope->b)->parent, object.parent);
            }
        }
    }

    void everyEditLeavesItsInputUntouchedAndItsOutputValid() {
        const std::uint64_t first = 20;
        for (std::uint64_t seed = first; seed < first + 20; ++seed) {
            const Level level = randomLevel(seed, 15);
            const std::string before = levelText(level);
            Random random(seed);
            std::vector<Key> keys;
            for (const Object& object : level.objects) {
                if (random.next() % 2 == 0) {
                    keys.push_back(object.key);
                }
            }
            std::vector<Key> copies;
            std::vector<Level> results;
            for (int i = 0; i < 6; ++i) {
                results.push_back(aligned(level, keys, static_cast<AlignTo>(i)));
                results.push_back(distributed(level, keys, {static_cast<Spread>(i / 2), i % 2 == 0}));
            }
            for (int i = 0; i < 4; ++i) {
                results.push_back(reordered(level, keys, static_cast<OrderTo>(i)));
                QCOMPARE(results.back().objects.size(), level.objects.size());
            }
            results.push_back(flipped(level, keys, FlipAxis::Horizontal));
            results.push_back(flipped(level, keys, FlipAxis::Vertical));
            results.push_back(isolated(level, keys));
            results.push_back(arrayed(level, keys, {LinearArray{3, {1, 2}}, seed}, copies));
            results.push_back(arrayed(level, keys, {RadialArray{3, 1, {1, 2}, seed % 2 == 0}, seed}, copies));
            for (const Level& result : results) {
                const LevelFile read = parseLevel(levelText(result));
                QVERIFY2(read.level == result, qPrintable(QString("seed %1").arg(seed)));
            }
            QVERIFY(levelText(level) == before);
        }
    }
};

SPACETOW_TEST(ArrangeTest)
#include "arrange_test.moc"
