#include "core/geometry/cast.h"

#include "core/geometry/closest.h"
#include "core/geometry/convex_parts.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {} // namespace

class RayTest : public QObject {
    Q_OBJECT

  private slots:
    void raysMeetWhatTheyShould_data();
    void raysMeetWhatTheyShould();
    void raysAgreeWithSampling();
    void containsAgreesWithTheClosestPoint();
    void theClosestPointIsNearestOfAll();
};

void RayTest::raysMeetWhatTheyShould_data() {
    QTest::addColumn<Part>("part");
    QTest::addColumn<Vec2>("from");
    QTest::addColumn<Vec2>("to");
    QTest::addColumn<double>("fraction"); // −1: nothing
    QTest::addColumn<Vec2>("normal");
    const Part circle = Circle{Vec2(0, 0), 1};
    const Part wall = edge(Vec2(-1, 0), Vec2(1, 0));
    QTest::newRow("circle") << circle << Vec2(3, 0) << Vec2(-1, 0) << 0.5 << Vec2(1, 0);
    QTest::newRow("circle missed") << circle << Vec2(3, 1.1) << Vec2(-3, 1.1) << -1.0 << Vec2(0, 0);
    QTest::newRow("circle too far") << circle << Vec2(3, 0) << Vec2(1.1, 0) << -1.0 << Vec2(0, 0);
    QTest::newRow("from inside a circle") << circle << Vec2(0.5, 0) << Vec2(3, 0) << -1.0 << Vec2(0, 0);
    QTest::newRow("box") << box(1, 1) << Vec2(0.5, 5) << Vec2(0.5, -3) << 0.5 << Vec2(0, 1);
    QTest::newRow("from inside a box") << box(1, 1) << Vec2(0.5, 0) << Vec2(0.5, -3) << -1.0 << Vec2(0, 0);
    QTest::newRow("along a box") << box(1, 1) << Vec2(-5, 1.1) << Vec2(5, 1.1) << -1.0 << Vec2(0, 0);
    QTest::newRow("edge from the front") << wall << Vec2(0.5, 1) << Vec2(0.5, -1) << 0.5 << Vec2(0, 1);
    QTest::newRow("edge from behind") << wall << Vec2(0.5, -1) << Vec2(0.5, 1) << -1.0 << Vec2(0, 0);
    QTest::newRow("past an edge") << wall << Vec2(1.5, 1) << Vec2(1.5, -1) << -1.0 << Vec2(0, 0);
    QTest::newRow("line from behind") << line(Vec2(-1, 0), Vec2(1, 0)) << Vec2(0.5, -1) << Vec2(0.5, 1) << 0.5
                                      << Vec2(0, -1);
}

void RayTest::raysMeetWhatTheyShould() {
    QFETCH(Part, part);
    QFETCH(Vec2, from);
    QFETCH(Vec2, to);
    QFETCH(double, fraction);
    QFETCH(Vec2, normal);
    for (unsigned seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const Transform world = randomPose(random, 10);
        const auto hit = rayCast(part, world, world.toWorld(from), world.toWorld(to));
        QCOMPARE(hit.has_value(), fraction >= 0);
        if (hit) {
            QVERIFY(isNear(hit->fraction, fraction));
            QVERIFY(isNear(hit->normal, world.rotation * normal));
        }
    }
}

void RayTest::raysAgreeWithSampling() {
    int hits = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        Random random(seed);
        const Part part =
            random.below(2) == 0 ? Part(Circle{Vec2(0, 0), random.uniform(0.1, 1)}) : randomConvex(random);
        const Transform pose = randomPose(random, 1);
        const Vec2 from = randomPoint(random, 3);
        const Vec2 to = randomPoint(random, 3);
        const auto hit = rayCast(part, pose, from, to);
        if (contains(part, pose, from)) {
            QVERIFY2(!hit, seedText(seed));
            continue;
        }
        std::optional<double> sampled;
        for (int i = 0; i <= 3000 && !sampled; ++i) {
            if (contains(part, pose, from + i / 3000.0 * (to - from))) {
                sampled = i / 3000.0;
            }
        }
        if (sampled) {
            ++hits;
            QVERIFY2(hit && isNear(hit->fraction, *sampled, 1 / 3000.0), seedText(seed));
        }
        if (hit) {
            const Vec2 on = from + hit->fraction * (to - from);
            QVERIFY2((closestPoint(part, pose, on) - on).norm() < 1e-9, seedText(seed));
            QVERIFY2(!contains(part, pose, on + 1e-6 * hit->normal), seedText(seed));
            QVERIFY2(hit->normal.dot(to - from) < 0, seedText(seed));
        }
    }
    QVERIFY(hits > 200);
}

void RayTest::containsAgreesWithTheClosestPoint() {
    for (unsigned seed = 0; seed < 3000; ++seed) {
        Random random(seed);
        const Part part = randomPart(random);
        const Transform pose = randomPose(random, 1);
        const Vec2 p = randomPoint(random, 2);
        const double distance = (closestPoint(part, pose, p) - p).norm();
        if (std::holds_alternative<WallPart>(part)) {
            QVERIFY(!contains(part, pose, p));
        } else if (distance > 1e-9) {
            QVERIFY2(!contains(part, pose, p), seedText(seed));
        } else {
            QVERIFY2(contains(part, pose, p), seedText(seed));
        }
    }
}

void RayTest::theClosestPointIsNearestOfAll() {
    for (unsigned seed = 0; seed < 500; ++seed) {
        Random random(seed);
        const Part part = randomConvex(random);
        const auto& convex = std::get<ConvexPart>(part);
        const Transform pose = randomPose(random, 1);
        const Vec2 p = randomPoint(random, 3);
        if (contains(part, pose, p)) {
            continue;
        }
        const Vec2 nearest = closestPoint(part, pose, p);
        double best = 1e9;
        for (std::size_t i = 0; i < static_cast<std::size_t>(convex.count); ++i) {
            const Vec2 from = pose.toWorld(convex.corners[i]);
            const Vec2 to = pose.toWorld(convex.corners[(i + 1) % static_cast<std::size_t>(convex.count)]);
            for (int k = 0; k <= 1000; ++k) {
                best = std::min(best, (from + k / 1000.0 * (to - from) - p).norm());
            }
        }
        QVERIFY2(isNear((nearest - p).norm(), best, 1e-5), seedText(seed));
    }
}

SPACETOW_TEST(RayTest)
#include "ray_test.moc"
