#include "core/geometry/segment_tree.h"

#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<Vec2> randomWalk(Random& random, std::size_t count) {
    std::vector<Vec2> points;
    Vec2 at(0, 0);
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(at);
        at += randomPoint(random, 1);
    }
    return points;
}

Aabb boxOf(const Vec2& a, const Vec2& b) {
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

Aabb segmentBox(const std::vector<Vec2>& points, int segment) {
    const auto i = static_cast<std::size_t>(segment);
    return boxOf(points[i], points[(i + 1) % points.size()]);
}

QByteArray seedText(unsigned seed) {
    return "seed " + QByteArray::number(seed);
}

} // namespace

class SegmentTreeTest : public QObject {
    Q_OBJECT

  private slots:
    void noSegmentInTheBoxIsMissedAndNoneIsVisitedTwice() {
        for (unsigned seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            const bool closed = random.below(2) == 0;
            const std::vector<Vec2> points = randomWalk(random, random.below(700));
            const SegmentTree tree(points, closed);
            const Vec2 a = randomPoint(random, 12);
            const Aabb box = boxOf(a, a + randomPoint(random, 4));
            std::vector<int> visits(points.size(), 0);
            int last = 0;
            tree.visit(box, [&](int first, int end) {
                QVERIFY2(first >= last && end > first && end - first <= SegmentTree::stretch, seedText(seed));
                last = end;
                for (int i = first; i < end; ++i) {
                    ++visits[static_cast<std::size_t>(i)];
                }
            });
            for (int i = 0; i < tree.segments(); ++i) {
                const int visited = visits[static_cast<std::size_t>(i)];
                QVERIFY2(visited <= 1, seedText(seed));
                QVERIFY2(visited == 1 || !segmentBox(points, i).overlaps(box), seedText(seed));
            }
        }
    }

    void descendingAllTheWayVisitsEverySegmentInItsBox() {
        for (unsigned seed = 0; seed < 300; ++seed) {
            Random random(seed);
            const std::vector<Vec2> points = randomWalk(random, random.below(700));
            const SegmentTree tree(points, true);
            int next = 0;
            tree.descend(
                [&](const Aabb& box, int first, int end) {
                    for (int i = first; i < end; ++i) {
                        [&] { QVERIFY2(box.contains(segmentBox(points, i)), seedText(seed)); }();
                    }
                    return true;
                },
                [&](int first, int end) {
                    QCOMPARE(first, next);
                    next = end;
                });
            QCOMPARE(next, static_cast<int>(points.size()));
        }
    }

    void whatHasNoSegmentIsNeverVisited() {
        const Aabb everywhere = Aabb{Vec2(0, 0), Vec2(0, 0)}.grown(1e9);
        const std::vector<Vec2> one{Vec2(1, 2)};
        int visits = 0;
        const auto count = [&](int, int) { ++visits; };
        SegmentTree().visit(everywhere, count);
        SegmentTree({}, true).visit(everywhere, count);
        SegmentTree(one, false).visit(everywhere, count);
        QCOMPARE(visits, 0);
        QVERIFY(SegmentTree(one, false).bounds().isEmpty());
    }
};

SPACETOW_TEST(SegmentTreeTest)
#include "segment_tree_test.moc"
