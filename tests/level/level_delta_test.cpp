#include "core/level/level_delta.h"
#include "tests/support/move_object.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level shuffledAndChanged(Level level, std::uint64_t seed) {
    Random random(seed);
    const auto any = [&] { return static_cast<int>(random.below(static_cast<std::uint32_t>(level.objects.size()))); };
    level.objects.erase(any());
    Object object = level.objects[any()];
    object.name += " changed";
    level.objects.replace(level.objects.indexOf(object.key), object);
    object.key = freshKey(level, seed);
    if (random.below(2) == 0) {
        level.objects.append(object);
    } else {
        level.objects.insert(any(), object);
    }
    if (random.below(3) == 0) {
        moveObject(level.objects, any(), any());
    }
    level.gravity.x() += random.uniform(-1, 1);
    return level;
}

} // namespace

class LevelDeltaTest : public QObject {
    Q_OBJECT

  private slots:
    void aDeltaMakesOfTheOneLevelTheOther() {
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const Level before = randomLevel(seed);
            const Level after = seed % 5 == 0 ? randomLevel(seed + 1000) : shuffledAndChanged(before, seed);
            QVERIFY2(withDelta(before, deltaBetween(before, after)) == after, std::to_string(seed).c_str());
            QVERIFY2(withDelta(after, deltaBetween(after, before)) == before, std::to_string(seed).c_str());
        }
    }
    void whatStaysIsNotInIt() {
        const Level before = randomLevel(3, 40);
        QVERIFY(deltaBetween(before, before).changed.objects.empty());
        QVERIFY(deltaBetween(before, randomLevel(3, 40)).changed.objects.empty()); // equal values will do
        Level after = before;
        Object object = after.objects[7];
        object.name += "!";
        after.objects.replace(7, object);
        after.objects.erase(20);
        const LevelDelta delta = deltaBetween(before, after);
        QCOMPARE(delta.changed.objects.size(), 1);
        QCOMPARE(delta.removed, std::vector<Key>{before.objects[20].key});
        QVERIFY(delta.order.empty());
        object.key = freshKey(after, 1);
        after.objects.append(object);
        QVERIFY(deltaBetween(before, after).order.empty());
        moveObject(after.objects, 3, 9);
        QVERIFY(!deltaBetween(before, after).order.empty());
    }
    void onAnotherLevelItDoesWhatItCan() {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const Level before = randomLevel(seed);
            const LevelDelta delta = deltaBetween(before, shuffledAndChanged(before, seed));
            const Level other = randomLevel(seed + 500);
            const Level result = withDelta(other, delta);
            std::vector<Key> keys;
            for (const Object& object : result.objects) {
                keys.push_back(object.key);
            }
            std::ranges::sort(keys);
            QVERIFY(std::ranges::adjacent_find(keys) == keys.end());
            for (const Object& object : delta.changed.objects) {
                QVERIFY(result.objects.find(object.key) != nullptr);
            }
            QVERIFY(result.gravity == delta.changed.gravity);
        }
    }
};

SPACETOW_TEST(LevelDeltaTest)
#include "level_delta_test.moc"
