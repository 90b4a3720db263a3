#include "core/geometry/cast.h"

#include "core/geometry/closest.h"
#include "core/geometry/convex_parts.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double gap = 0.005;

Sweep still(const Transform& pose = {}) {
    return {.start = pose, .translation = Vec2(0, 0), .turn = 0};
}

Sweep straight(const Vec2& from, const Vec2& by) {
    return {.start = {from, {}}, .translation = by, .turn = 0};
}

double distanceAt(const Part& a, const Sweep& motionA, const Part& b, const Sweep& motionB, double fraction) {
    return closestPoints(a, motionA.at(fraction), b, motionB.at(fraction)).distance;
}

Part twoSided(Random& random) { // any part, walls solid from both sides
    Part part = randomPart(random);
    if (auto* wall = std::get_if<WallPart>(&part)) {
        wall->oneWay = false;
    }
    return part;
}

bool areWalls(const Part& a, const Part& b) {
    return std::holds_alternative<WallPart>(a) && std::holds_alternative<WallPart>(b);
}

} // namespace

class CastTest : public QObject {
    Q_OBJECT

  private slots:
    void aMotionTurnsRoundItsPivot();
    void theFirstTimeIsThatOfASampledMotion();
    void straightMotionsAgreeWithTheFormula();
    void bulletsNeverPassThroughThinThings_data();
    void bulletsNeverPassThroughThinThings();
    void aSpinningPlankMeetsABall();
    void aSpinningPlankStopsBullets();
    void edgesAreMetFromTheFrontOnly_data();
    void edgesAreMetFromTheFrontOnly();
    void touchingThingsCountOnlyWhenTheyApproach_data();
    void touchingThingsCountOnlyWhenTheyApproach();
    void slidingOverJointsIsNoImpact();
    void aRisingWallAfterAJointIsAnImpact();
};

void CastTest::aMotionTurnsRoundItsPivot() {
    for (unsigned seed = 0; seed < 200; ++seed) {
        Random random(seed);
        const Sweep motion{.start = randomPose(random, 3),
                           .translation = randomPoint(random, 2),
                           .turn = random.uniform(-20, 20),
                           .pivot = randomPoint(random, 1)};
        for (const double f : {0.0, 0.3, 1.0}) {
            const Vec2 expected = motion.start.toWorld(motion.pivot) + f * motion.translation;
            QVERIFY2(isNear(motion.at(f).toWorld(motion.pivot), expected, 1e-12), seedText(seed));
            const Rot rotation = Rot::fromAngle(f * motion.turn) * motion.start.rotation;
            QVERIFY2(isNear(motion.at(f).rotation.right(), rotation.right(), 1e-12), seedText(seed));
        }
    }
}

void CastTest::theFirstTimeIsThatOfASampledMotion() {
    int hits = 0;
    for (unsigned seed = 0; seed < 4000; ++seed) {
        Random random(seed);
        const Part a = twoSided(random);
        const Part b = twoSided(random);
        if (areWalls(a, b)) {
            continue;
        }
        const Sweep motionA{.start = randomPose(random, 3),
                            .translation = randomPoint(random, 4),
                            .turn = random.below(3) == 0 ? 0 : random.uniform(-7, 7),
                            .pivot = randomPoint(random, 0.3)};
        const Sweep motionB{.start = randomPose(random, 3),
                            .translation = randomPoint(random, 4),
                            .turn = random.below(3) == 0 ? 0 : random.uniform(-7, 7)};
        if (distanceAt(a, motionA, b, motionB, 0) <= 2 * gap) {
            continue;
        }
        std::optional<double> sampled;
        double least = 1e9;
        for (int i = 0; i <= 800 && !sampled; ++i) {
            const double d = distanceAt(a, motionA, b, motionB, i / 800.0);
            least = std::min(least, d);
            if (d <= 0.7 * gap) {
                sampled = i / 800.0;
            }
        }
        const auto hit = timeOfImpact(a, motionA, b, motionB, gap);
        if (sampled) {
            ++hits;
            QVERIFY2(hit.has_value(), seedText(seed));
            QVERIFY2(*hit <= *sampled + 1e-9, seedText(seed));
        }
        if (hit) {
            const double d = distanceAt(a, motionA, b, motionB, *hit);
            QVERIFY2(d <= 1.01 * gap, seedText(seed));
            QVERIFY2(d > 0.7 * gap, seedText(seed));
            QVERIFY2(sampled || least < gap + 0.01, seedText(seed));
        }
    }
    QVERIFY(hits > 200);
}

void CastTest::straightMotionsAgreeWithTheFormula() {
    for (unsigned seed = 0; seed < 500; ++seed) {
        Random random(seed);
        const double radius = random.uniform(0.05, 0.5);
        const double height = random.uniform(1, 3);
        const double fall = random.uniform(4, 50);
        const Sweep motion = straight(Vec2(random.uniform(-1, 1), height), Vec2(random.uniform(-1, 1), -fall));
        const double expected = (height - radius - gap) / fall;
        const std::array<Part, 2> grounds{edge(Vec2(-10, 0), Vec2(10, 0), 0), box(10, 1, Vec2(0, -1))};
        for (const Part& ground : grounds) {
            for (const Part& body : {Part(Circle{Vec2(0, 0), radius}), box(radius, radius)}) {
                const auto hit = timeOfImpact(body, motion, ground, still(), gap);
                QVERIFY2(hit && isNear(*hit, expected, 1e-4 * gap + 1e-9), seedText(seed));
                const auto swapped = timeOfImpact(ground, still(), body, motion, gap);
                QVERIFY2(swapped && isNear(*hit, *swapped), seedText(seed));
            }
        }
    }
}

void CastTest::bulletsNeverPassThroughThinThings_data() {
    QTest::addColumn<Part>("target");
    QTest::newRow("edge") << edge(Vec2(-1, 0), Vec2(1, 0), 0);
    QTest::newRow("line") << line(Vec2(-1, 0), Vec2(1, 0));
    QTest::newRow("thin box") << box(1, 0.0005);
    QTest::newRow("small circle") << Part(Circle{Vec2(0, 0), 0.02});
}

void CastTest::bulletsNeverPassThroughThinThings() {
    QFETCH(Part, target);
    const Part bullet = Circle{Vec2(0, 0), 0.05};
    const bool round = std::holds_alternative<Circle>(target);
    for (unsigned seed = 0; seed < 5000; ++seed) {
        Random random(seed);
        const Transform world = randomPose(random, 100);
        // From in front, through a point of the target, 5 m in one cast.
        const Vec2 through(round ? 0 : random.uniform(-0.99, 0.99), 0);
        const Vec2 way = Rot::fromAngle(random.uniform(-3.1, -0.04)).right();
        const double before = random.uniform(0.5, 4.5);
        const Vec2 from = through - before * way;
        if (from.y() < 0.06 && !round) {
            continue;
        }
        Sweep motion{.start = carried(world, {from, {}}),
                     .translation = world.rotation * Vec2(5 * way),
                     .turn = random.uniform(-50, 50)};
        const auto hit = timeOfImpact(bullet, motion, target, still(world), gap);
        QVERIFY2(hit.has_value(), seedText(seed));
        const Vec2 at = world.toLocal(motion.at(*hit).position);
        QVERIFY2(at.y() > 0 || std::fabs(at.x()) > 1 || round, seedText(seed));
        const double distance = distanceAt(bullet, motion, target, still(world), *hit);
        QVERIFY2(distance <= 1.01 * gap && distance > 0, seedText(seed));
    }
}

void CastTest::aSpinningPlankMeetsABall() {
    const Part plank = box(2, 0.02);
    for (const double turn : {0.5, 2.0, 10.0, 100.0, -100.0}) {
        for (const double angle : {0.3, 1.0, -2.0}) {
            // The ball is where one half of the plank passes after turning by the angle, or less the other way round.
            const Vec2 at = Rot::fromAngle(angle).right() * 1.5;
            const Part ball = Circle{at, 0.05};
            const Sweep motion{.start = {}, .translation = Vec2(0, 0), .turn = turn};
            const auto hit = timeOfImpact(plank, motion, ball, still(), gap);
            // Both ends sweep: the angle until one of them arrives, less what ball, half thickness and gap take away.
            const double pi = std::numbers::pi;
            const double ahead = std::fmod(std::fmod(turn > 0 ? angle : -angle, pi) + pi, pi);
            const double expected = ahead - std::asin((0.05 + 0.02 + gap) / 1.5);
            if (expected > std::fabs(turn)) {
                QVERIFY(!hit);
            } else {
                QVERIFY(hit);
                QVERIFY2(isNear(*hit * std::fabs(turn), expected, 1e-3), QByteArray::number(*hit * std::fabs(turn)));
            }
        }
    }
}

void CastTest::aSpinningPlankStopsBullets() {
    const Part plank = box(2, 0.01);
    const Part bullet = Circle{Vec2(0, 0), 0.05};
    for (unsigned seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        const Sweep spin{.start = {Vec2(0, 0), Rot::fromAngle(random.uniform(-0.3, 0.3))},
                         .translation = Vec2(0, 0),
                         .turn = random.uniform(-0.1, 0.1)};
        const Sweep shot = straight(Vec2(random.uniform(-1, 1), 2.5), Vec2(0, -5));
        const auto hit = timeOfImpact(bullet, shot, plank, spin, gap);
        QVERIFY2(hit.has_value(), seedText(seed));
        QVERIFY2(distanceAt(bullet, shot, plank, spin, *hit) > 0, seedText(seed));
    }
}

void CastTest::edgesAreMetFromTheFrontOnly_data() {
    QTest::addColumn<Part>("wall");
    QTest::addColumn<Vec2>("from");
    QTest::addColumn<Vec2>("by");
    QTest::addColumn<bool>("meets");
    WallPart joined = std::get<WallPart>(edge(Vec2(-1, 0), Vec2(1, 0), 0));
    joined.joinedAtA = joined.joinedAtB = true;
    joined.beforeA = Vec2(-2, 0);
    joined.afterB = Vec2(2, 0);
    const Part open = edge(Vec2(-1, 0), Vec2(1, 0), 0);
    const Vec2 down(0, -2);
    const Vec2 up(0, 2);
    QTest::newRow("from the front") << open << Vec2(0.5, 1) << down << true;
    QTest::newRow("from behind") << open << Vec2(0.5, -1) << up << false;
    QTest::newRow("a free start from behind") << open << Vec2(-1.02, -1) << up << true;
    QTest::newRow("a free end from behind") << open << Vec2(0.98, -1) << up << true;
    QTest::newRow("a free end from the side") << open << Vec2(2, 0) << Vec2(-2, 0) << true;
    QTest::newRow("a joined end from behind") << Part(joined) << Vec2(0.98, -1) << up << false;
    QTest::newRow("a joined wall from the front") << Part(joined) << Vec2(0.98, 1) << down << true;
    QTest::newRow("a line from behind") << line(Vec2(-1, 0), Vec2(1, 0)) << Vec2(0.5, -1) << up << true;
    QTest::newRow("past the wall") << open << Vec2(1.2, 1) << down << false;
}

void CastTest::edgesAreMetFromTheFrontOnly() {
    QFETCH(Part, wall);
    QFETCH(Vec2, from);
    QFETCH(Vec2, by);
    QFETCH(bool, meets);
    for (const Part& body : {Part(Circle{Vec2(0, 0), 0.1}), box(0.1, 0.1)}) {
        for (const double turn : {0.0, 0.001}) {
            Sweep motion = straight(from, by);
            motion.turn = turn;
            QCOMPARE(timeOfImpact(body, motion, wall, still(), gap).has_value(), meets);
            QCOMPARE(timeOfImpact(wall, still(), body, motion, gap).has_value(), meets);
        }
    }
}

void CastTest::touchingThingsCountOnlyWhenTheyApproach_data() {
    QTest::addColumn<double>("apart"); // of the surfaces
    QTest::addColumn<Vec2>("by");
    QTest::addColumn<bool>("meets");
    for (const double apart : {0.004, 0.001, -0.003}) {
        QTest::addRow("%g apart, at rest", apart) << apart << Vec2(0, 0) << false;
        QTest::addRow("%g apart, leaving", apart) << apart << Vec2(0.3, 1) << false;
        QTest::addRow("%g apart, sliding", apart) << apart << Vec2(3, 0) << false;
        QTest::addRow("%g apart, approaching", apart) << apart << Vec2(1, -1) << true;
    }
}

void CastTest::touchingThingsCountOnlyWhenTheyApproach() {
    QFETCH(double, apart);
    QFETCH(Vec2, by);
    QFETCH(bool, meets);
    for (const Part& ground :
         {edge(Vec2(-9, 0), Vec2(9, 0), 0), line(Vec2(-9, 0), Vec2(9, 0)), box(9, 1, Vec2(0, -1))}) {
        for (const Part& body : {Part(Circle{Vec2(0, 0), 0.2}), box(0.2, 0.2)}) {
            const auto hit = timeOfImpact(body, straight(Vec2(0, 0.2 + apart), by), ground, still(), gap);
            QCOMPARE(hit.has_value(), meets);
            QVERIFY(!meets || *hit == 0);
        }
    }
}

void CastTest::slidingOverJointsIsNoImpact() {
    std::vector<Part> walls;
    std::vector<WallPart*> pointers;
    for (int i = 0; i < 50; ++i) {
        walls.push_back(edge(Vec2(0.2 * i, 0), Vec2(0.2 * (i + 1), 0)));
    }
    for (Part& wall : walls) {
        pointers.push_back(&std::get<WallPart>(wall));
    }
    joinWalls(pointers);
    for (const Part& body : {Part(Circle{Vec2(0, 0), 0.2}), box(0.2, 0.2)}) {
        for (const double apart : {-0.003, 0.001, 0.004}) {
            const Sweep motion = straight(Vec2(2.33, 0.2 + apart), Vec2(5, 0));
            for (std::size_t i = 10; i < 40; ++i) {
                QVERIFY(!timeOfImpact(body, motion, walls[i], still(), gap));
            }
        }
    }
}

void CastTest::aRisingWallAfterAJointIsAnImpact() {
    Part floor = edge(Vec2(-5, 0), Vec2(0, 0));
    Part slope = edge(Vec2(0, 0), Vec2(5, 2));
    joinWalls(std::array{&std::get<WallPart>(floor), &std::get<WallPart>(slope)});
    const Sweep motion = straight(Vec2(-3, 0.2), Vec2(5, 0));
    const auto hit = timeOfImpact(Circle{Vec2(0, 0), 0.2}, motion, slope, still(), gap);
    QVERIFY(hit);
    const Vec2 normal = Vec2(-2, 5).normalized();
    QVERIFY(isNear(normal.dot(motion.at(*hit).position), 0.2 + gap, 1e-4));
}

SPACETOW_TEST(CastTest)
#include "cast_test.moc"
