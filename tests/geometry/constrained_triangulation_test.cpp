#include "core/geometry/constrained_triangulation.h"

#include "core/base/random.h"
#include "tests/support/full_run.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using Net = ConstrainedTriangulation;

std::int64_t areaOf(const Net& net, int triangle) {
    const GridPoint& a = net.point(net.origin(3 * triangle));
    const GridPoint& b = net.point(net.origin(3 * triangle + 1));
    const GridPoint& c = net.point(net.origin(3 * triangle + 2));
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// What is wrong with it as a triangulation of the square.
QByteArray faultOf(const Net& net) {
    std::int64_t area = 0;
    for (int edge = 0; edge < net.edgeCount(); ++edge) {
        const int twin = net.twin(edge);
        if (twin >= 0 && (net.twin(twin) != edge || net.origin(twin) != net.target(edge))) {
            return "twins";
        }
    }
    for (int triangle = 0; triangle < net.edgeCount() / 3; ++triangle) {
        if (areaOf(net, triangle) <= 0) {
            return "a flat triangle";
        }
        area += areaOf(net, triangle);
    }
    return area == 2 * Net::size * Net::size ? "" : "overlaps or holes";
}

/// Whether labelled edges lead from `a` to `b`, all with their labels, straight on but for rounding.
bool leads(const Net& net, int a, int b, const SideLabels& labels) {
    for (int steps = 0; a != b && steps < 1000; ++steps) {
        const GridPoint& from = net.point(a);
        const GridPoint& to = net.point(b);
        int next = -1;
        double best = 0;
        for (const int edge : net.edgesFrom(a)) {
            const GridPoint& p = net.point(net.target(edge));
            const auto x = static_cast<double>(p.x - from.x);
            const auto y = static_cast<double>(p.y - from.y);
            const auto toX = static_cast<double>(to.x - from.x);
            const auto toY = static_cast<double>(to.y - from.y);
            const double straightness = (x * toX + y * toY) / std::hypot(x, y) / std::hypot(toX, toY);
            const bool isLabelled =
                (labels.left < 0 || net.labelOf(edge) >= 0) && (labels.right < 0 || net.labelOf(net.twin(edge)) >= 0);
            if (isLabelled && straightness > best) {
                best = straightness;
                next = net.target(edge);
            }
        }
        if (next < 0) {
            return false;
        }
        a = next;
    }
    return a == b;
}

GridPoint randomGridPoint(Random& random, std::int64_t extent) {
    const std::int64_t middle = Net::size / 2;
    const auto place = [&] {
        return middle + static_cast<std::int64_t>(random.uniform(-1, 1) * static_cast<double>(extent));
    };
    const std::int64_t x = place();
    return {x, place()};
}

} // namespace

class ConstrainedTriangulationTest : public QObject {
    Q_OBJECT

  private slots:
    void equalPointsShareAVertex() {
        Net net;
        const std::vector<int> vertices = net.insertAll({{5, 5}, {9, 9}, {5, 5}, {7, 7}});
        QCOMPARE(vertices[0], vertices[2]);
        QCOMPARE(net.vertexCount(), Net::corners + 3);
        QCOMPARE(faultOf(net), QByteArray());
    }

    void constraintsThatCrossMeetInAVertex() {
        Net net;
        const std::vector<int> v = net.insertAll({{1000, 1000}, {3000, 3000}, {1000, 3000}, {3000, 1000}});
        QVERIFY(net.constrain(v[0], v[1], {1, SideLabels::none}));
        QVERIFY(net.constrain(v[2], v[3], {2, 2}));
        QCOMPARE(faultOf(net), QByteArray());
        QCOMPARE(net.vertexCount(), Net::corners + 5);
        const int middle = Net::corners + 4;
        QCOMPARE(net.point(middle), (GridPoint{2000, 2000}));
        const int edge = net.edgeBetween(v[0], middle);
        QVERIFY(net.labelOf(edge) == 1 && net.labelOf(net.twin(edge)) == SideLabels::none);
        QCOMPARE(net.labelOf(net.edgeBetween(middle, v[3])), 2);
        QVERIFY(!net.isVisible(v[0], v[1]) && net.isVisible(v[0], v[2]));
    }

    void aBentConstraintKeepsItsLabels() {
        Net net;
        const std::vector<int> v = net.insertAll({{1000, 1000}, {9000, 1000}, {5000, 2000}});
        QVERIFY(net.constrain(v[0], v[1], {3, 4}));
        const int via = net.bend(net.edgeBetween(v[0], v[1]), {5000, 1001});
        QCOMPARE(net.edgeBetween(v[0], v[1]), -1);
        for (const int edge : {net.edgeBetween(v[0], via), net.edgeBetween(via, v[1])}) {
            QVERIFY(net.labelOf(edge) == 3 && net.labelOf(net.twin(edge)) == 4);
        }
        QCOMPARE(faultOf(net), QByteArray());
    }

    void whateverComesInItStaysATriangulation() {
        const int scenes = fullOrQuick(1000, usualOrThin(60, 10));
        for (int i = 0; i < scenes; ++i) {
            const auto seed = static_cast<std::uint64_t>(i + 1);
            Random random(seed);
            constexpr std::int64_t extents[] = {6, 40, 100000, Net::size / 2 - 1};
            const std::int64_t extent = extents[random.below(4)];
            std::vector<GridPoint> points;
            for (unsigned k = 2 + random.below(60); k > 0; --k) {
                points.push_back(randomGridPoint(random, extent));
            }
            Net net;
            const std::vector<int> v = net.insertAll(points);
            std::vector<std::pair<int, int>> constraints;
            for (unsigned k = random.below(30); k > 0; --k) {
                const int a = v[random.below(static_cast<std::uint32_t>(v.size()))];
                const int b = v[random.below(static_cast<std::uint32_t>(v.size()))];
                constraints.emplace_back(a, b);
                QVERIFY2(net.constrain(a, b, {static_cast<int>(k), random.below(2) == 0 ? 1 : SideLabels::none}),
                         seedText(seed));
            }
            QVERIFY2(faultOf(net).isEmpty(), seedText(seed) + " " + faultOf(net));
            for (const auto& [a, b] : constraints) {
                QVERIFY2(extent < 1000 || leads(net, a, b, {0, SideLabels::none}), seedText(seed));
            }
        }
    }
};

SPACETOW_TEST(ConstrainedTriangulationTest)
#include "constrained_triangulation_test.moc"
