#include "core/level/kept_changes.h"

#include "core/level/arrange.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "core/level/groups.h"
#include "core/level/guides.h"
#include "tests/support/every_edit.h"
#include "tests/support/full_run.h"
#include "tests/support/random_level.h"
#include "tests/support/seed_text.h"
#include "tests/support/structural_breaches.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

using KeptKeys = std::vector<Key>;

Object keptBall(Key key) {
    BodyObject body;
    body.position = {double(key), 0};
    body.shapes = {Circle{{0, 0}, 0.5}};
    return {key, "ball", body, {}};
}

Level ballsOneToThree() {
    Level level;
    for (const Key key : {1u, 2u, 3u}) {
        level.objects.append(keptBall(key));
    }
    return level;
}

Level withFields(Level level, Key key, double friction, double restitution) {
    Object object = *level.objects.find(key);
    std::get<BodyObject>(object.data).friction = friction;
    std::get<BodyObject>(object.data).restitution = restitution;
    return withObject(std::move(level), std::move(object));
}

std::vector<int> placesOf(const std::vector<LevelChange>& changes) {
    std::vector<int> places;
    for (int i = 0; i < static_cast<int>(changes.size()); ++i) {
        places.push_back(i);
    }
    return places;
}

/// The place of the change of this object; there must be one alone.
int placeOfChange(const std::vector<LevelChange>& changes, Key key) {
    int place = -1;
    for (const int i : placesOf(changes)) {
        if (changes[static_cast<std::size_t>(i)].object == key) {
            EXPECTS(place < 0);
            place = i;
        }
    }
    EXPECTS(place >= 0);
    return place;
}

/// The level after some edits of all kinds, as somebody makes them while it runs.
Level editedAtRandom(std::uint64_t seed, Level level) {
    Random random(seed);
    for (std::uint64_t edits = 1 + random.below(6); edits > 0; --edits) {
        EditTask task(random.next(), level);
        const auto& row = everyEdit()[random.below(static_cast<unsigned>(everyEdit().size()))];
        level = row.run(task);
    }
    return level;
}

std::uint64_t keptSeeds() {
    return static_cast<std::uint64_t>(fullOrQuick(2000, usualOrThin(40, 8)));
}

} // namespace

class KeptChangesTest : public QObject {
    Q_OBJECT

  private slots:
    void whatAUserWouldCallOneChangeIsOneEntry() {
        const Level before = ballsOneToThree();
        Level after = moved(withFields(before, 1, 0.9, 0.5), KeptKeys{2}, {1, 2});
        after.gravity = {1, -2};
        after.rules.lives = 7;
        after.iterations = 4;
        after = removed(added(after, keptBall(9)), KeptKeys{3});
        const std::vector<LevelChange> changes = changesBetween(before, after);
        QCOMPARE(changes.size(), std::size_t(8)); // gravity, iterations, lives; 3 gone; 1 twice; 2 moved; 9 come
        QCOMPARE(changes[0].what.fields.size(), std::size_t(2));
        QCOMPARE(changes[3].what.objects.front().change, ObjectChange::Removed);
        const ObjectDifference& move =
            changes[static_cast<std::size_t>(placeOfChange(changes, 2))].what.objects.front();
        QCOMPARE(move.change, ObjectChange::Moved);
        QCOMPARE(move.fields.size(), std::size_t(2));
        QVERIFY(changesBetween(before, before).empty());
    }

    void whatIsLeftOutIsAsBefore() {
        const Level before = ballsOneToThree();
        Level after = withFields(before, 1, 0.9, 0.5);
        after.gravity.y() = -3;
        const std::vector<LevelChange> changes = changesBetween(before, after);
        QCOMPARE(changes.size(), std::size_t(3));
        const Level kept = withKept(before, after, changes, std::vector{0, 2});
        QCOMPARE(kept.gravity.y(), -3.0);
        const auto& ball = std::get<BodyObject>(kept.objects.find(1)->data);
        QCOMPARE(ball.friction, 0.9);
        QCOMPARE(ball.restitution, 0.0);
        QVERIFY(kept.objects.sharesPiece(1, before.objects));
    }

    void aConnectorIsKeptWithTheBodyThatItHolds() {
        const Level before = ballsOneToThree();
        Level after = added(before, keptBall(9));
        after = added(after, {10, "spring", ConnectorObject{.a = 9, .b = 1}, {}});
        const std::vector<LevelChange> changes = changesBetween(before, after);
        const int ball = placeOfChange(changes, 9);
        const int spring = placeOfChange(changes, 10);
        QVERIFY(keptTogether(changes, std::vector{ball}) == std::vector{ball});
        QVERIFY(keptTogether(changes, std::vector{spring}) == (std::vector{ball, spring}));
        QCOMPARE(withKept(before, after, changes, std::vector{spring}), after);
        QCOMPARE(withKept(before, after, changes, std::vector{ball}).objects.size(), 4);
    }

    void aBodyIsGoneOnlyWithTheConnectorThatHeldIt() {
        const Level before = added(ballsOneToThree(), {10, "spring", ConnectorObject{.a = 2, .b = 1}, {}});
        const Level after = removed(before, KeptKeys{2});
        const std::vector<LevelChange> changes = changesBetween(before, after);
        QVERIFY(withKept(before, after, changes, std::vector{placeOfChange(changes, 2)}) == after);
        const Level cut = withKept(before, after, changes, std::vector{placeOfChange(changes, 10)});
        QVERIFY(cut.objects.find(10) == nullptr && cut.objects.find(2) != nullptr);
    }

    void aBodyComesIntoAGroupOnlyWithTheGroup() {
        const Level before = ballsOneToThree();
        const Level after = grouped(before, KeptKeys{1, 2}, {20, "pair", GroupObject{}, {}});
        const std::vector<LevelChange> changes = changesBetween(before, after);
        const Level kept = withKept(before, after, changes, std::vector{placeOfChange(changes, 1)});
        QCOMPARE(kept.objects.find(1)->parent, Key(20));
        QVERIFY(kept.objects.find(20) != nullptr);
        QCOMPARE(kept.objects.find(2)->parent, Key(0));
    }

    void anotherShipNeedsTheFirstToGo() {
        Level before = ballsOneToThree();
        before.objects.append({30, "old", ShipObject{}, {}});
        const Level after = added(removed(before, KeptKeys{30}), {31, "new", ShipObject{{1, 1}}, {}});
        const std::vector<LevelChange> changes = changesBetween(before, after);
        QVERIFY(withKept(before, after, changes, std::vector{placeOfChange(changes, 31)}) == after);
    }

    void theOrderOfDrawingAndOfGuidesIsKeptByItself() {
        Level before = ballsOneToThree();
        before.guides = {{{0, 0}, 0, "a"}, {{0, 1}, 0, "b"}};
        Level after = moved(reordered(before, KeptKeys{1}, OrderTo::Front), KeptKeys{1}, {1, 0});
        std::swap(after.guides[0], after.guides[1]);
        const std::vector<LevelChange> changes = changesBetween(before, after);
        QCOMPARE(changes.size(), std::size_t(3));
        QVERIFY(changes[0].guides);
        for (const int i : {1, 2}) {
            const Level kept = withKept(before, after, changes, std::vector{i});
            const bool isOrder = changes[static_cast<std::size_t>(i)].what.objects.front().reordered;
            QCOMPARE(kept.objects[2].key, isOrder ? Key(1) : Key(3));
            QCOMPARE(std::get<BodyObject>(kept.objects.find(1)->data).position.x(), isOrder ? 1.0 : 2.0);
            QVERIFY(kept.guides == before.guides);
        }
    }

    void allOfThemGiveTheFileOfTheEditsAndNoneThatOfBefore() {
        for (std::uint64_t seed = 1; seed <= keptSeeds(); ++seed) {
            const Level before = soundLevel(seed);
            const Level after = editedAtRandom(seed, before);
            const std::vector<LevelChange> changes = changesBetween(before, after);
            QVERIFY2(levelText(withKept(before, after, changes, placesOf(changes))) == levelText(after),
                     seedText(seed));
            QVERIFY2(levelText(withKept(before, after, changes, {})) == levelText(before), seedText(seed));
            QVERIFY2(changes.empty() == (before == after), seedText(seed));
        }
    }

    void whateverIsKeptIsALevel() {
        for (std::uint64_t seed = 1; seed <= keptSeeds(); ++seed) {
            const Level before = soundLevel(seed);
            const Level after = editedAtRandom(seed, before);
            const std::vector<LevelChange> changes = changesBetween(before, after);
            Random random(seed);
            std::vector<int> places;
            std::ranges::copy_if(placesOf(changes), std::back_inserter(places),
                                 [&random](int) { return random.below(2) == 0; });
            const Level kept = withKept(before, after, changes, places);
            ChangesKept oneByOne(before, after, changes);
            Level last = before;
            for (std::size_t i = places.size(); i > 0; --i) { // in any order
                last = oneByOne.with(places[i - 1]);
            }
            QVERIFY2(levelText(last) == levelText(kept), seedText(seed));
            QStringList faults = structuralBreaches(kept);
            for (const QString& known : structuralBreaches(after)) {
                faults.removeAll(known);
            }
            QVERIFY2(faults.empty(), qPrintable(faults.join(QLatin1Char(' ')) + QString::number(seed)));
            QVERIFY2(!saveError(kept), seedText(seed));
            QVERIFY2(parseLevel(levelText(kept), Checks::FileOnly).level == kept, seedText(seed));
        }
    }

    void keptOneByOneInAnyOrderTheyAddUpToAll() {
        for (std::uint64_t seed = 1; seed <= keptSeeds() / 4; ++seed) {
            Level level = soundLevel(seed);
            const Level after = editedAtRandom(seed, level);
            Random random(seed);
            std::size_t most = changesBetween(level, after).size();
            for (; !(level == after); --most) {
                QVERIFY2(most > 0, seedText(seed)); // each is one step nearer
                const std::vector<LevelChange> changes = changesBetween(level, after);
                const int place = static_cast<int>(random.below(static_cast<unsigned>(changes.size())));
                level = withKept(level, after, changes, std::vector{place});
            }
        }
    }
};

SPACETOW_TEST(KeptChangesTest)
#include "kept_changes_test.moc"
