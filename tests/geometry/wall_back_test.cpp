#include "tests/support/test_main.h"

#include "core/geometry/convex_parts.h"
#include "core/geometry/wall_back.h"
#include "tests/geometry/random_parts.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Three edges end to end, at random.
std::array<WallPart, 3> chain(Random& random) {
    std::array<Vec2, 4> corners;
    for (Vec2& corner : corners) {
        const double x = random.uniform(-3, 3);
        corner = {x, random.uniform(-3, 3)};
    }
    std::array<WallPart, 3> walls;
    std::array<WallPart*, 3> pointers;
    for (std::size_t i = 0; i < 3; ++i) {
        walls[i].a = corners[i];
        walls[i].b = corners[i + 1];
        pointers[i] = &walls[i];
    }
    joinWalls(pointers);
    return walls;
}

} // namespace

class WallBackTest : public QObject {
    Q_OBJECT

  private slots:
    void allThatAWallHoldsIsBehindIt() {
        int held = 0;
        for (unsigned seed = 0; seed < 20000; ++seed) {
            Random random(seed);
            const WallSide side = sideOf(chain(random)[1], false);
            const WallBack back = backOf(side);
            const double far = random.below(2) == 0 ? 5 : 1000;
            const double x = random.uniform(-far, far);
            const Vec2 p(x, random.uniform(-far, far));
            if (side.above(p) <= 0 && side.holds(p)) {
                ++held;
                QVERIFY2(back.meets({p, p}), QByteArray::number(seed));
                QVERIFY2(back.within(Aabb{p, p}.grown(random.uniform(0, 9))).grown(1e-6).contains(p),
                         QByteArray::number(seed));
            }
        }
        QVERIFY(held > 1000);
    }

    void aBoxBesideOrBeforeTheWallIsNotBehindIt() {
        WallPart wall;
        wall.a = {0, 0};
        wall.b = {4, 0};
        const WallBack back = backOf(sideOf(wall, false));
        QVERIFY(back.meets({{1, -500}, {2, -400}}));
        QVERIFY(back.meets({{-1, -3}, {9, 3}}));
        QVERIFY(!back.meets({{1, 0.1}, {2, 5}}));
        QVERIFY(!back.meets({{-2, -9}, {-0.1, 9}}));
        QVERIFY(!back.meets({{4.1, -9}, {9, 9}}));
        const double nothing = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!back.meets({{nothing, nothing}, {nothing, nothing}}));
    }

    void itsBoxIsCutToTheArea() {
        WallPart wall;
        wall.a = {0, 0};
        wall.b = {4, 0};
        const WallBack back = backOf(sideOf(wall, false));
        const Aabb box = back.within({{-10, -20}, {10, 20}});
        QVERIFY(isNear(box.min, Vec2(0, -20), 1e-5) && isNear(box.max, Vec2(4, 0), 1e-5));
        QVERIFY(back.within({{5, -20}, {10, 20}}).isEmpty());
        QVERIFY(back.within({}).isEmpty());
    }
};

SPACETOW_TEST(WallBackTest)
#include "wall_back_test.moc"
