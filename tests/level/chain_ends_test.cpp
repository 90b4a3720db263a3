#include "core/level/chain_ends.h"

#include "core/level/nodes.h"
#include "tests/support/body_with.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

using EndPoints = std::vector<Vec2>;

Level withChainAt(LevelShape shape, const Vec2& position) {
    Level level;
    level.objects.append(bodyWith(1, std::move(shape), position));
    return level;
}

const LevelShape& chainOfFirst(const Level& level) {
    return std::get<BodyObject>(level.objects[0].data).shapes.front();
}

} // namespace

class ChainEndsTest : public QObject {
    Q_OBJECT

  private slots:
    void anOpenChainHasTwoEnds() {
        const Level level = withChainAt(EdgeChain{{{0, 0}, {2, 0}, {2, 1}}, false, 0.5}, {1, 1});
        QCOMPARE(openChain(level, {1, 0, true}), (OpenChain{{1, 1}, {3, 2}, 3, 0.5}));
        QCOMPARE(openChain(level, {1, 0, false}), (OpenChain{{3, 2}, {1, 1}, 3, 0.5}));
    }

    void whatIsNoOpenChainHasNone() {
        QVERIFY(!openChain(withChainAt(EdgeChain{{{0, 0}, {2, 0}, {2, 1}}, true}, {0, 0}), {1, 0, true}));
        QVERIFY(!openChain(withChainAt(Polygon{{{0, 0}, {2, 0}, {2, 1}}}, {0, 0}), {1, 0, true}));
        QVERIFY(!openChain(withChainAt(Circle{}, {0, 0}), {1, 0, true}));
        const Level level = withChainAt(LineChain{{{0, 0}, {2, 0}}, false}, {0, 0});
        QVERIFY(!openChain(level, {1, 1, true}));
        QVERIFY(!openChain(level, {2, 0, true}));
        const EndPoints points{{5, 5}};
        QVERIFY(extended(level, {2, 0, true}, points, false) == level);
    }

    void pointsComeInTheDirectionOfTheChain() {
        const Level level = withChainAt(LineChain{{{0, 0}, {2, 0}}, false}, {1, 1});
        const EndPoints points{{4, 1}, {4, 4}};
        QVERIFY(chainOfFirst(extended(level, {1, 0, false}, points, false)) ==
                LevelShape(LineChain{{{0, 0}, {2, 0}, {3, 0}, {3, 3}}, false}));
        QVERIFY(chainOfFirst(extended(level, {1, 0, true}, points, true)) ==
                LevelShape(LineChain{{{3, 3}, {3, 0}, {0, 0}, {2, 0}}, true}));
    }

    void twoPointsEncloseNothing() {
        const Level level = withChainAt(LineChain{{{0, 0}, {2, 0}}, false}, {0, 0});
        QVERIFY(extended(level, {1, 0, false}, {}, true) == level);
    }

    void anyOpenChainIsExtendedAndTheLevelBeforeStays() {
        int chains = 0;
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            const Level level = randomLevel(seed, 12);
            const Level before = level;
            for (const Object& object : level.objects) {
                const ChainEnd end{object.key, 0, seed % 2 == 0};
                const std::optional<OpenChain> chain = openChain(level, end);
                if (!chain) {
                    continue;
                }
                ++chains;
                const EndPoints points{chain->at + Vec2(1, 2)};
                const Level after = extended(level, end, points, false);
                QVERIFY2(level == before, qPrintable(QString("seed %1").arg(seed)));
                const std::optional<OpenChain> longer = openChain(after, end);
                QVERIFY(longer && longer->vertices == chain->vertices + 1 && longer->other == chain->other);
                QVERIFY2((longer->at - points.front()).norm() < 1e-9 * std::max(1.0, points.front().norm()),
                         qPrintable(QString("seed %1").arg(seed)));
            }
        }
        QVERIFY(chains > 20);
    }
};

SPACETOW_TEST(ChainEndsTest)
#include "chain_ends_test.moc"
