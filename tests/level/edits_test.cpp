#include "core/level/edits.h"

#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <numbers>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Object box(Key key, const Vec2& position) {
    BodyObject body;
    body.position = position;
    body.shapes = {Polygon{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}};
    return {key, "box", body, {}};
}

Object rope(Key key, Key a, Key b) {
    ConnectorObject connector;
    connector.a = a;
    connector.b = b;
    return {key, "rope", connector, {}};
}

const BodyObject& bodyAt(const Level& level, Key key) {
    return std::get<BodyObject>(level.objects.find(key)->data);
}

Level twoBoxesAndARope() {
    Level level;
    level.objects.append(box(1, {0, 0}));
    level.objects.append(box(2, {5, 0}));
    level.objects.append(rope(3, 1, 2));
    return level;
}

std::vector<Key> keysOf(const Level& level) {
    std::vector<Key> keys;
    for (const Object& object : level.objects) {
        keys.push_back(object.key);
    }
    return keys;
}

} // namespace

class EditsTest : public QObject {
    Q_OBJECT

  private slots:
    void addingAppends() {
        const Level level = added(twoBoxesAndARope(), box(9, {1, 1}));
        QCOMPARE(level.objects.size(), 4);
        QCOMPARE(level.objects[3].key, Key{9});
    }

    void aSecondShipReplacesTheFirstAndTakesItsKey() {
        Level level;
        level.objects.append({5, "mine", ShipObject{{1, 1}, 0}, {}});
        level = added(std::move(level), {6, "other", ShipObject{{2, 2}, 1}, {}});
        QCOMPARE(level.objects.size(), 1);
        QCOMPARE(level.objects[0].key, Key{5});
        QCOMPARE(level.objects[0].name, std::string("mine"));
        QVERIFY((std::get<ShipObject>(level.objects[0].data) == ShipObject{{2, 2}, 1}));
    }

    void removingABodyRemovesItsConnectors() {
        const std::vector<Key> keys{2};
        const Level level = removed(twoBoxesAndARope(), keys);
        QCOMPARE(keysOf(level), std::vector<Key>{1});
    }

    void unknownKeysAreIgnored() {
        const Level level = twoBoxesAndARope();
        const std::vector<Key> keys{77};
        std::vector<Key> copies{1};
        QVERIFY(removed(level, keys) == level);
        QVERIFY(moved(level, keys, {1, 1}) == level);
        QVERIFY(duplicated(level, keys, {{1, 1}, 1}, copies) == level);
        QVERIFY(copies.empty());
        QVERIFY(renamed(level, 77, "x") == level);
    }

    void movingShiftsEveryKindAndNothingElse() {
        const Level before = populatedLevel();
        const std::vector<Key> all = keysOf(before);
        const Level after = moved(before, all, {1, 2});
        const Vec2 delta(1, 2);
        QVERIFY((bodyAt(after, 1).position == Vec2(bodyAt(before, 1).position + delta)));
        QVERIFY((std::get<ShipObject>(after.objects[2].data).position == Vec2(21, 23)));
        QVERIFY((std::get<PayloadObject>(after.objects[3].data).position == Vec2(31, 33)));
        QVERIFY((std::get<FinishObject>(after.objects[4].data) == FinishObject{{41, 43}, {43, 45}}));
        QVERIFY(after.objects[5] == before.objects[5]);
        QVERIFY(moved(after, all, {-1, -2}) == before);
    }

    void untouchedObjectsKeepTheirPieces() {
        const Level before = populatedLevel();
        const std::vector<Key> keys{3};
        const Level after = moved(before, keys, {1, 0});
        for (int i = 0; i < before.objects.size(); ++i) {
            QCOMPARE(after.objects.sharesPiece(i, before.objects), before.objects[i].key != 3);
        }
    }

    void aQuarterTurnAboutAPivotMovesAndTurns() {
        const std::vector<Key> keys{2};
        const Level level = rotated(twoBoxesAndARope(), keys, {4, 0}, std::numbers::pi / 2);
        QVERIFY((bodyAt(level, 2).position - Vec2(4, 1)).norm() < 1e-15);
        QCOMPARE(bodyAt(level, 2).angle, std::numbers::pi / 2);
        QCOMPARE(bodyAt(level, 1).angle, 0.0);
    }

    void turningAllTheWayRoundComesBack() {
        const Level before = populatedLevel();
        const std::vector<Key> all = keysOf(before);
        Level level = before;
        for (int i = 0; i < 24; ++i) {
            level = rotated(std::move(level), all, {3, 4}, std::numbers::pi / 12);
        }
        for (const Object& object : before.objects) {
            const Aabb a = boundsOf(before, object);
            const Aabb b = boundsOf(level, *level.objects.find(object.key));
            QVERIFY((a.min - b.min).norm() < 1e-12 && (a.max - b.max).norm() < 1e-12);
        }
    }

    void reversingTurnsTheSolidSideRoundAndTwiceIsNoChange_data() {
        QTest::addColumn<bool>("closed");
        QTest::newRow("open chain") << false;
        QTest::newRow("closed chain keeps its first vertex") << true;
    }
    void reversingTurnsTheSolidSideRoundAndTwiceIsNoChange() {
        QFETCH(bool, closed);
        Level level;
        BodyObject body;
        body.shapes = {EdgeChain{{{0, 0}, {1, 0}, {2, 3}}, closed, 1}, Polygon{{{0, 0}, {1, 0}, {0, 1}}}};
        level.objects.append({1, "", body, {}});
        const std::vector<Key> keys{1};
        const Level once = reversed(level, keys);
        const auto& chain = std::get<EdgeChain>(bodyAt(once, 1).shapes[0]);
        const std::vector<Vec2> expected =
            closed ? std::vector<Vec2>{{0, 0}, {2, 3}, {1, 0}} : std::vector<Vec2>{{2, 3}, {1, 0}, {0, 0}};
        QVERIFY(chain.vertices == expected);
        QVERIFY(bodyAt(once, 1).shapes[1] == body.shapes[1]);
        QVERIFY(reversed(once, keys) == level);
    }

    void copiesHaveFreshKeysAndTheirOwnConnectors() {
        const std::vector<Key> keys{1, 3, 2};
        std::vector<Key> copies;
        const Level level = duplicated(twoBoxesAndARope(), keys, {{10, 0}, 42}, copies);
        QCOMPARE(level.objects.size(), 6);
        QCOMPARE(copies.size(), std::size_t{3});
        // In the drawing order of the originals, whatever the order of the keys.
        const auto& connector = std::get<ConnectorObject>(level.objects.find(copies[2])->data);
        QCOMPARE(connector.a, copies[0]);
        QCOMPARE(connector.b, copies[1]);
        QVERIFY((bodyAt(level, copies[1]).position == Vec2(15, 0)));
        const std::vector<Key> all = keysOf(level);
        QCOMPARE(std::set<Key>(all.begin(), all.end()).size(), all.size());
    }

    void aConnectorIsCopiedOnlyWithBothEnds() {
        const std::vector<Key> keys{1, 3};
        std::vector<Key> copies;
        const Level level = duplicated(twoBoxesAndARope(), keys, {{10, 0}, 42}, copies);
        QCOMPARE(level.objects.size(), 4);
        QCOMPARE(copies.size(), std::size_t{1});
    }

    void shipPayloadAndFinishAreNotCopied() {
        const Level level = populatedLevel();
        const std::vector<Key> keys{3, 4, 5};
        std::vector<Key> copies;
        QVERIFY(duplicated(level, keys, {{1, 1}, 1}, copies) == level);
    }

    void pastingBringsAShipOnlyWhereThereIsNone() {
        const Level source = populatedLevel();
        std::vector<Object> objects;
        for (const Object& object : source.objects) {
            objects.push_back(object);
        }
        std::vector<Key> copies;
        const Level first = pasted(Level(), objects, {{0, 0}, 1}, copies);
        QCOMPARE(first.objects.size(), 9);
        const Level second = pasted(first, objects, {{0, 0}, 2}, copies);
        QCOMPARE(second.objects.size(), 15);
        QCOMPARE(copies.size(), std::size_t{4}); // of two bodies, a connector, and a layer with all that is in it
    }

    void replacingAndRenamingKeepThePlace() {
        Level level = withObject(twoBoxesAndARope(), box(2, {9, 9}));
        level = renamed(std::move(level), 1, "first");
        QCOMPARE(keysOf(level), (std::vector<Key>{1, 2, 3}));
        QVERIFY((bodyAt(level, 2).position == Vec2(9, 9)));
        QCOMPARE(level.objects[0].name, std::string("first"));
    }

    void tagsAreNamed() {
        const Level level = withTag({}, 9, {"ice", 0xffffff});
        QCOMPARE(level.tags.indexOf("ice"), std::optional(9));
    }

    void boundsEncloseEveryKind_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<double>("left");
        QTest::addColumn<double>("top");
        const double turn = 0.5;
        // Turned this far, the nose of the ship is its highest and its leftmost corner.
        const Vec2 nose(-0.7 / 3 * std::sin(turn), 0.7 / 3 * std::cos(turn));
        QTest::newRow("circle") << 1 << -1.0 << 1.0;
        QTest::newRow("ship") << 2 << 20 + nose.x() << 21 + nose.y();
        QTest::newRow("payload") << 3 << 29.7 << 31.3;
        QTest::newRow("finish") << 4 << 40.0 << 43.0;
    }
    void boundsEncloseEveryKind() {
        QFETCH(int, index);
        QFETCH(double, left);
        QFETCH(double, top);
        const Level level = populatedLevel();
        const Aabb box = boundsOf(level, level.objects[index]);
        QVERIFY(std::abs(box.min.x() - left) < 1e-12);
        QVERIFY(std::abs(box.max.y() - top) < 1e-12);
        QVERIFY(boundsOf(level).contains(box));
    }

    void aConnectorReachesFromAnchorToAnchor() {
        Level level = twoBoxesAndARope();
        const Aabb span = boundsOf(level, level.objects[2]);
        QVERIFY((span.min == Vec2(0, 0)) && (span.max == Vec2(5, 0)));
        level.objects.erase(1);
        QVERIFY(boundsOf(level, level.objects[1]).isEmpty());
        QVERIFY(boundsOf(Level()).isEmpty());
    }
};

SPACETOW_TEST(EditsTest)
#include "edits_test.moc"
