#include "core/level/merge.h"

#include "core/base/random.h"
#include "core/level/arrange.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "core/level/groups.h"
#include "tests/support/random_level.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using MergedKeys = std::vector<Key>;

Level rowOfBalls(int count = 4) {
    Level level;
    for (int i = 1; i <= count; ++i) {
        BodyObject body;
        body.position = {double(i), 0};
        body.shapes = {Circle{{0, 0}, 0.5}};
        level.objects.append({Key(i), "ball", body, {}});
    }
    return level;
}

template <class Change>
Level changedBall(Level level, Key key, Change change) {
    Object object = *level.objects.find(key);
    change(std::get<BodyObject>(object.data));
    level.objects.replace(level.objects.indexOf(key), object);
    return level;
}

Level withParentOf(Level level, Key key, Key parent) {
    Object object = *level.objects.find(key);
    object.parent = parent;
    level.objects.replace(level.objects.indexOf(key), object);
    return level;
}

const BodyObject& ballOf(const Level& level, Key key) {
    return std::get<BodyObject>(level.objects.find(key)->data);
}

/// One edit of one of the bodies that are `parity` modulo two in the list, so that two people never touch the same.
Level editedAtRandom(const Level& level, Random& random, int parity) {
    MergedKeys own;
    for (int i = parity; i < level.objects.size(); i += 2) {
        if (std::holds_alternative<BodyObject>(level.objects[i].data)) {
            own.push_back(level.objects[i].key);
        }
    }
    if (own.empty()) {
        return level;
    }
    const MergedKeys one{own[random.next() % own.size()]};
    switch (random.next() % 5) {
    case 0:
        return moved(level, one, {random.uniform(-3, 3), 1});
    case 1:
        return rotated(level, one, {0, 0}, random.uniform(-1, 1));
    case 2:
        return renamed(level, one.front(), "renamed " + std::to_string(random.next()));
    case 3:
        return added(
            level,
            {freshKey(level, random.next() * 2 + std::uint64_t(parity)), "new", BodyObject{.shapes = {Circle{}}}, {}});
    default:
        return changedBall(level, one.front(), [&](BodyObject& body) {
            body.friction = random.uniform(0, 1);
            body.filter.tags.bits ^= 1u << (random.next() % 5);
        });
    }
}

std::set<std::string> namesOfTags(const Level& level, Key ball) {
    std::set<std::string> names;
    for (int i = 0; i < TagTable::size; ++i) {
        if (ballOf(level, ball).filter.tags.contains(i)) {
            names.insert(level.tags[i].name);
        }
    }
    return names;
}

std::set<Key> keySet(const Level& level) {
    std::set<Key> keys;
    for (const Object& object : level.objects) {
        keys.insert(object.key);
    }
    return keys;
}

} // namespace

class MergeTest : public QObject {
    Q_OBJECT

  private slots:
    void whatOneSideDidIsTakenOver() {
        const Level base = rowOfBalls();
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Random random(seed);
            Level edited = base;
            for (int i = 0; i < 5; ++i) {
                edited = editedAtRandom(edited, random, i % 2);
            }
            for (const MergedLevel& result :
                 {merged(base, edited, base), merged(base, base, edited), merged(base, edited, edited)}) {
                QVERIFY2(result.level == edited && result.conflicts.empty(), seedText(seed));
            }
        }
    }

    void twoHundredPairsOfEditsOfDifferentObjectsMergeToBothWithoutAConflict() {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            Random random(seed);
            const Level base = randomLevel(seed, 14);
            Level ours = base;
            Level theirs = base;
            Random mine(2 * seed);
            Random other(2 * seed + 1);
            for (int i = 0; i < 4; ++i) {
                ours = editedAtRandom(ours, mine, 0);
                theirs = editedAtRandom(theirs, other, 1);
            }
            const MergedLevel result = merged(base, ours, theirs);
            QVERIFY2(result.conflicts.empty(), seedText(seed));
            // Each object is as the side has it that changed it.
            std::set<Key> expected = keySet(ours);
            expected.merge(keySet(theirs));
            QVERIFY2(keySet(result.level) == expected, seedText(seed));
            for (const Object& object : result.level.objects) {
                const Object* old = base.objects.find(object.key);
                const Object* a = ours.objects.find(object.key);
                const Object* b = theirs.objects.find(object.key);
                const Object* right = a == nullptr || (b != nullptr && old != nullptr && *a == *old) ? b : a;
                QVERIFY2(object == *right, seedText(seed));
            }
            QVERIFY2(merged(base, theirs, ours).level.objects.size() == result.level.objects.size(), seedText(seed));
        }
    }

    void differentFieldsOfOneObjectMerge() {
        const Level base = rowOfBalls();
        const Level ours = changedBall(base, 2, [](BodyObject& ball) {
            ball.friction = 0.9;
            ball.filter.tags = TagMask{3};
        });
        const Level theirs = changedBall(moved(base, MergedKeys{2}, {0, 5}), 2, [](BodyObject& ball) {
            std::get<Circle>(ball.shapes[0]).radius = 3;
            ball.filter.tags = TagMask{5};
        });
        const MergedLevel result = merged(base, ours, theirs);
        QVERIFY(result.conflicts.empty());
        const BodyObject& ball = ballOf(result.level, 2);
        QCOMPARE(ball.friction, 0.9);
        QCOMPARE(ball.position, Vec2(2, 5));
        QCOMPARE(std::get<Circle>(ball.shapes[0]).radius, 3.0);
        QCOMPARE(ball.filter.tags.bits, 7u);
    }

    void aFieldThatBothChangedIsNamedAndThePreferredSidesIsTaken() {
        const Level base = rowOfBalls();
        const Level ours = moved(base, MergedKeys{1}, {1, 0});
        const Level theirs = moved(base, MergedKeys{1}, {0, 1});
        const MergedLevel mine = merged(base, ours, theirs);
        QCOMPARE(mine.conflicts, (std::vector{MergeConflict{ConflictKind::Field, 1, "position"}}));
        QVERIFY(mine.level == ours);
        QVERIFY(merged(base, ours, theirs, MergeSide::Theirs).level == theirs);
    }

    void whatOneSideRemovedAndTheOtherChangedStays() {
        const Level base = rowOfBalls();
        const Level without = removed(base, MergedKeys{3});
        const Level changed = moved(base, MergedKeys{3}, {0, 2});
        const MergedLevel a = merged(base, without, changed);
        QCOMPARE(a.conflicts, (std::vector{MergeConflict{ConflictKind::RemovedOurs, 3, {}}}));
        QVERIFY(a.level == changed);
        const MergedLevel b = merged(base, changed, without);
        QCOMPARE(b.conflicts, (std::vector{MergeConflict{ConflictKind::RemovedTheirs, 3, {}}}));
        QVERIFY(b.level == changed);
        QVERIFY(merged(base, without, base).level == without);
    }

    void whatOneSideRemovedAndTheOtherNeedsStays() {
        const Level base = rowOfBalls();
        const Level without = removed(base, MergedKeys{1});
        const Level tied = added(base, {50, "rope", ConnectorObject{.a = 1, .b = 2}, {}});
        const MergedLevel result = merged(base, without, tied);
        QCOMPARE(result.conflicts, (std::vector{MergeConflict{ConflictKind::RemovedOurs, 1, {}}}));
        QVERIFY(result.level.objects.find(1) != nullptr && result.level.objects.find(50) != nullptr);
    }

    void whatNothingOfTheMergeNeedsAnyMoreGoes() {
        Level base = rowOfBalls();
        base.objects.append({50, "group", GroupObject{}, {}});
        base.objects.append({60, "rope", ConnectorObject{.a = 1, .b = 2}, {}});
        base = withParentOf(base, 1, 50);
        // One side dissolves the group; the other has done nothing, or moved a member.
        const Level dissolved = removed(withParentOf(base, 1, 0), MergedKeys{50});
        for (const Level& other : {base, moved(base, MergedKeys{1}, {0, 1})}) {
            for (const MergedLevel& result : {merged(base, dissolved, other), merged(base, other, dissolved)}) {
                QVERIFY(result.conflicts.empty());
                QVERIFY(result.level.objects.find(50) == nullptr);
                QCOMPARE(result.level.objects.find(1)->parent, Key(0));
            }
        }
        // One side ties the rope to another ball and removes the one that it was tied to.
        Object rope = *base.objects.find(60);
        std::get<ConnectorObject>(rope.data).b = 3;
        Level tied = base;
        tied.objects.replace(tied.objects.indexOf(60), rope);
        tied.objects.erase(tied.objects.indexOf(2));
        QVERIFY(merged(base, base, tied).conflicts.empty());
        QVERIFY(merged(base, base, tied).level == tied);
        QVERIFY(merged(base, tied, base).level == tied);
    }

    void groupsThatWouldBeInEachOtherStayAsOursHasThem() {
        Level base;
        base.objects.append({1, "a", GroupObject{}, {}});
        base.objects.append({2, "b", GroupObject{}, {}});
        const MergedLevel result = merged(base, withParentOf(base, 1, 2), withParentOf(base, 2, 1));
        QCOMPARE(result.conflicts, (std::vector{MergeConflict{ConflictKind::Circle, 2, {}}}));
        QCOMPARE(result.level.objects.find(1)->parent, Key(2));
        QCOMPARE(result.level.objects.find(2)->parent, Key(0));
    }

    void tagsAreOneByTheirNamesAndNewOnesFindRoom() {
        const Level base = rowOfBalls();
        const auto lava = [](Level level, int index, const char* name, Key key) {
            level = withTag(std::move(level), index, {name, 0xff0000});
            return changedBall(std::move(level), key,
                               [index](BodyObject& ball) { ball.filter.tags = TagMask::bit(index); });
        };
        // The same tag in two places.
        const MergedLevel same = merged(base, lava(base, 9, "lava", 1), lava(base, 12, "lava", 2));
        QVERIFY(same.conflicts.empty());
        QCOMPARE(ballOf(same.level, 1).filter.tags, TagMask::bit(9));
        QCOMPARE(ballOf(same.level, 2).filter.tags, TagMask::bit(9));
        QVERIFY(same.level.tags[12].name.empty());
        // Two tags in the same place.
        const MergedLevel two = merged(base, lava(base, 9, "lava", 1), lava(base, 9, "ice", 2));
        QVERIFY(two.conflicts.empty());
        const auto ice = two.level.tags.indexOf("ice");
        QVERIFY(ice && *ice != 9);
        QCOMPARE(ballOf(two.level, 2).filter.tags, TagMask::bit(*ice));
        QCOMPARE(two.level.tags[9].name, std::string("lava"));
        // No room.
        Level full = base;
        for (int i = 0; i < TagTable::size; ++i) {
            if (full.tags[i].name.empty() && i != 9) {
                full.tags.set(i, {"t" + std::to_string(i), 0});
            }
        }
        const MergedLevel none = merged(full, lava(full, 9, "lava", 1), lava(full, 9, "ice", 2));
        QCOMPARE(none.conflicts, (std::vector{MergeConflict{ConflictKind::TagsFull, 0, "ice"}}));
        QCOMPARE(none.level.tags[9].name, std::string("lava"));
        QCOMPARE(ballOf(none.level, 2).filter.tags, TagMask()); // not lava
    }

    void newTagsFindRoomHoweverTheyStandInEachOthersWay() {
        const Level base = rowOfBalls();
        for (std::uint64_t seed = 1; seed <= 300; ++seed) {
            Random random(seed);
            // Each side gives names to some of the same few tags, and each of its balls one of them.
            const auto tagged = [&](Key first) {
                Level level = base;
                std::vector<int> own;
                for (int tag = 8; tag < 13; ++tag) {
                    const std::string name(1, static_cast<char>('a' + random.next() % 8));
                    if (random.next() % 2 == 0 && !level.tags.indexOf(name)) {
                        level.tags.set(tag, {name});
                        own.push_back(tag);
                    }
                }
                for (Key key = first; key < first + 2 && !own.empty(); ++key) {
                    const TagMask tag = TagMask::bit(own[random.next() % own.size()]);
                    level = changedBall(level, key, [tag](BodyObject& ball) { ball.filter.tags = tag; });
                }
                return level;
            };
            const Level ours = tagged(1);
            const Level theirs = tagged(3);
            const MergedLevel result = merged(base, ours, theirs);
            QVERIFY2(result.conflicts.empty(), seedText(seed));
            QVERIFY2(!saveError(result.level), seedText(seed));
            for (Key key = 1; key <= 4; ++key) {
                const Level& side = key < 3 ? ours : theirs;
                QVERIFY2(namesOfTags(result.level, key) == namesOfTags(side, key), seedText(seed));
            }
        }
    }

    void noTwoTagsComeToHaveOneName() {
        const Level base = withTag(rowOfBalls(), 10, {"rock"});
        const Level renamedIt = withTag(base, 10, {"stone"});
        for (const int place : {8, 12}) {
            const Level addedIt = withTag(base, place, {"stone"});
            for (const MergeSide side : {MergeSide::Ours, MergeSide::Theirs}) {
                for (const MergedLevel& result :
                     {merged(base, renamedIt, addedIt, side), merged(base, addedIt, renamedIt, side)}) {
                    QVERIFY(!saveError(result.level));
                    QVERIFY(!result.conflicts.empty());
                }
            }
        }
    }

    void fieldsThatNobodyKnowsStayWithWhatTheyBelongTo() {
        Level base = rowOfBalls();
        base.guides = {{{1, 1}, 0, "a"}, {{2, 2}, 0, "b"}, {{3, 3}, 0, "c"}};
        base.unknownFields = R"({"/glow": 0, "/guides/1/glow": 1, "/guides/2/glow": 2})";
        Level ours = base;
        ours.guides.erase(ours.guides.begin());
        ours.unknownFields = R"({"/glow": 0, "/guides/0/glow": 1, "/guides/1/glow": 2})";
        Level theirs = withTag(base, 9, {"ice"});
        theirs.guides.insert(theirs.guides.begin(), {{0, 0}, 0, "new"});
        theirs.unknownFields =
            R"({"/glow": 5, "/guides/0/glow": 7, "/guides/2/glow": 1, "/guides/3/glow": 9, "/tags/9/slip": 1.50})";
        ours = withTag(ours, 9, {"lava"});
        const MergedLevel result = merged(base, ours, theirs);
        QVERIFY(result.conflicts.empty());
        QCOMPARE(result.level.guides.size(), std::size_t(3));
        QCOMPARE(result.level.guides[2].name, std::string("new"));
        const auto ice = result.level.tags.indexOf("ice");
        QVERIFY(ice && *ice != 9);
        QCOMPARE(result.level.unknownFields, R"({"/glow": 5, "/guides/0/glow": 1, "/guides/1/glow": 9, )"
                                             R"("/guides/2/glow": 7, "/tags/)" +
                                                 std::to_string(*ice) + R"(/slip": 1.50})");
    }

    void theOrderIsThatOfTheSideThatChangedItAndNewObjectsFollowTheirNeighbours() {
        const Level base = rowOfBalls(3);
        const Level ours = reordered(base, MergedKeys{1}, OrderTo::Front);
        Level theirs = base;
        theirs.objects.insert(1, {9, "new", BodyObject{.shapes = {Circle{}}}, {}});
        const MergedLevel result = merged(base, ours, theirs);
        MergedKeys order;
        for (const Object& object : result.level.objects) {
            order.push_back(object.key);
        }
        QCOMPARE(order, (MergedKeys{2, 3, 1, 9}));
        QVERIFY(result.conflicts.empty());
        const MergedLevel both = merged(base, ours, reordered(base, MergedKeys{3}, OrderTo::Back));
        QCOMPARE(both.conflicts, (std::vector{MergeConflict{ConflictKind::Order, 0, {}}}));
        QVERIFY(both.level == ours);
    }

    void fieldsOfTheLevelAndGuidesMerge() {
        const Level base = rowOfBalls();
        Level ours = base;
        ours.name = "Ours";
        ours.rules.lives = 7;
        ours.guides.push_back({{1, 1}, 0, "a"});
        Level theirs = base;
        theirs.gravity = {0, -3};
        theirs.rules.lives = 8;
        theirs.rules.rope.limit = 80;
        theirs.guides.push_back({{2, 2}, 0, "b"});
        const MergedLevel result = merged(base, ours, theirs);
        QCOMPARE(result.conflicts, (std::vector{MergeConflict{ConflictKind::Field, 0, "lives"}}));
        QCOMPARE(result.level.name, std::string("Ours"));
        QCOMPARE(result.level.gravity, Vec2(0, -3));
        QCOMPARE(result.level.rules.lives, 7);
        QCOMPARE(result.level.rules.rope.limit, 80.0);
        QCOMPARE(result.level.guides.size(), std::size_t(2));
    }

    void unknownFieldsStayWithTheEntriesTheyStoodIn() {
        Level base;
        base.guides = {{{1, 1}, 0, "a"}, {{2, 2}, 0, "b"}};
        base.hiddenProblems = {{"x", 1}, {"y", 2}};
        base.unknownFields = R"({"/guides/1/glow": 1, "/hiddenProblems/1/why": "y"})";
        Level theirs = base;
        theirs.guides.erase(theirs.guides.begin());
        theirs.hiddenProblems.erase(theirs.hiddenProblems.begin());
        theirs.unknownFields = R"({"/guides/0/glow": 1, "/hiddenProblems/0/why": "y"})";
        const MergedLevel result = merged(base, base, theirs);
        QCOMPARE(result.level.unknownFields, std::string(R"({"/guides/0/glow": 1, "/hiddenProblems/0/why": "y"})"));
    }
};

SPACETOW_TEST(MergeTest)
#include "merge_test.moc"
