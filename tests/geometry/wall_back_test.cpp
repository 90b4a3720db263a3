#include "tests/support/test_main.h"

#include "core/geometry/convex_parts.h"
#include "core/geometry/wall_back_tree.h"
#include "tests/geometry/random_parts.h"

#include <algorithm>
#include <numbers>

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

/// What is behind the walls of a cave, or of open ground.
std::vector<WallBackTree::Item> ground(Random& random, bool closed, double roughness) {
    const int count = 2 + static_cast<int>(random.below(200));
    std::vector<Vec2> corners;
    for (int i = 0; i <= count; ++i) {
        const double off = random.uniform(-roughness, roughness);
        const double turn = -2 * std::numbers::pi * (i % count) / count;
        corners.push_back(closed ? Vec2((20 + off) * std::cos(turn), (20 + off) * std::sin(turn))
                                 : Vec2(0.5 * i - 0.25 * count, off));
    }
    if (closed) {
        corners.back() = corners.front();
        std::reverse(corners.begin(), corners.end()); // free inside
    }
    std::vector<WallPart> walls(static_cast<std::size_t>(count));
    std::vector<WallPart*> pointers;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        walls[i].a = corners[i];
        walls[i].b = corners[i + 1];
        pointers.push_back(&walls[i]);
    }
    joinWalls(pointers);
    std::vector<WallBackTree::Item> items;
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
        Aabb box{walls[i].a, walls[i].a};
        box.include(walls[i].b);
        items.push_back({i, backOf(sideOf(walls[i], false)), box});
    }
    return items;
}

/// Whether points of the box are in the region, for which there is no error.
bool holdsAnyOf(const WallBack& region, const Aabb& box) {
    for (int i = 0; i <= 20; ++i) {
        for (int k = 0; k <= 20; ++k) {
            const Vec2 p = box.min + Vec2(0.05 * i * box.size().x(), 0.05 * k * box.size().y());
            if (region.meets({p, p})) {
                return true;
            }
        }
    }
    return false;
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

    void aTreeFindsWhatTheLoopFinds_data() {
        QTest::addColumn<bool>("closed");
        QTest::addColumn<double>("roughness"); // m
        QTest::newRow("a smooth cave") << true << 0.0;
        QTest::newRow("a rough cave") << true << 2.0;
        QTest::newRow("flat ground") << false << 0.0;
        QTest::newRow("rough ground") << false << 3.0;
    }
    void aTreeFindsWhatTheLoopFinds() {
        QFETCH(bool, closed);
        QFETCH(double, roughness);
        int found = 0;
        for (unsigned seed = 0; seed < 40; ++seed) {
            Random random(seed);
            const std::vector<WallBackTree::Item> items = ground(random, closed, roughness);
            const WallBackTree tree(items);
            for (int i = 0; i < 100; ++i) {
                const double far = random.below(3) == 0 ? 2000 : 30;
                const double x = random.uniform(-far, far);
                const Vec2 corner(x, random.uniform(-far, far));
                const double width = random.uniform(0, random.below(2) == 0 ? 1 : 20);
                const Aabb box{corner, corner + Vec2(width, random.uniform(0, 2))};
                std::vector<std::uint32_t> answer;
                tree.query(box, answer);
                std::sort(answer.begin(), answer.end());
                for (const WallBackTree::Item& item : items) {
                    const bool meets = !item.wall.overlaps(box) && item.region.meets(box);
                    const bool answered = std::binary_search(answer.begin(), answer.end(), item.number);
                    QVERIFY2(meets || !answered, QByteArray::number(seed));
                    QVERIFY2(!meets || answered || !holdsAnyOf(item.region, box), QByteArray::number(seed));
                }
                QVERIFY(std::adjacent_find(answer.begin(), answer.end()) == answer.end());
                found += static_cast<int>(answer.size());
            }
        }
        QVERIFY(found > 1000);
    }
};

SPACETOW_TEST(WallBackTest)
#include "wall_back_test.moc"
