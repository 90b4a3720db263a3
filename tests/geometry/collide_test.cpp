#include "core/geometry/collide.h"

#include "core/geometry/closest.h"
#include "core/geometry/overlaps.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

bool samePoints(const Manifold& a, const Manifold& b, double tolerance, const Transform& by = {}) {
    if (a.count != b.count) {
        return false;
    }
    for (int i = 0; i < a.count; ++i) {
        bool found = false;
        for (int k = 0; k < b.count; ++k) {
            const ManifoldPoint& p = a.points[static_cast<std::size_t>(i)];
            const ManifoldPoint& q = b.points[static_cast<std::size_t>(k)];
            found = found ||
                    (isNear(by.toWorld(p.point), q.point, tolerance) && isNear(p.separation, q.separation, tolerance));
        }
        if (!found) {
            return false;
        }
    }
    return true;
}

double leastSeparation(const Manifold& manifold) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < manifold.count; ++i) {
        least = std::min(least, manifold.points[static_cast<std::size_t>(i)].separation);
    }
    return least;
}

struct Pair {
    Part a, b;
    Transform poseA, poseB;
};

Pair randomPair(Random& random, double reach) {
    Pair pair{randomPart(random), randomPart(random), {}, {}};
    pair.poseA = randomPose(random, reach);
    pair.poseB = randomPose(random, reach);
    return pair;
}

bool isWall(const Part& part) {
    return std::holds_alternative<WallPart>(part);
}

} // namespace

class CollideTest : public QObject {
    Q_OBJECT

  private slots:
    void swappingThePartsTurnsTheNormalRound();
    void movingEverythingMovesTheContact();
    void apartThePartsAreAsFarAsTheirClosestPoints();
    void overlappingPartsComeApartAlongTheNormal();
    void twoWallsNeverTouch();
    void circlesTouchAtEveryAngle_data();
    void circlesTouchAtEveryAngle();
    void concentricPartsHaveAUsableNormal_data();
    void concentricPartsHaveAUsableNormal();
    void aBoxOnABoxTouchesInTwoPoints();
    void featuresStayWhileABoxSlidesAndSinks();
    void aCircleMeetsFacesAndCornersOfABox_data();
    void aCircleMeetsFacesAndCornersOfABox();
    void overlapsIsWhatTouchesOrCrosses();
    void coordinatesThatAreNoNumbersDoNoHarm();
};

void CollideTest::swappingThePartsTurnsTheNormalRound() {
    int touching = 0;
    for (unsigned seed = 0; seed < 6000; ++seed) {
        Random random(seed);
        const Pair p = randomPair(random, 1);
        const double margin = random.uniform(0, 0.1);
        const Manifold there = collide(p.a, p.poseA, p.b, p.poseB, margin);
        const Manifold back = collide(p.b, p.poseB, p.a, p.poseA, margin);
        QVERIFY2(samePoints(there, back, 1e-9), seedText(seed));
        if (there.count > 0) {
            ++touching;
            QVERIFY2(isNear(there.normal, -back.normal), seedText(seed));
            QVERIFY2(isNear(there.normal.norm(), 1), seedText(seed));
        }
        QVERIFY2(leastSeparation(there) <= margin || there.count == 0, seedText(seed));
    }
    QVERIFY(touching > 1000);
}

void CollideTest::movingEverythingMovesTheContact() {
    for (unsigned seed = 0; seed < 6000; ++seed) {
        Random random(seed);
        const Pair p = randomPair(random, 1);
        const Transform by = randomPose(random, 20);
        const Manifold here = collide(p.a, p.poseA, p.b, p.poseB, 0.05);
        const Manifold there = collide(p.a, carried(by, p.poseA), p.b, carried(by, p.poseB), 0.05);
        QVERIFY2(samePoints(here, there, 1e-8, by), seedText(seed));
        if (here.count > 0) {
            QVERIFY2(isNear(by.rotation * here.normal, there.normal, 1e-8), seedText(seed));
        }
    }
}

void CollideTest::apartThePartsAreAsFarAsTheirClosestPoints() {
    int counted = 0;
    for (unsigned seed = 0; seed < 20000; ++seed) {
        Random random(seed);
        const Pair p = randomPair(random, 1.5);
        const ClosestPoints closest = closestPoints(p.a, p.poseA, p.b, p.poseB);
        if (closest.distance <= 1e-4 || closest.distance > 0.3 || (isWall(p.a) && isWall(p.b))) {
            continue;
        }
        const Manifold manifold = collide(p.a, p.poseA, p.b, p.poseB, 0.3);
        const bool oneWay =
            (isWall(p.a) && std::get<WallPart>(p.a).oneWay) || (isWall(p.b) && std::get<WallPart>(p.b).oneWay);
        if (oneWay) {
            continue; // from behind there may be nothing
        }
        ++counted;
        QVERIFY2(manifold.count > 0, seedText(seed));
        QVERIFY2(isNear(leastSeparation(manifold), closest.distance, 1e-7), seedText(seed));
        QVERIFY2(isNear(manifold.normal, closest.normal, 1e-5), seedText(seed));
    }
    QVERIFY(counted > 1000);
}

void CollideTest::overlappingPartsComeApartAlongTheNormal() {
    int counted = 0;
    for (unsigned seed = 0; seed < 20000; ++seed) {
        Random random(seed);
        Pair p = randomPair(random, 0.8);
        if (isWall(p.a) || isWall(p.b) || closestPoints(p.a, p.poseA, p.b, p.poseB).distance > 0) {
            continue;
        }
        ++counted;
        const Manifold manifold = collide(p.a, p.poseA, p.b, p.poseB, 0);
        QVERIFY2(manifold.count > 0, seedText(seed));
        const double depth = -leastSeparation(manifold);
        QVERIFY2(depth >= 0, seedText(seed));
        p.poseB.position += (depth + 1e-7) * manifold.normal;
        const double after = closestPoints(p.a, p.poseA, p.b, p.poseB).distance;
        QVERIFY2(after > 0 && after < 1e-5, seedText(seed) + " " + QByteArray::number(after));
    }
    QVERIFY(counted > 1000);
}

void CollideTest::twoWallsNeverTouch() {
    for (unsigned seed = 0; seed < 500; ++seed) {
        Random random(seed);
        const Part a = randomWall(random);
        const Part b = randomWall(random);
        QCOMPARE(collide(a, {}, b, {}, 1).count, 0);
    }
}

void CollideTest::circlesTouchAtEveryAngle_data() {
    QTest::addColumn<double>("offset");
    for (const double offset : {0.0, 0.1, 0.5, 0.9, 0.999}) {
        QTest::addRow("distance %g of the radii", offset) << offset;
    }
}

void CollideTest::circlesTouchAtEveryAngle() {
    QFETCH(double, offset);
    const Part a = Circle{Vec2(0, 0), 0.2};
    const Part b = Circle{Vec2(0, 0), 0.3};
    for (int degrees = 0; degrees < 360; ++degrees) {
        const Vec2 way = Rot::fromAngle(degrees * std::numbers::pi / 180).right();
        const Transform pose{offset * 0.5 * way, {}};
        const Manifold manifold = collide(a, {}, b, pose, 0);
        QCOMPARE(manifold.count, 1);
        QVERIFY(isNear(manifold.points[0].separation, (offset - 1) * 0.5));
        if (offset > 0) {
            QVERIFY(isNear(manifold.normal, way));
            const Vec2 middle = 0.5 * (0.2 * way + pose.position - 0.3 * way);
            QVERIFY(isNear(manifold.points[0].point, middle));
        }
        QCOMPARE(collide(a, {}, b, {Vec2(0.501 * way), {}}, 0).count, 0);
        QCOMPARE(collide(a, {}, b, {Vec2(0.501 * way), {}}, 0.01).count, 1);
    }
}

void CollideTest::concentricPartsHaveAUsableNormal_data() {
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
            if (a < 2 || b < 2) { // not two walls
                QTest::addRow("kinds %d and %d", a, b) << a << b;
            }
        }
    }
}

void CollideTest::concentricPartsHaveAUsableNormal() {
    QFETCH(int, a);
    QFETCH(int, b);
    const std::array<Part, 4> parts{Part(Circle{Vec2(0, 0), 0.5}), box(0.5, 0.25), edge(Vec2(-1, 0), Vec2(1, 0), 0),
                                    line(Vec2(-1, 0), Vec2(1, 0))};
    const Manifold manifold =
        collide(parts[static_cast<std::size_t>(a)], {}, parts[static_cast<std::size_t>(b)], {}, 0);
    QVERIFY(manifold.count > 0);
    QVERIFY(isNear(manifold.normal.norm(), 1));
    QVERIFY(leastSeparation(manifold) <= -0.25);
}

void CollideTest::aBoxOnABoxTouchesInTwoPoints() {
    const Part lower = box(1, 0.5);
    const Part upper = box(0.5, 0.5);
    const Manifold manifold = collide(lower, {}, upper, {Vec2(0.25, 0.99), {}}, 0.02);
    QCOMPARE(manifold.count, 2);
    QVERIFY(isNear(manifold.normal, Vec2(0, 1)));
    for (const ManifoldPoint& p : manifold.points) {
        QVERIFY(isNear(p.separation, -0.01));
        QVERIFY(isNear(p.point.y(), 0.495));
        QVERIFY(isNear(std::fabs(p.point.x() - 0.25), 0.5));
    }
}

void CollideTest::featuresStayWhileABoxSlidesAndSinks() {
    const Part ground = box(5, 0.5);
    const Part body = box(0.5, 0.5);
    const auto features = [&](double x, double y, double angle) {
        const Manifold manifold = collide(ground, {}, body, {Vec2(x, y), Rot::fromAngle(angle)}, 0.05);
        std::vector<std::uint32_t> result;
        for (int i = 0; i < manifold.count; ++i) {
            result.push_back(manifold.points[static_cast<std::size_t>(i)].feature);
        }
        std::sort(result.begin(), result.end());
        return result;
    };
    const auto first = features(0, 1, 0);
    QCOMPARE(first.size(), std::size_t{2});
    for (const double x : {-3.0, -0.7, 0.01, 4.2}) {
        for (const double y : {0.97, 0.999, 1.001, 1.02}) {
            for (const double angle : {-0.002, 0.0, 0.002}) {
                QCOMPARE(features(x, y, angle), first);
            }
        }
    }
}

void CollideTest::aCircleMeetsFacesAndCornersOfABox_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("normalX");
    QTest::addColumn<double>("normalY");
    QTest::addColumn<double>("separation");
    const double diagonal = std::sqrt(0.5);
    QTest::newRow("over a face") << 0.3 << 1.15 << 0.0 << 1.0 << -0.05;
    QTest::newRow("beside a face") << -1.15 << -0.3 << -1.0 << 0.0 << -0.05;
    QTest::newRow("over the very end of a face") << 1.0 << 1.15 << 0.0 << 1.0 << -0.05;
    QTest::newRow("at a corner") << 1.1 << 1.1 << diagonal << diagonal << 0.1 / diagonal - 0.2;
    QTest::newRow("with its centre inside") << 0.9 << 0.2 << 1.0 << 0.0 << -0.3;
}

void CollideTest::aCircleMeetsFacesAndCornersOfABox() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, normalX);
    QFETCH(double, normalY);
    QFETCH(double, separation);
    const Manifold manifold = collide(box(1, 1), {}, Circle{Vec2(x, y), 0.2}, {}, 0);
    QCOMPARE(manifold.count, 1);
    QVERIFY(isNear(manifold.normal, Vec2(normalX, normalY)));
    QVERIFY(isNear(manifold.points[0].separation, separation));
}

void CollideTest::overlapsIsWhatTouchesOrCrosses() {
    const Part wall = edge(Vec2(0, 0), Vec2(2, 0), 0);
    QVERIFY(overlaps(wall, {}, line(Vec2(1, -1), Vec2(1, 1)), {}));
    QVERIFY(overlaps(wall, {}, edge(Vec2(2, 0), Vec2(3, 1)), {}));
    QVERIFY(!overlaps(wall, {}, line(Vec2(1, 0.1), Vec2(1, 1)), {}));
    for (const double y : {-0.15, 0.15}) { // sensed from both sides
        QVERIFY(overlaps(wall, {}, Circle{Vec2(1, y), 0.2}, {}));
        QVERIFY(overlaps(wall, {}, box(0.2, 0.2), {Vec2(1, y), {}}));
    }
    QVERIFY(!overlaps(wall, {}, Circle{Vec2(1, -0.3), 0.2}, {}));
    QVERIFY(overlaps(edge(Vec2(0, 0), Vec2(2, 0), 0.5), {}, Circle{Vec2(1, -0.3), 0.2}, {}));
    for (unsigned seed = 0; seed < 3000; ++seed) {
        Random random(seed);
        const Pair p = randomPair(random, 1);
        const bool expected =
            closestPoints(p.a, p.poseA, p.b, p.poseB).distance <= 0 || collide(p.a, p.poseA, p.b, p.poseB, 0).count > 0;
        QVERIFY2(overlaps(p.a, p.poseA, p.b, p.poseB) == expected, seedText(seed));
        QVERIFY2(overlaps(p.b, p.poseB, p.a, p.poseA) == expected, seedText(seed));
    }
}

/// Random concave polygons touched from a random side: however thin the parts beside a cut, the depth told is that of
/// the touch and not that of the polygon.
void CollideTest::coordinatesThatAreNoNumbersDoNoHarm() {
    const std::array<double, 6> odd{0, 1e-300, 1e300, std::numeric_limits<double>::infinity(), std::nan(""), -1};
    for (unsigned seed = 0; seed < 3000; ++seed) {
        Random random(seed);
        const Pair p = randomPair(random, 1);
        Transform pose = p.poseA;
        pose.position.x() = odd[random.below(6)];
        pose.rotation.c = random.below(2) == 0 ? odd[random.below(6)] : pose.rotation.c;
        const Manifold manifold = collide(p.a, pose, p.b, p.poseB, odd[random.below(4)]);
        QVERIFY2(manifold.count >= 0 && manifold.count <= 2, seedText(seed));
        overlaps(p.a, pose, p.b, p.poseB);
    }
}

SPACETOW_TEST(CollideTest)
#include "collide_test.moc"
