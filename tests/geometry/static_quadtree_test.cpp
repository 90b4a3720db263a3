#include "core/geometry/static_quadtree.h"

#include "tests/geometry/random_parts.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Aabb boxAt(const Vec2& center, const Vec2& half) {
    return {center - half, center + half};
}

/// Boxes on a coarse grid, so that borders coincide with each other and with the cells, or anywhere.
std::vector<Aabb> randomStaticBoxes(Random& random, std::size_t count, bool onGrid) {
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        if (onGrid) {
            const Vec2 min(random.below(9), random.below(9));
            boxes.push_back({min, min + Vec2(random.below(4), random.below(4))});
        } else {
            const Vec2 center = randomPoint(random, 5);
            boxes.push_back(boxAt(center, Vec2(random.uniform(0, 1), random.uniform(0, 1))));
        }
    }
    return boxes;
}

std::vector<std::uint32_t> foundOneByOne(const std::vector<Aabb>& boxes, const Aabb& area) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].overlaps(area)) {
            found.push_back(i);
        }
    }
    return found;
}

} // namespace

class StaticQuadtreeTest : public QObject {
    Q_OBJECT

  private slots:
    void queriesEqualBruteForceEachBoxOnce();
    void anEmptyTreeHoldsNothing();
    void emptyBoxesAndAreasAreNeverFound();
    void pointsOnBordersFindAllBoxes();
    void stackedBoxesEndInALeaf();
    void cellsCoverTheBoundsWithoutOverlap();
    void theTreeIsTheSameEveryTime();
    void aHundredThousandBoxesAreDividedWell();
    void boxesThatReachFarAreNotHeldTooOften();
};

void StaticQuadtreeTest::queriesEqualBruteForceEachBoxOnce() {
    for (unsigned seed = 0; seed < 10000; ++seed) {
        Random random(seed);
        const bool onGrid = random.below(2) == 0;
        const StaticQuadtree tree(randomStaticBoxes(random, random.below(60), onGrid));
        for (const Aabb& area : randomStaticBoxes(random, 4, onGrid)) {
            std::vector<std::uint32_t> found;
            tree.query(area, found);
            std::sort(found.begin(), found.end());
            QVERIFY2(found == foundOneByOne(tree.boxes(), area), seedText(seed));
        }
    }
}

void StaticQuadtreeTest::anEmptyTreeHoldsNothing() {
    std::vector<std::uint32_t> found;
    StaticQuadtree().query(boxAt(Vec2(0, 0), Vec2(1e9, 1e9)), found);
    StaticQuadtree(std::vector<Aabb>{}).query(boxAt(Vec2(0, 0), Vec2(1e9, 1e9)), found);
    QVERIFY(found.empty());
    QVERIFY(StaticQuadtree().cells().empty());
    QCOMPARE(StaticQuadtree().depth(), 0);
}

void StaticQuadtreeTest::emptyBoxesAndAreasAreNeverFound() {
    const StaticQuadtree tree({Aabb{}, boxAt(Vec2(0, 0), Vec2(1, 1)), Aabb{}});
    std::vector<std::uint32_t> found;
    tree.query(boxAt(Vec2(0, 0), Vec2(9, 9)), found);
    QCOMPARE(found, std::vector<std::uint32_t>{1});
    found.clear();
    tree.query(Aabb{}, found);
    QVERIFY(found.empty());
}

void StaticQuadtreeTest::pointsOnBordersFindAllBoxes() {
    std::vector<Aabb> tiles; // 8 × 8 squares side by side
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            tiles.push_back({Vec2(x, y), Vec2(x + 1, y + 1)});
        }
    }
    const StaticQuadtree tree(tiles);
    for (int y = 1; y < 8; ++y) {
        for (int x = 1; x < 8; ++x) {
            std::vector<std::uint32_t> found;
            tree.query({Vec2(x, y), Vec2(x, y)}, found);
            QCOMPARE(found.size(), std::size_t{4});
        }
    }
}

void StaticQuadtreeTest::stackedBoxesEndInALeaf() {
    const StaticQuadtree tree(std::vector<Aabb>(1000, boxAt(Vec2(3, 3), Vec2(1, 1))));
    QVERIFY(tree.depth() <= 3);
    std::vector<std::uint32_t> found;
    tree.query(boxAt(Vec2(3, 3), Vec2(0.1, 0.1)), found);
    QCOMPARE(found.size(), std::size_t{1000});
}

void StaticQuadtreeTest::cellsCoverTheBoundsWithoutOverlap() {
    for (unsigned seed = 0; seed < 100; ++seed) {
        Random random(seed);
        const std::vector<Aabb> boxes = randomStaticBoxes(random, 50, false);
        Aabb bounds;
        for (const Aabb& b : boxes) {
            bounds.include(b);
        }
        double area = 0;
        for (const Aabb& cell : StaticQuadtree(boxes).cells()) {
            QVERIFY2(bounds.contains(cell), seedText(seed));
            area += cell.size().prod();
        }
        QVERIFY2(isNear(area, bounds.size().prod(), 1e-9), seedText(seed));
    }
}

void StaticQuadtreeTest::theTreeIsTheSameEveryTime() {
    Random random(9);
    const std::vector<Aabb> boxes = randomStaticBoxes(random, 500, false);
    const StaticQuadtree first(boxes);
    const StaticQuadtree second(boxes);
    std::vector<std::uint32_t> ofFirst;
    std::vector<std::uint32_t> ofSecond;
    first.query(boxAt(Vec2(0, 0), Vec2(3, 3)), ofFirst);
    second.query(boxAt(Vec2(0, 0), Vec2(3, 3)), ofSecond);
    QCOMPARE(ofFirst, ofSecond);
    QCOMPARE(first.depth(), second.depth());
}

void StaticQuadtreeTest::aHundredThousandBoxesAreDividedWell() {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 100000; ++i) { // a cave's floor
        const double x = 0.02 * i;
        boxes.push_back(boxAt(Vec2(x, 3 * std::sin(0.7 * x)), Vec2(0.15, 0.15)));
    }
    const StaticQuadtree tree(boxes);
    QVERIFY(tree.depth() < 40);
    for (const double x : {1.0, 500.0, 1999.0}) {
        const Aabb area = boxAt(Vec2(x, 3 * std::sin(0.7 * x)), Vec2(0.2, 0.2));
        std::vector<std::uint32_t> found;
        tree.query(area, found);
        std::sort(found.begin(), found.end());
        QVERIFY(found == foundOneByOne(boxes, area));
    }
    // Enough leaves that no query has to look at more than a small share of the boxes.
    QVERIFY(tree.cells().size() > 5000);
}

/// As those of the walls of a cave, behind which all is solid as far as the level goes.
void StaticQuadtreeTest::boxesThatReachFarAreNotHeldTooOften() {
    constexpr int count = 20000;
    const Aabb level = boxAt(Vec2(0, 0), Vec2(75, 75));
    std::vector<Aabb> boxes;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        const double radius = 60 * (1 + 0.2 * std::sin(5 * angle) + 0.04 * std::sin(61 * angle));
        const Vec2 out(std::cos(angle), std::sin(angle));
        Aabb box = boxAt(radius * out, Vec2(0.02, 0.02));
        box.include((radius * out + 200 * out).cwiseMax(level.min).cwiseMin(level.max));
        boxes.push_back(box);
    }
    const StaticQuadtree tree(boxes);
    QVERIFY2(tree.held() < 8 * boxes.size(), QByteArray::number(static_cast<double>(tree.held()) / count));
    for (unsigned seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const Aabb area = boxAt(randomPoint(random, 70), Vec2(1, 1));
        std::vector<std::uint32_t> found;
        tree.query(area, found);
        std::sort(found.begin(), found.end());
        QVERIFY2(found == foundOneByOne(boxes, area), seedText(seed));
    }
}

SPACETOW_TEST(StaticQuadtreeTest)
#include "static_quadtree_test.moc"
