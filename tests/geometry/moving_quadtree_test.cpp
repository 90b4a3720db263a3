#include "core/geometry/moving_quadtree.h"

#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<std::uint32_t> found(const MovingQuadtree& tree, const Aabb& area) {
    std::vector<std::uint32_t> numbers;
    tree.query(area, numbers);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

std::vector<std::uint32_t> bruteForce(const std::vector<Aabb>& boxes, const Aabb& area) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].overlaps(area)) {
            numbers.push_back(i);
        }
    }
    return numbers;
}

/// Whether each box finds all others that it overlaps.
bool findsAllPairs(const MovingQuadtree& tree, const std::vector<Aabb>& boxes) {
    return std::all_of(boxes.begin(), boxes.end(),
                       [&](const Aabb& box) { return found(tree, box) == bruteForce(boxes, box); });
}

std::vector<Aabb> randomBoxes(Random& random, std::size_t count, bool onGrid) {
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 min = onGrid ? Vec2(random.below(9), random.below(9)) : randomPoint(random, 5);
        const Vec2 size =
            onGrid ? Vec2(random.below(4), random.below(4)) : Vec2(random.uniform(0, 2), random.uniform(0, 2));
        boxes.push_back({min, min + size});
    }
    return boxes;
}

Aabb boundsOfAll(const std::vector<Aabb>& boxes) {
    Aabb bounds;
    for (const Aabb& b : boxes) {
        bounds.include(b);
    }
    return bounds;
}

} // namespace

class MovingQuadtreeTest : public QObject {
    Q_OBJECT

  private slots:
    void queriesEqualBruteForceEachBoxOnce();
    void allPairsEqualBruteForceEachOnce();
    void boxesOfAllSizesAreFound();
    void farFromTheOriginNothingIsMissed();
    void depthIsTheLogarithmOfTheCount_data();
    void depthIsTheLogarithmOfTheCount();
    void fillingForgetsEverything();
    void boundsWithoutExtentDoNoHarm();
    void cellsLieWithinTheBounds();
};

void MovingQuadtreeTest::queriesEqualBruteForceEachBoxOnce() {
    MovingQuadtree tree; // used again and again, as in the step
    for (unsigned seed = 0; seed < 10000; ++seed) {
        Random random(seed);
        const std::vector<Aabb> boxes = randomBoxes(random, random.below(60), random.below(2) == 0);
        tree.fill(boxes);
        QVERIFY2(findsAllPairs(tree, boxes), "seed " + QByteArray::number(seed));
        for (const Aabb& area : randomBoxes(random, 10, random.below(2) == 0)) { // some of it outside of the bounds
            QVERIFY2(found(tree, area) == bruteForce(boxes, area), "seed " + QByteArray::number(seed));
        }
    }
}

/// From a hundredth to a hundred times the usual one, and as thin as they are long.
void MovingQuadtreeTest::allPairsEqualBruteForceEachOnce() {
    MovingQuadtree tree;
    std::vector<MovingQuadtree::BoxPair> pairs;
    for (unsigned seed = 0; seed < 5000; ++seed) {
        Random random(seed);
        std::vector<Aabb> boxes = randomBoxes(random, random.below(60), random.below(2) == 0);
        for (const Aabb& large : randomBoxes(random, random.below(4), false)) { // these are on other levels
            boxes.push_back({large.min, large.min + 5 * large.size()});
        }
        tree.fill(boxes);
        pairs.clear();
        tree.queryAll(pairs);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
        for (const auto& [a, b] : pairs) {
            all.emplace_back(std::min(a, b), std::max(a, b));
        }
        std::sort(all.begin(), all.end());
        std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            for (std::uint32_t k = i + 1; k < boxes.size(); ++k) {
                if (boxes[i].overlaps(boxes[k])) {
                    expected.emplace_back(i, k);
                }
            }
        }
        QVERIFY2(all == expected, "seed " + QByteArray::number(seed));
    }
}

void MovingQuadtreeTest::boxesOfAllSizesAreFound() {
    MovingQuadtree tree;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        std::vector<Aabb> boxes;
        for (int i = 0; i < 100; ++i) {
            const Vec2 min = randomPoint(random, 10);
            const Vec2 size(std::pow(10, random.uniform(-2, 2)), std::pow(10, random.uniform(-2, 2)));
            boxes.push_back({min, min + size});
        }
        tree.fill(boxes);
        QVERIFY2(findsAllPairs(tree, boxes), "seed " + QByteArray::number(seed));
    }
}

/// Where sizes and corners are rounded to what is no longer small beside a cell, boxes that only touch still do.
void MovingQuadtreeTest::farFromTheOriginNothingIsMissed() {
    MovingQuadtree tree;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        const Vec2 far = std::pow(10, random.uniform(3, 12)) * randomPoint(random, 1);
        std::vector<Aabb> boxes;
        for (int i = 0; i < 60; ++i) {
            const Vec2 min = far + 0.1 * Vec2(random.below(9), random.below(9));
            boxes.push_back({min, min + 0.1 * Vec2(random.below(4), random.below(4))});
        }
        tree.fill(boxes);
        QVERIFY2(findsAllPairs(tree, boxes), "seed " + QByteArray::number(seed));
    }
}

void MovingQuadtreeTest::depthIsTheLogarithmOfTheCount_data() {
    QTest::addColumn<std::uint32_t>("count");
    QTest::addColumn<int>("depth");
    int row = 0;
    for (const auto& [count, depth] : {std::pair{0u, 0},
                                       {1u, 0},
                                       {2u, 1},
                                       {4u, 1},
                                       {5u, 2},
                                       {16u, 2},
                                       {17u, 3},
                                       {1000u, 5},
                                       {1024u, 5},
                                       {1025u, 6}}) {
        QTest::addRow("%d: %u boxes", row++, count) << count << depth;
    }
}

void MovingQuadtreeTest::depthIsTheLogarithmOfTheCount() {
    QFETCH(std::uint32_t, count);
    QFETCH(int, depth);
    MovingQuadtree tree;
    tree.fill(std::vector<Aabb>(count, Aabb{Vec2(0, 0), Vec2(1, 1)}));
    QCOMPARE(tree.depth(), depth);
}

void MovingQuadtreeTest::fillingForgetsEverything() {
    MovingQuadtree tree;
    const Aabb box{Vec2(0, 0), Vec2(1, 1)};
    QVERIFY(found(tree, box).empty());
    for (const std::size_t count : {3u, 1u, 2u, 0u}) {
        tree.fill(std::vector<Aabb>(count, box));
        QCOMPARE(found(tree, box).size(), count);
    }
}

void MovingQuadtreeTest::boundsWithoutExtentDoNoHarm() {
    MovingQuadtree tree;
    std::vector<Aabb> boxes(20, Aabb{Vec2(1, 1), Vec2(1, 1)});
    tree.fill(boxes);
    QVERIFY(findsAllPairs(tree, boxes));
    boxes.push_back({Vec2(0, 1), Vec2(5, 1)});
    tree.fill(boxes);
    QVERIFY(findsAllPairs(tree, boxes));
}

void MovingQuadtreeTest::cellsLieWithinTheBounds() {
    Random random(4);
    const std::vector<Aabb> boxes = randomBoxes(random, 60, false);
    MovingQuadtree tree;
    tree.fill(boxes);
    const std::vector<Aabb> cells = tree.cells();
    QVERIFY(!cells.empty() && cells.size() <= 60);
    for (const Aabb& cell : cells) {
        QVERIFY(boundsOfAll(boxes).grown(1e-9).contains(cell));
        const bool used = std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& b) { return b.overlaps(cell); });
        QVERIFY(used);
    }
}

SPACETOW_TEST(MovingQuadtreeTest)
#include "moving_quadtree_test.moc"
