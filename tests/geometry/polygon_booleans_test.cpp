#include "core/geometry/polygon_booleans.h"

#include "core/base/random.h"
#include "core/geometry/polygon.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<Vec2> box(const Vec2& min, const Vec2& size) {
    const Vec2 max = min + size;
    return {min, {max.x(), min.y()}, max, {min.x(), max.y()}};
}

double areaOf(const PolygonSet& set) {
    double area = 0;
    for (const std::vector<Vec2>& outline : set) {
        area += signedArea(outline);
    }
    return area;
}

/// A star of random radii, which is simple.
std::vector<Vec2> star(Random& random, const Vec2& center) {
    std::vector<Vec2> points;
    const int count = 3 + static_cast<int>(random.next() % 10);
    for (int i = 0; i < count; ++i) {
        const double radius = 0.5 + static_cast<double>(random.next() % 1000) / 500;
        const double angle = 2 * std::numbers::pi * i / count;
        points.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

} // namespace

class PolygonBooleansTest : public QObject {
    Q_OBJECT

  private slots:
    /// What is left between them is one unit of the lattice wide: no line goes through its middle.
    void aHoleThatRoundingShutsAgainIsFilled() {
        const PolygonSet a{{{2e-5, 2e-5}, {3e-5, 1e-5}, {3e-5, 5e-5}}};
        const PolygonSet b{{{1e-5, 2e-5}, {2e-5, 2e-5}, {3e-5, 0}, {4e-5, 5e-5}},
                           {{0, 4e-5}, {1e-5, 2e-5}, {3e-5, 4e-5}, {5e-5, 3e-5}, {4e-5, 5e-5}}};
        QVERIFY(combined(a, b, PolygonBoolean::Union).empty()); // all of it is smaller than what counts
    }

    void aLargeHoleBesideOneThatRoundingShutsStaysOpen() {
        const PolygonSet a{{{2e-5, 2e-5}, {3e-5, 1e-5}, {3e-5, 5e-5}}};
        const PolygonSet b{{{1e-5, 2e-5}, {2e-5, 2e-5}, {3e-5, 0}, {4e-5, 5e-5}},
                           {{0, 4e-5}, {1e-5, 2e-5}, {3e-5, 4e-5}, {5e-5, 3e-5}, {4e-5, 5e-5}},
                           box({4.2e-5, -1.5}, {1 - 4.2e-5, 3}),
                           box({2, -1.5}, {1, 3}),
                           box({0.9, -1.5}, {1.2, 1}),
                           box({0.9, 0.5}, {1.2, 1})}; // around the hole of 1 m by 1 m
        QVERIFY(std::abs(areaOf(combined(a, b, PolygonBoolean::Union)) - 8) < 1e-3);
    }

    void boxesThatOverlapCombineOnTheGrid() {
        const PolygonSet a{box({0, 0}, {0.3, 0.3})};
        const PolygonSet b{box({0.1, 0.1}, {0.5, 0.1})};
        const PolygonSet both = combined(a, b, PolygonBoolean::Union);
        QCOMPARE(both.size(), std::size_t{1});
        for (const Vec2& corner : both.front()) {
            for (const double value : {corner.x(), corner.y()}) {
                QVERIFY(std::round(value * 10) / 10 == value); // to the bit
            }
        }
        QVERIFY(std::abs(areaOf(both) - (0.09 + 0.05 - 0.02)) < 1e-12);
        QVERIFY(std::abs(areaOf(combined(a, b, PolygonBoolean::Difference)) - 0.07) < 1e-12);
        QVERIFY(std::abs(areaOf(combined(a, b, PolygonBoolean::Intersection)) - 0.02) < 1e-12);
    }

    void whatIsApartStaysInTwo() {
        const PolygonSet both = combined({box({0, 0}, {1, 1})}, {box({3, 0}, {1, 1})}, PolygonBoolean::Union);
        QCOMPARE(both.size(), std::size_t{2});
        QVERIFY(combined({box({0, 0}, {1, 1})}, {box({3, 0}, {1, 1})}, PolygonBoolean::Intersection).empty());
    }

    void aHoleIsCutThrough() {
        const PolygonSet ring =
            combined({box({0, 0}, {5, 5})}, {box({1, 1}, {1, 1}), box({3, 3}, {1, 1})}, PolygonBoolean::Difference);
        QVERIFY(ring.size() >= 2);
        QVERIFY(std::abs(areaOf(ring) - 23) < 1e-6);
        for (const std::vector<Vec2>& outline : ring) {
            QVERIFY(isSimple(outline));
            QVERIFY(!contains(outline, Vec2(1.5, 1.5)) && !contains(outline, Vec2(3.5, 3.5)));
        }
    }

    void anIslandInAHoleIsKept() {
        const PolygonSet ring = combined({box({0, 0}, {5, 5})}, {box({1, 1}, {3, 3})}, PolygonBoolean::Difference);
        const PolygonSet all = combined(ring, {box({2, 2}, {1, 1})}, PolygonBoolean::Union);
        QVERIFY(std::abs(areaOf(all) - 17) < 1e-6);
    }

    void windingOfWhatGoesInDoesNotMatter() {
        std::vector<Vec2> clockwise = box({0, 0}, {1, 1});
        std::reverse(clockwise.begin(), clockwise.end());
        QVERIFY(std::abs(areaOf(combined({clockwise}, {box({0.5, 0}, {1, 1})}, PolygonBoolean::Union)) - 1.5) < 1e-9);
    }

    void randomAreasAddUp() {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            Random random(seed);
            const PolygonSet a{star(random, {0, 0})};
            const PolygonSet b{star(random, {1, 0.5})};
            const double all = areaOf(combined(a, b, PolygonBoolean::Union));
            const double less = areaOf(combined(a, b, PolygonBoolean::Difference));
            const double common = areaOf(combined(a, b, PolygonBoolean::Intersection));
            QVERIFY2(std::abs(areaOf(a) + areaOf(b) - common - all) < 1e-5, qPrintable(QString("seed %1").arg(seed)));
            QVERIFY2(std::abs(areaOf(a) - common - less) < 1e-5, qPrintable(QString("seed %1").arg(seed)));
        }
    }
};

SPACETOW_TEST(PolygonBooleansTest)
#include "polygon_booleans_test.moc"
