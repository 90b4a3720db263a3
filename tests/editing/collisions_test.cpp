#include "editor/editing/collisions.h"

#include "core/base/random.h"
#include "core/level/build.h"
#include "core/level/tag_edits.h"
#include "editor/editing/tag_matrix.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;

namespace {

Object body(Key key, TagMask tags, TagMask touches = TagMask::all(), BodyKind kind = BodyKind::Dynamic) {
    BodyObject made;
    made.shapes = {Circle{}};
    made.kind = kind;
    made.filter = {tags, touches};
    return {key, {}, made, {}};
}

Object wall(Key key) {
    BodyObject made;
    made.shapes = {EdgeChain{{{0, 0}, {1, 0}}, false, noBack}};
    return {key, {}, made, {}};
}

Level levelOf(const std::vector<Object>& objects) {
    Level level;
    for (const Object& object : objects) {
        level.objects.append(object);
    }
    return level;
}

std::vector<Key> colliding(const Level& level, std::vector<Key> keys) {
    return collidingWith(level, keys);
}

using Keys = std::vector<Key>;

} // namespace

class CollisionsTest : public QObject {
    Q_OBJECT

  private slots:
    void bothMustTouchWhatTheOtherIs() {
        const Level level = levelOf({body(1, TagMask{1}, TagMask{2}), body(2, TagMask{2}, TagMask{1}),
                                     body(3, TagMask{2}, TagMask{4}), body(4, TagMask{4}, TagMask{1})});
        QCOMPARE(colliding(level, {1}), Keys{2});
        QCOMPARE(colliding(level, {2}), Keys{1});
        QCOMPARE(colliding(level, {3}), Keys{});
        QCOMPARE(colliding(level, {}), Keys{});
        QCOMPARE(colliding(level, {99}), Keys{});
    }

    void nothingCollidesWithItself() {
        QCOMPARE(colliding(levelOf({body(1, TagMask{1})}), {1}), Keys{});
        QCOMPARE(colliding(levelOf({body(1, TagMask{1}), body(2, TagMask{1})}), {1}), Keys{2});
        QCOMPARE(colliding(levelOf({body(1, TagMask{1}), body(2, TagMask{1})}), {1, 2}), (Keys{1, 2}));
    }

    void whatNeverMovesPassesThroughItsLike() {
        const Level level =
            levelOf({body(1, TagMask{1}, TagMask::all(), BodyKind::Static),
                     body(2, TagMask{1}, TagMask::all(), BodyKind::Kinematic), body(3, TagMask{1}), wall(4)});
        QCOMPARE(colliding(level, {1}), Keys{3});
        QCOMPARE(colliding(level, {4}), Keys{3});
        QCOMPARE(colliding(level, {3}), (Keys{1, 2, 4}));
    }

    void shipPayloadAndFinishFollowTheRulesOfTheGame() {
        const Level level = levelOf({wall(1),
                                     {2, {}, ShipObject{}, {}},
                                     {3, {}, PayloadObject{}, {}},
                                     {4, {}, FinishObject{}, {}},
                                     body(5, TagMask::bit(debrisTag))});
        QCOMPARE(colliding(level, {2}), (Keys{1, 3}));
        QCOMPARE(colliding(level, {3}), (Keys{1, 2, 4}));
        QCOMPARE(colliding(level, {4}), Keys{3});
        QCOMPARE(keysTagged(level, shipTag), Keys{2});
        QCOMPARE(keysTagged(level, wallTag), Keys{1});
    }

    void aConnectorKeepsItsBodiesApart() {
        Level level = levelOf({body(1, TagMask{1}), body(2, TagMask{1}), body(3, TagMask{1})});
        ConnectorObject connector;
        connector.a = 1;
        connector.b = 2;
        level.objects.append({4, {}, connector, {}});
        QCOMPARE(colliding(level, {1}), Keys{3});
        QCOMPARE(colliding(level, {1, 3}), (Keys{1, 2, 3}));
        connector.bodiesCollide = true;
        level.objects.replace(3, {4, {}, connector, {}});
        QCOMPARE(colliding(level, {1}), (Keys{2, 3}));
    }

    void itIsWhatTheLongWayRoundSays() {
        constexpr std::uint64_t seed = 20261203;
        Random random(seed);
        for (int round = 0; round < 50; ++round) {
            std::vector<Object> objects;
            for (Key key = 1; key <= 12; ++key) {
                const auto kind = static_cast<BodyKind>(random.next() % 3);
                objects.push_back(body(key, TagMask{random.next() % 8}, TagMask{random.next() % 8}, kind));
            }
            const Level level = levelOf(objects);
            const Keys selected{1, 4, 7};
            Keys expected;
            for (const Object& object : objects) {
                const auto& one = std::get<BodyObject>(object.data);
                const bool collides = std::ranges::any_of(selected, [&](Key key) {
                    const auto& other = std::get<BodyObject>(objects[key - 1].data);
                    const bool moves = one.kind == BodyKind::Dynamic || other.kind == BodyKind::Dynamic;
                    return key != object.key && moves && mayTouch(one.filter, other.filter);
                });
                if (collides) {
                    expected.push_back(object.key);
                }
            }
            QVERIFY2(colliding(level, selected) == expected,
                     ("seed " + std::to_string(seed) + ", round " + std::to_string(round)).c_str());
        }
    }

    void theMatrixTellsWhoMeetsWhom() {
        Level level =
            levelOf({body(1, TagMask::bit(8)), body(2, TagMask::bit(9)), body(3, TagMask::bit(9), TagMask{})});
        level.tags.set(8, {"rock", 0});
        level.tags.set(9, {"leaf", 0});
        level.tags.set(10, {"nobody", 0});
        const TagMatrix matrix = tagMatrix(level);
        QVERIFY(std::ranges::find(matrix.tags, 10) != matrix.tags.end());
        QVERIFY(std::ranges::find(matrix.tags, 11) == matrix.tags.end());
        QVERIFY(matrix.cell(8, 8).meeting == TagMeeting::All);
        QVERIFY(matrix.cell(8, 9).meeting == TagMeeting::Some);
        QVERIFY(matrix.cell(10, 10).meeting == TagMeeting::Nobody);
        QCOMPARE(matrix.objects[9], 2);
        for (const int a : matrix.tags) {
            for (const int b : matrix.tags) {
                QVERIFY(matrix.cell(a, b) == matrix.cell(b, a));
            }
        }
        const Level apart = withTagsMeeting(level, 8, 9, false);
        QVERIFY(tagMatrix(apart).cell(8, 9).meeting == TagMeeting::None);
        QVERIFY(tagMatrix(apart).cell(8, 8).meeting == TagMeeting::All);
        QCOMPARE(colliding(apart, {1}), Keys{});
        const Level together = withTagsMeeting(apart, 9, 8, true);
        QVERIFY(tagMatrix(together).cell(8, 9).meeting == TagMeeting::All);
        QCOMPARE(colliding(together, {1}), (Keys{2, 3}));
        QCOMPARE(std::get<BodyObject>(together.objects[0].data).filter.touches, TagMask::all());
    }

    void whatTheGameLaysDownIsFixed() {
        Level level =
            levelOf({wall(1), {2, {}, ShipObject{}, {}}, {3, {}, PayloadObject{}, {}}, {4, {}, FinishObject{}, {}}});
        const TagMatrix matrix = tagMatrix(level);
        QVERIFY(matrix.cell(shipTag, finishTag).meeting == TagMeeting::None);
        QVERIFY(matrix.cell(shipTag, finishTag).isFixed);
        QVERIFY(matrix.cell(shipTag, payloadTag).meeting == TagMeeting::All);
        QVERIFY(matrix.cell(shipTag, payloadTag).isFixed);
        QVERIFY(matrix.cell(shipTag, wallTag).meeting == TagMeeting::All);
        QVERIFY(!matrix.cell(shipTag, wallTag).isFixed);
        level = withTagsMeeting(level, wallTag, shipTag, false);
        QVERIFY(tagMatrix(level).cell(shipTag, wallTag).meeting == TagMeeting::None);
        QVERIFY(!tagMatrix(level).cell(shipTag, wallTag).isFixed);
    }
};

SPACETOW_TEST(CollisionsTest)
#include "collisions_test.moc"
