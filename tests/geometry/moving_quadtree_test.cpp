#include "core/geometry/moving_quadtree.h"

#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// All pairs in the order in which the tree tells them, earlier box first.
Pairs pairsOf(MovingQuadtree& tree, const std::vector<Aabb>& boxes) {
    Pairs pairs;
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        found.clear();
        tree.insertAndQuery(i, boxes[i], found);
        for (const std::uint32_t other : found) {
            pairs.emplace_back(other, i);
        }
    }
    return pairs;
}

Pairs bruteForce(const std::vector<Aabb>& boxes) {
    Pairs pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        for (std::uint32_t k = i + 1; k < boxes.size(); ++k) {
            if (boxes[i].overlaps(boxes[k])) {
                pairs.emplace_back(i, k);
            }
        }
    }
    return pairs;
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
    void pairsEqualBruteForceEachOnce();
    void boxesOutsideTheBoundsAreFoundAsWell();
    void depthIsTheLogarithmOfTheCount_data();
    void depthIsTheLogarithmOfTheCount();
    void aResetForgetsEverything();
    void boundsWithoutExtentDoNoHarm();
    void cellsLieWithinTheBounds();
};

void MovingQuadtreeTest::pairsEqualBruteForceEachOnce() {
    MovingQuadtree tree; // used again and again, as in the step
    for (unsigned seed = 0; seed < 10000; ++seed) {
        Random random(seed);
        const std::vector<Aabb> boxes = randomBoxes(random, random.below(60), random.below(2) == 0);
        tree.reset(boundsOfAll(boxes), static_cast<std::uint32_t>(boxes.size()));
        Pairs pairs = pairsOf(tree, boxes);
        std::sort(pairs.begin(), pairs.end());
        QVERIFY2(pairs == bruteForce(boxes), "seed " + QByteArray::number(seed));
    }
}

void MovingQuadtreeTest::boxesOutsideTheBoundsAreFoundAsWell() {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        const std::vector<Aabb> boxes = randomBoxes(random, 50, random.below(2) == 0);
        MovingQuadtree tree;
        tree.reset({Vec2(1, 1), Vec2(3, 2)}, 50);
        Pairs pairs = pairsOf(tree, boxes);
        std::sort(pairs.begin(), pairs.end());
        QVERIFY2(pairs == bruteForce(boxes), "seed " + QByteArray::number(seed));
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
    tree.reset({Vec2(0, 0), Vec2(1, 1)}, count);
    QCOMPARE(tree.depth(), depth);
}

void MovingQuadtreeTest::aResetForgetsEverything() {
    MovingQuadtree tree;
    const Aabb box{Vec2(0, 0), Vec2(1, 1)};
    std::vector<std::uint32_t> found;
    for (int i = 0; i < 3; ++i) {
        tree.reset(box, 2);
        tree.insertAndQuery(7, box, found);
        QVERIFY(found.empty());
    }
    tree.insertAndQuery(8, box, found);
    QCOMPARE(found, std::vector<std::uint32_t>{7});
}

void MovingQuadtreeTest::boundsWithoutExtentDoNoHarm() {
    MovingQuadtree tree;
    for (const Aabb& bounds : {Aabb{}, Aabb{Vec2(1, 1), Vec2(1, 1)}, Aabb{Vec2(0, 1), Vec2(5, 1)}}) {
        tree.reset(bounds, 20);
        const std::vector<Aabb> boxes(20, Aabb{Vec2(1, 1), Vec2(1, 1)});
        QCOMPARE(pairsOf(tree, boxes).size(), std::size_t{190});
    }
}

void MovingQuadtreeTest::cellsLieWithinTheBounds() {
    Random random(4);
    const std::vector<Aabb> boxes = randomBoxes(random, 60, false);
    MovingQuadtree tree;
    tree.reset(boundsOfAll(boxes), 60);
    pairsOf(tree, boxes);
    const std::vector<Aabb> cells = tree.cells();
    QVERIFY(!cells.empty() && cells.size() <= 64);
    for (const Aabb& cell : cells) {
        QVERIFY(boundsOfAll(boxes).grown(1e-9).contains(cell));
        const bool used = std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& b) { return b.overlaps(cell); });
        QVERIFY(used);
    }
}

SPACETOW_TEST(MovingQuadtreeTest)
#include "moving_quadtree_test.moc"
