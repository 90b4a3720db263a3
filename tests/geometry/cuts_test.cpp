#include "core/geometry/collide.h"

#include "core/geometry/closest.h"
#include "core/geometry/overlaps.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

double leastSeparationIn(const Manifold& manifold) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < manifold.count; ++i) {
        least = std::min(least, manifold.points[static_cast<std::size_t>(i)].separation);
    }
    return least;
}

Polygon randomStarPolygon(Random& random) {
    Polygon star;
    const int count = 5 + static_cast<int>(random.below(12));
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.uniform(0, 0.8)) / count;
        star.vertices.push_back(random.uniform(0.4, 2) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return star;
}

/// The feet of the teeth and the gaps between them lie in one plane, which the cuts divide.
Polygon randomComb(Random& random) {
    const int teeth = 2 + static_cast<int>(random.below(4));
    const double tooth = random.uniform(0.15, 0.4);
    const double pitch = tooth + random.uniform(0.1, 0.6);
    const double half = 0.5 * ((teeth - 1) * pitch + tooth);
    const double high = random.uniform(0.2, 1);
    Polygon comb{{Vec2(-half, -0.4), Vec2(half, -0.4)}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double left = -half + i * pitch;
        if (i < teeth - 1) {
            comb.vertices.emplace_back(left + tooth, 0);
        }
        comb.vertices.emplace_back(left + tooth, high);
        comb.vertices.emplace_back(left, high);
        if (i > 0) {
            comb.vertices.emplace_back(left, 0);
        }
    }
    return comb;
}

/// Moves `body` up to `target` along a random way and then deeper by a few millimetres; how deep the contacts say it
/// is.
struct Sinking {
    double sunk = 0;
    double deepest = 0;

    Sinking(Random& random, const std::vector<Part>& target, const std::vector<Part>& body) {
        const Rot rotation = Rot::fromAngle(random.uniform(-4, 4));
        const Vec2 way = Rot::fromAngle(random.uniform(-4, 4)).right();
        const Vec2 aside = random.uniform(-1, 1) * leftOf(way);
        double along = 8;
        for (double distance = 1; distance > 1e-7 && along > -8; along -= distance) { // never farther than what is free
            distance = std::numeric_limits<double>::infinity();
            for (const Part& part : target) {
                for (const Part& other : body) {
                    const Transform pose{aside + along * way, rotation};
                    distance = std::min(distance, closestPoints(part, {}, other, pose).distance);
                }
            }
        }
        const double further = random.uniform(0.0005, 0.006);
        const Transform pose{aside + (along - further) * way, rotation};
        for (const Part& part : target) {
            for (const Part& other : body) {
                const bool inside = closestPoints(part, {}, other, pose).distance <= 0;
                sunk = inside ? further : sunk; // or it has slid past
                const Manifold manifold = collide(part, {}, other, pose, 0);
                deepest = std::max(deepest, manifold.count > 0 ? -leastSeparationIn(manifold) : 0.0);
            }
        }
    }
};

} // namespace

class CutsTest : public QObject {
    Q_OBJECT

  private slots:
    void theNotchOfTheShipIsHollow();
    void nothingRestsOnACut();
    void cornersOnACutGiveNormalsOfTheOutlineOnly();
    void cutsNeverThrowAnythingOutTheLongWay();
    void theBackOfACombHoldsTheToothOfAnother();
    void aTipInANotchIsAnticipatedByBothFlanks_data();
    void aTipInANotchIsAnticipatedByBothFlanks();
    void aSideThatLandsOnOneEndIsAnticipatedAtTheOther();
};

void CutsTest::theNotchOfTheShipIsHollow() {
    Polygon ship;
    ship.vertices = {Vec2(0, 0.7 / 3), Vec2(-0.2, -0.5 / 3), Vec2(0, -0.2 / 3), Vec2(0.2, -0.5 / 3)};
    const std::vector<Part> parts = partsOf(ship);
    // A small circle up in the notch lies inside the convex hull and touches the two faces of the notch alone.
    const double radius = 0.02;
    const Vec2 face = Vec2(0.2, -0.1).normalized();
    const Vec2 down(-face.y() < 0 ? face.y() : -face.y(), -face.x());
    const double below = radius / std::fabs(face.x());
    const Part ball = Circle{Vec2(0, -0.2 / 3 - below - 1e-4), radius};
    int contacts = 0;
    for (const Part& part : parts) {
        const Manifold manifold = collide(part, {}, ball, {}, 0.001);
        contacts += manifold.count;
        if (manifold.count > 0) {
            QVERIFY(isNear(std::fabs(manifold.normal.x()), std::fabs(down.x()), 1e-6));
            QVERIFY(isNear(manifold.normal.y(), down.y(), 1e-6));
            QVERIFY(isNear(manifold.points[0].separation, 1e-4 * std::fabs(face.x()), 1e-9));
        }
    }
    QCOMPARE(contacts, 2);
    for (const Part& part : parts) {
        QCOMPARE(collide(part, {}, Circle{Vec2(0, -0.2), 0.02}, {}, 0.001).count, 0);
    }
}

void CutsTest::nothingRestsOnACut() {
    // An L: whatever the cut, a box on its foot is carried by the top of the foot, not by anything inside.
    Polygon shape;
    shape.vertices = {Vec2(0, 0), Vec2(3, 0), Vec2(3, 1), Vec2(1, 1), Vec2(1, 3), Vec2(0, 3)};
    const std::vector<Part> parts = partsOf(shape);
    for (int i = 0; i <= 100; ++i) {
        const double x = 1.5 + 0.01 * i;
        for (const Part& body : {box(0.4, 0.4), Part(Circle{Vec2(0, 0), 0.4})}) {
            bool carried = false;
            for (const Part& part : parts) {
                const Manifold manifold = collide(part, {}, body, {Vec2(x, 1.395), {}}, 0.001);
                if (manifold.count > 0) {
                    carried = true;
                    QVERIFY(isNear(manifold.normal, Vec2(0, 1)));
                    QVERIFY(isNear(leastSeparationIn(manifold), -0.005));
                }
            }
            QVERIFY(carried);
        }
    }
}

void CutsTest::cornersOnACutGiveNormalsOfTheOutlineOnly() {
    // A wheel of 24 corners has to be cut. A ball rolling round it sees the normals of a wheel without cuts.
    Polygon wheel;
    wheel.vertices = regularPolygon(24, 1);
    const std::vector<Part> parts = partsOf(wheel);
    QVERIFY(parts.size() > 1);
    for (int i = 0; i < 1440; ++i) {
        const Vec2 out = Rot::fromAngle(i * std::numbers::pi / 720).right();
        const Vec2 center = 1.19 * out;
        int contacts = 0;
        for (const Part& part : parts) {
            const Manifold manifold = collide(part, {}, Circle{center, 0.2}, {}, 0.01);
            if (manifold.count > 0) {
                ++contacts;
                QVERIFY2(manifold.normal.dot(out) > std::cos(std::numbers::pi / 24), QByteArray::number(i));
            }
        }
        QVERIFY(contacts >= 1);
    }
}

void CutsTest::cutsNeverThrowAnythingOutTheLongWay() {
    int met = 0;
    for (unsigned seed = 0; seed < 6000; ++seed) {
        Random random(seed);
        const std::vector<Part> parts = partsOf(seed % 2 == 0 ? randomStarPolygon(random) : randomComb(random));
        const std::array<std::vector<Part>, 6> bodies{
            std::vector<Part>{Circle{Vec2(0, 0), random.uniform(0.05, 0.5)}},
            {randomConvex(random)},
            {box(0.3, 0.2)},
            {line(Vec2(-0.7, 0), Vec2(0.6, 0.1))},
            partsOf(randomComb(random)),
            partsOf(randomStarPolygon(random)),
        };
        const Sinking sinking(random, parts, bodies[random.below(6)]);
        if (sinking.sunk > 0) {
            ++met;
            QVERIFY2(sinking.deepest > 0 && sinking.deepest < 1.5 * sinking.sunk + 0.003,
                     seedText(seed) + " " + QByteArray::number(sinking.deepest));
        }
    }
    QVERIFY(met > 4000);
}

void CutsTest::theBackOfACombHoldsTheToothOfAnother() {
    // The tip of an outer tooth, 7 cm inside the back, between two teeth there.
    Polygon comb{{Vec2(-1, -0.3), Vec2(1, -0.3), Vec2(1, 0.8), Vec2(0.8, 0.8), Vec2(0.8, 0), Vec2(0.4, 0),
                  Vec2(0.4, 0.8), Vec2(0.2, 0.8), Vec2(0.2, 0), Vec2(-0.2, 0), Vec2(-0.2, 0.8), Vec2(-0.4, 0.8),
                  Vec2(-0.4, 0), Vec2(-0.8, 0), Vec2(-0.8, 0.8), Vec2(-1, 0.8)}};
    const Transform moved{{-0.9944, 0.7292}, Rot::fromAngle(-2.9026)};
    double deepest = 0;
    for (const Part& part : partsOf(comb)) {
        for (const Part& other : partsOf(comb)) {
            const Manifold manifold = collide(part, {}, other, moved, 0.01);
            const bool deeper = manifold.count > 0 && -leastSeparationIn(manifold) > deepest;
            deepest = deeper ? -leastSeparationIn(manifold) : deepest;
            QVERIFY(!deeper || deepest < 0.02 || isNear(manifold.normal, moved.rotation * Vec2(0, -1), 1e-6));
        }
    }
    QVERIFY2(isNear(deepest, 0.07, 0.001), QByteArray::number(deepest));
}

void CutsTest::aTipInANotchIsAnticipatedByBothFlanks_data() {
    QTest::addColumn<double>("along");
    QTest::addColumn<double>("above");
    QTest::newRow("on the left flank") << -0.01 << 0.001;
    QTest::newRow("on the right flank") << 0.01 << 0.001;
    QTest::newRow("in the middle") << 0.0 << 0.002;
    QTest::newRow("sunk into the left flank, where the cut is") << -0.0005 << -0.001;
    QTest::newRow("sunk into the right flank, where the cut is") << 0.0005 << -0.001;
}

void CutsTest::aTipInANotchIsAnticipatedByBothFlanks() {
    QFETCH(double, along);
    QFETCH(double, above);
    const std::vector<Part> ship = partsOf(Polygon{{Vec2(0, 0.2), Vec2(-0.2, -0.2), Vec2(0, -0.1), Vec2(0.2, -0.2)}});
    // The nose of another one, `above` the flank in the direction out of the notch.
    const Vec2 tip(along, -0.1 - 0.5 * std::fabs(along) - above);
    const Transform pose{tip - Vec2(0, 0.2), {}};
    for (const double side : {-1.0, 1.0}) {
        const Vec2 normal = Vec2(-side, -2).normalized(); // of the right flank for 1
        const double expected = normal.dot(tip - Vec2(0, -0.1));
        bool anticipated = false;
        for (const Part& part : ship) {
            for (const Part& other : ship) {
                const Manifold manifold = collide(part, {}, other, pose, 0.02);
                const Manifold turned = collide(other, pose, part, {}, 0.02);
                QCOMPARE(turned.count, manifold.count);
                QVERIFY(manifold.count == 0 || isNear(turned.normal, -manifold.normal));
                anticipated |= manifold.count > 0 && isNear(manifold.normal, normal) &&
                               isNear(leastSeparationIn(manifold), expected);
            }
        }
        QVERIFY2(anticipated, side < 0 ? "left" : "right");
    }
}

void CutsTest::aSideThatLandsOnOneEndIsAnticipatedAtTheOther() {
    // A margin of 2 cm, and ends that are 1 mm and 3 cm over the floor.
    const std::vector<Part> ship = partsOf(Polygon{{Vec2(0, 0.2), Vec2(-0.2, -0.2), Vec2(0, -0.1), Vec2(0.2, -0.2)}});
    const Vec2 side = Vec2(-0.2, -0.4);
    const double length = side.norm();
    const double turn = std::asin(0.029 / length) - std::atan2(side.y(), side.x());
    const Rot rotation = Rot::fromAngle(turn);
    const Vec2 nose = rotation * Vec2(0, 0.2);
    bool anticipated = false;
    for (const Part& part : ship) {
        const Transform pose{Vec2(0, 0.001) - nose, rotation};
        const Manifold manifold = collide(edge(Vec2(-5, 0), Vec2(5, 0)), {}, part, pose, 0.02);
        for (int i = 0; i < manifold.count; ++i) {
            anticipated |= isNear(manifold.points[static_cast<std::size_t>(i)].separation, 0.03);
        }
    }
    QVERIFY(anticipated);
}

SPACETOW_TEST(CutsTest)
#include "cuts_test.moc"
