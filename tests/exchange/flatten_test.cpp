#include "editor/exchange/flatten.h"

#include "core/base/random.h"
#include "core/geometry/intersect.h"
#include "core/math/rot.h"
#include "editor/exchange/svg_path.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <limits>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int manyVertices = 1'000'000;

double distanceToPolyline(const std::vector<Vec2>& points, const Vec2& p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        nearest = std::min(nearest, (closestOnSegment(points[i], points[i + 1], p) - p).norm());
    }
    return nearest;
}

Vec2 onCubic(const Vec2& a, const CubicPiece& cubic, double t) {
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * cubic.control1 + 3 * s * t * t * cubic.control2 + t * t * t * cubic.to;
}

Vec2 onArc(const ArcPiece& arc, double t) {
    const Rot at = Rot::fromAngle(arc.from + t * arc.sweep);
    return arc.center + at.c * arc.u + at.s * arc.v;
}

Vec2 randomPoint(Random& random) {
    const double x = random.uniform(-10, 10);
    return {x, random.uniform(-10, 10)};
}

/// How far a path of one piece strays from its segments, by many points of it.
double straying(const DrawnPath& path, const std::vector<Vec2>& points) {
    constexpr int samples = 300;
    double worst = 0;
    for (int i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        const PathPiece& piece = path.pieces.front();
        const auto* const cubic = std::get_if<CubicPiece>(&piece);
        const Vec2 at = cubic != nullptr ? onCubic(path.start, *cubic, t) : onArc(std::get<ArcPiece>(piece), t);
        worst = std::max(worst, distanceToPolyline(points, at));
    }
    return worst;
}

} // namespace

class FlattenTest : public QObject {
    Q_OBJECT

  private slots:
    void noCurveStraysFurtherThanTheTolerance() {
        const std::uint64_t seed = 20261;
        Random random(seed);
        for (int i = 0; i < fullOrQuick(2000, 150); ++i) {
            const double tolerance = std::pow(10, random.uniform(-3, 0));
            DrawnPath path{randomPoint(random), {}, false};
            if (i % 2 == 0) {
                const Vec2 first = randomPoint(random);
                const Vec2 second = i % 10 == 0 ? first : randomPoint(random); // sometimes with a cusp
                path.pieces.emplace_back(CubicPiece{first, second, randomPoint(random)});
            } else {
                ArcPiece arc{path.start,
                             randomPoint(random),
                             randomPoint(random),
                             random.uniform(-3, 3),
                             random.uniform(-6.2, 6.2),
                             {}};
                path.start = onArc(arc, 0);
                arc.to = onArc(arc, 1);
                path.pieces.emplace_back(arc);
            }
            const std::vector<Vec2> points = *flattened(path, tolerance, manyVertices);
            const double worst = straying(path, points);
            QVERIFY2(
                worst <= tolerance * (1 + 1e-9),
                qPrintable(QStringLiteral("seed %1, curve %2: %3 > %4").arg(seed).arg(i).arg(worst).arg(tolerance)));
            // Nor is it cut finer than there is need: half as many would stray.
            QVERIFY(points.size() == 2 || points.size() < 4 + 40 / std::sqrt(tolerance));
        }
    }

    void aCoarserToleranceMakesFewerVertices() {
        const DrawnPath circle = ellipsePath({0, 0}, {10, 0}, {0, 10});
        std::size_t last = manyVertices;
        for (const double tolerance : {0.001, 0.01, 0.1, 1.0}) {
            const std::size_t count = flattened(circle, tolerance, manyVertices)->size();
            QVERIFY(count < last);
            last = count;
        }
        QVERIFY(flattened(circle, 1000, manyVertices)->size() >= 4); // a triangle, which comes back to its start
    }

    void whatWouldMakeTooManyVerticesIsNotMade() {
        DrawnPath path = ellipsePath({0, 0}, {10, 0}, {0, 10});
        const int count = static_cast<int>(flattened(path, 0.01, manyVertices)->size());
        QVERIFY(flattened(path, 0.01, count));
        QVERIFY(!flattened(path, 0.01, count - 1));
        QVERIFY(!flattened(ellipsePath({0, 0}, {1e300, 0}, {0, 1e300}), 1e-4, manyVertices));
        path.pieces.emplace_back(CubicPiece{{1e308, 1e308}, {-1e308, 1e308}, {0, 0}});
        QVERIFY(!flattened(path, 1e-4, manyVertices));
        QVERIFY(!flattened(polygonPath(std::vector<Vec2>(11, Vec2(0, 0)), false), 1, 10));
    }

    void arcsEndWhereTheyAreTold() {
        const std::uint64_t seed = 7;
        Random random(seed);
        for (int i = 0; i < 300; ++i) {
            const Vec2 from = randomPoint(random);
            const Vec2 to = randomPoint(random);
            const QString data = QStringLiteral("M%1 %2A%3 %4 %5 %6 %7 %8 %9")
                                     .arg(from.x(), 0, 'g', 17)
                                     .arg(from.y(), 0, 'g', 17)
                                     .arg(random.uniform(1, 20))
                                     .arg(random.uniform(1, 20))
                                     .arg(random.uniform(-400, 400))
                                     .arg(i % 2)
                                     .arg(i / 2 % 2)
                                     .arg(to.x(), 0, 'g', 17)
                                     .arg(to.y(), 0, 'g', 17);
            const PathReading reading = readPathData(data.toStdString());
            QVERIFY(reading.whole);
            const auto& arc = std::get<ArcPiece>(reading.paths.front().pieces.front());
            QVERIFY2((onArc(arc, 0) - from).norm() < 1e-6 && (onArc(arc, 1) - to).norm() < 1e-6, qPrintable(data));
            QVERIFY2((std::abs(arc.sweep) > 3.14159) == (i % 2 == 1) ||
                         std::abs(std::abs(arc.sweep) - 3.14159265) < 1e-3,
                     qPrintable(data));
            QVERIFY2((arc.sweep > 0) == (i / 2 % 2 == 1), qPrintable(data));
        }
    }

    void mistakesInPathDataEndThePath_data() {
        QTest::addColumn<QString>("data");
        QTest::addColumn<int>("pieces");
        QTest::newRow("no move") << "L 10 10" << 0;
        QTest::newRow("letter that is no command") << "M0 0 L1 1 X2 2" << 1;
        QTest::newRow("half a point") << "M0 0 L1 1 2" << 1;
        QTest::newRow("infinite") << "M0 0 L1 1 Linf 0" << 1;
        QTest::newRow("too large") << "M0 0 L1 1 L1e999 0" << 1;
        QTest::newRow("flag of two") << "M0 0 L1 1 A1 1 0 2 0 3 3" << 1;
        QTest::newRow("number after z") << "M0 0 L1 1 z 3 3" << 1;
        QTest::newRow("a comma alone") << "M0 0 L1 1 L,-" << 1;
    }
    void mistakesInPathDataEndThePath() {
        QFETCH(QString, data);
        QFETCH(int, pieces);
        const PathReading reading = readPathData(data.toStdString());
        QVERIFY(!reading.whole);
        std::size_t count = 0;
        for (const DrawnPath& path : reading.paths) {
            count += path.pieces.size();
        }
        QCOMPARE(static_cast<int>(count), pieces);
    }
};

SPACETOW_TEST(FlattenTest)
#include "flatten_test.moc"
