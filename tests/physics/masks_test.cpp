#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

#include "core/base/random.h"

#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int pairsInAWorld = 100;

/// Empty, full, one bit, the highest bit alone or among others, or any bits.
TagMask randomMask(Random& random) {
    switch (random.below(8)) {
    case 0:
        return {};
    case 1:
        return TagMask::all();
    case 2:
        return TagMask::bit(31);
    case 3:
        return TagMask{random.next() | 0x80000000u};
    case 4:
        return TagMask{random.next() & random.next() & random.next() & random.next()};
    default:
        return TagMask::bit(static_cast<int>(random.below(4)) + 28);
    }
}

/// The truth table, a bit at a time.
bool meets(std::uint32_t a, std::uint32_t b) {
    for (int i = 0; i < 32; ++i) {
        if ((a >> i) % 2 == 1 && (b >> i) % 2 == 1) {
            return true;
        }
    }
    return false;
}

bool shouldTouch(const Filter& a, const Filter& b) {
    return meets(a.touches.bits, b.tags.bits) && meets(b.touches.bits, a.tags.bits);
}

struct MaskedPair {
    BodyId lower, upper;
    Filter a, b;
};

/// Two balls that overlap a little, or a ball in a floor, far from all others.
MaskedPair addPair(World& world, Random& random, double x, bool solid) {
    BodyDef lower = random.below(2) == 0 ? ball({x, 0}, 0.2) : edgeBody({x - 1, 0.1}, {x + 1, 0.1});
    lower.kind = static_cast<BodyKind>(random.below(3));
    lower.filter = {randomMask(random), randomMask(random)};
    lower.restitution = 1;
    BodyDef upper = ball({x, 0.295}, 0.2);
    upper.filter = {randomMask(random), randomMask(random)};
    upper.velocity = {0, -1};
    upper.restitution = 1;
    upper.tangible = solid;
    const BodyId a = add(world, lower);
    const BodyId b = add(world, upper);
    return {a, b, lower.filter, upper.filter};
}

} // namespace

class MasksTest : public QObject {
    Q_OBJECT

  private slots:
    void aPairTouchesWhenTheTruthTableSaysSo_data() {
        QTest::addColumn<int>("iterations");
        QTest::addColumn<bool>("solid");
        for (const int iterations : iterationCounts) {
            QTest::addRow("solid, %d iterations", iterations) << iterations << true;
            QTest::addRow("intangible, %d iterations", iterations) << iterations << false;
        }
    }
    void aPairTouchesWhenTheTruthTableSaysSo() {
        QFETCH(int, iterations);
        QFETCH(bool, solid);
        int touching = 0;
        for (std::uint64_t seed = 1; seed <= 10000 / pairsInAWorld; ++seed) {
            Random random(seed);
            World world(withIterations(iterations, {0, 0}));
            std::vector<MaskedPair> pairs;
            for (int i = 0; i < pairsInAWorld; ++i) {
                pairs.push_back(addPair(world, random, 5.0 * i, solid));
            }
            world.update();
            std::set<std::pair<std::uint32_t, std::uint32_t>> began;
            for (const TouchEvent& event : world.events().began) {
                QCOMPARE(event.solid, solid);
                began.emplace(event.a.index, event.b.index);
            }
            for (const MaskedPair& pair : pairs) {
                const bool expected = shouldTouch(pair.a, pair.b);
                touching += expected ? 1 : 0;
                QVERIFY2(began.contains({pair.lower.index, pair.upper.index}) == expected, seedText(seed));
                const bool passed = world.body(pair.upper).velocity == Vec2(0, -1);
                QVERIFY2(passed == (!solid || !expected), seedText(seed));
            }
        }
        QVERIFY(touching > 1500 && touching < 8500);
    }

    void aTagMaskIsMetByASharedBit() {
        Random random(1);
        for (int i = 0; i < 10000; ++i) {
            const Filter a{randomMask(random), randomMask(random)};
            const Filter b{randomMask(random), randomMask(random)};
            QCOMPARE(mayTouch(a, b), shouldTouch(a, b));
            QCOMPARE(mayTouch(b, a), shouldTouch(a, b));
        }
    }

    void everyTagTouchedIsReported_data() {
        QTest::addColumn<int>("bit");
        for (int bit = 0; bit < 32; ++bit) {
            QTest::addRow("tag %d", bit) << bit;
        }
    }
    void everyTagTouchedIsReported() {
        QFETCH(int, bit);
        World world(withIterations(4, {0, 0}));
        BodyDef zone = ball({0, 0}, 0.5);
        zone.kind = BodyKind::Static;
        zone.tangible = false;
        zone.filter.tags = TagMask::bit(bit);
        add(world, zone);
        BodyDef def = ball({0.3, 0}, 0.5);
        def.reportsTouches = true;
        def.filter.touches = TagMask::bit(bit);
        const BodyId id = add(world, def);
        world.update();
        QCOMPARE(world.body(id).touchedTags, TagMask::bit(bit));
        QCOMPARE(world.events().tagsTouched.size(), std::size_t{4});
        QCOMPARE(world.events().tagsTouched.front().tags, TagMask::bit(bit));
        world.setPose(id, {5, 0}, 0);
        world.update();
        QCOMPARE(world.body(id).touchedTags, TagMask{});
        QVERIFY(world.events().tagsTouched.empty());
    }
};

SPACETOW_TEST(MasksTest)
#include "masks_test.moc"
