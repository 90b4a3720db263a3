#include "editor/canvas/seen_points.h"

#include "core/base/random.h"
#include "core/geometry/intersect.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <limits>

using namespace spacetow;

namespace {

std::vector<Vec2> randomWalk(Random& random, unsigned count, double step) {
    std::vector<Vec2> points;
    Vec2 at(0, 0);
    for (unsigned i = 0; i < count; ++i) {
        points.push_back(at);
        at += Vec2(random.uniform(-1, 1.2), random.uniform(-1, 1)) * step;
    }
    return points;
}

double distanceTo(const std::vector<Vec2>& line, bool closed, const Vec2& point) {
    double nearest = (line.front() - point).norm();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
        nearest = std::min(nearest, (closestOnSegment(line[i], line[(i + 1) % line.size()], point) - point).norm());
    }
    return nearest;
}

/// How often the closed line goes round the point.
int winding(const std::vector<Vec2>& line, const Vec2& point) {
    int turns = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2& a = line[i];
        const Vec2& b = line[(i + 1) % line.size()];
        const double side = cross(b - a, point - a);
        if (a.y() <= point.y() && b.y() > point.y() && side > 0) {
            ++turns;
        } else if (a.y() > point.y() && b.y() <= point.y() && side < 0) {
            --turns;
        }
    }
    return turns;
}

QByteArray walkSeed(unsigned seed) {
    return "seed " + QByteArray::number(seed);
}

} // namespace

class SeenPointsTest : public QObject {
    Q_OBJECT

  private slots:
    void simplifyingStaysWithinItsTolerance() {
        for (unsigned seed = 0; seed < 600; ++seed) {
            Random random(seed);
            const std::vector<Vec2> points = randomWalk(random, 1 + random.below(200), random.uniform(0.05, 1));
            const double tolerance = random.uniform(0.01, 0.5);
            const std::vector<Vec2> kept = simplified(points, tolerance);
            QCOMPARE(kept.front(), points.front());
            QCOMPARE(kept.back(), points.back());
            QVERIFY(kept.size() <= points.size());
            for (const Vec2& point : points) {
                QVERIFY2(distanceTo(kept, false, point) <= tolerance * 1.0001, walkSeed(seed));
            }
        }
    }

    void aStraightLineNeedsNothingBetweenItsEnds() {
        std::vector<Vec2> points;
        for (int i = 0; i < 100; ++i) {
            points.emplace_back(0.1 * i, 0.2 * i);
        }
        QCOMPARE(simplified(points, 1e-6).size(), std::size_t{2});
    }

    void aLineThatTurnsBackIsFollowedToItsFurthestPoint() {
        const std::vector<Vec2> points{Vec2(0, 0), Vec2(5, 0), Vec2(1, 0)};
        QCOMPARE(simplified(points, 0.1), points);
    }

    void inTheAreaTheOutlineIsFollowedAndWhatIsFilledStaysSo() {
        for (unsigned seed = 0; seed < 400; ++seed) {
            Random random(seed);
            const std::vector<Vec2> points = randomWalk(random, 3 + random.below(900), 0.4);
            const bool closed = random.below(3) != 0;
            const SegmentTree tree(points, closed);
            const Transform pose{Vec2(random.uniform(-5, 5), random.uniform(-5, 5)),
                                 Rot::fromAngle(random.uniform(-3, 3))};
            std::vector<Vec2> world;
            for (const Vec2& point : points) {
                world.push_back(pose.toWorld(point));
            }
            const Vec2 corner = world[random.below(static_cast<unsigned>(world.size()))];
            const SeenArea area{{corner, corner + Vec2(random.uniform(0.5, 5), random.uniform(0.5, 5))},
                                random.uniform(0.001, 0.05)};
            const std::vector<Vec2> seen = seenPoints({points, closed, pose, &tree}, area);
            for (const Vec2& point : world) {
                QVERIFY2(!area.box.contains(point) || distanceTo(seen, closed, point) <= 2 * area.finest,
                         walkSeed(seed));
            }
            for (int i = 0; closed && i < 20; ++i) {
                const Vec2 size = area.box.size();
                const Vec2 at = area.box.min + Vec2(random.unit() * size.x(), random.unit() * size.y());
                if (distanceTo(world, true, at) > 3 * area.finest) {
                    QVERIFY2(winding(seen, at) == winding(world, at), walkSeed(seed));
                }
            }
        }
    }

    void areasThatOverlapShowTheSameWhereTheyDo() {
        for (unsigned seed = 0; seed < 100; ++seed) {
            Random random(seed);
            const std::vector<Vec2> points = randomWalk(random, 900, 0.3);
            const SegmentTree tree(points, true);
            const Vec2 corner = points[random.below(900)];
            const Aabb small{corner, corner + Vec2(2, 2)};
            const auto inSmall = [&](const Aabb& box) {
                std::vector<Vec2> found;
                for (const Vec2& point : seenPoints({points, true, {}, &tree}, {box, 0.02})) {
                    if (small.contains(point)) {
                        found.push_back(point);
                    }
                }
                return found;
            };
            QVERIFY2(inSmall(small) == inSmall(small.grown(random.uniform(0, 30))), walkSeed(seed));
        }
    }
};

SPACETOW_TEST(SeenPointsTest)
#include "seen_points_test.moc"
