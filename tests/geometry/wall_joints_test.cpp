#include "core/geometry/wall_side.h"

#include "core/geometry/collide.h"
#include "core/geometry/convex_parts.h"
#include "tests/geometry/chains.h"
#include "tests/geometry/contains.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

double deepest(const std::vector<Manifold>& manifolds) {
    double least = inf;
    for (const Manifold& manifold : manifolds) {
        for (int i = 0; i < manifold.count; ++i) {
            least = std::min(least, manifold.points[static_cast<std::size_t>(i)].separation);
        }
    }
    return least;
}

} // namespace

class WallJointsTest : public QObject {
    Q_OBJECT

  private slots:
    void slidingOverAStraightChainOnlyTheNormalIsSeen_data();
    void slidingOverAStraightChainOnlyTheNormalIsSeen();
    void aConvexJointIsRoundAndReportedOnce_data();
    void aConvexJointIsRoundAndReportedOnce();
    void aHollowJointHasNoCorner_data();
    void aHollowJointHasNoCorner();
    void behindAHollowJointSomethingStillPushes();
    void aBoxOverAConvexJointIsHeldByFaceOrCorner_data();
    void aBoxOverAConvexJointIsHeldByFaceOrCorner();
    void anyPolygonOnAJointedChainIsPushedOut_data();
    void anyPolygonOnAJointedChainIsPushedOut();
};

void WallJointsTest::slidingOverAStraightChainOnlyTheNormalIsSeen_data() {
    QTest::addColumn<bool>("oneWay");
    QTest::addColumn<double>("turn");
    QTest::addColumn<double>("depth"); // of the body in the wall
    for (const bool oneWay : {true, false}) {
        for (const double turn : {0.0, 0.7, 2.5}) {
            for (const double depth : {-0.004, 0.0, 0.005, 0.05}) {
                QTest::addRow("%s turned by %g, sunk by %g", oneWay ? "edges" : "lines", turn, depth)
                    << oneWay << turn << depth;
            }
        }
    }
}

void WallJointsTest::slidingOverAStraightChainOnlyTheNormalIsSeen() {
    QFETCH(bool, oneWay);
    QFETCH(double, turn);
    QFETCH(double, depth);
    const Rot rotation = Rot::fromAngle(turn);
    std::vector<Vec2> points;
    for (int i = 0; i <= 1000; ++i) {
        points.push_back(rotation * Vec2(0.1 * i - 50, 0));
    }
    const std::vector<Part> walls = chain(points, oneWay);
    const Vec2 up = rotation.up();
    Random random(7);
    const std::array<Part, 3> bodies{ball(0.2), box(0.2, 0.2), box(0.03, 0.2)};
    for (int i = 0; i < usualOrThin(1040, 240); ++i) {
        const double x = i < 40 ? 0.05 * i : random.uniform(-40, 40); // over joints as well
        const Vec2 center = rotation * Vec2(x, 0.2 - depth);
        for (const Part& body : bodies) {
            bool touched = false;
            const auto nearest = static_cast<std::size_t>((x + 50) / 0.1);
            for (std::size_t k = nearest - 5; k < nearest + 6; ++k) {
                const Manifold manifold = collide(walls[k], {}, body, {center, rotation}, 0.005);
                if (manifold.count > 0) {
                    touched = true;
                    QVERIFY2(isNear(manifold.normal, up, 1e-9), QByteArray::number(x, 'g', 17));
                    QVERIFY(isNear(manifold.points[0].separation, -depth, 1e-9));
                }
            }
            QVERIFY(touched);
        }
    }
}

void WallJointsTest::aConvexJointIsRoundAndReportedOnce_data() {
    QTest::addColumn<bool>("oneWay");
    QTest::addColumn<double>("turn");
    for (const bool oneWay : {true, false}) {
        for (const double degrees : {0.01, 1.0, 10.0, 45.0, 90.0, 135.0, 170.0}) {
            QTest::addRow("%s turning right by %g°", oneWay ? "edges" : "lines", degrees) << oneWay << degrees;
        }
    }
}

void WallJointsTest::aConvexJointIsRoundAndReportedOnce() {
    QFETCH(bool, oneWay);
    QFETCH(double, turn);
    const double angle = turn * std::numbers::pi / 180;
    const Vec2 along = Rot::fromAngle(-angle).right();
    const std::vector<Part> walls = chain({Vec2(-2, 0), Vec2(0, 0), 2 * along}, oneWay, 0.05);
    for (int i = -20; i <= 120; ++i) {
        // From straight over the first wall to straight over the second one, and a bit further at each end.
        const double share = i / 100.0;
        const Vec2 way = Rot::fromAngle(std::numbers::pi / 2 - share * angle).right();
        const auto found = contacts(walls, ball(0.2), {Vec2(0.19 * way), {}}, 0.001);
        if (i < 0 || i > 100) {
            continue; // there both the face and, near the tip, the other side may answer
        }
        QVERIFY2(!found.empty(), QByteArray::number(i));
        QVERIFY2(found.size() == 1 || i == 0 || i == 100, QByteArray::number(i));
        for (const Manifold& manifold : found) {
            QVERIFY2(isNear(manifold.normal, way, 1e-7), QByteArray::number(i));
            QVERIFY(isNear(manifold.points[0].separation, -0.01, 1e-7));
        }
    }
}

void WallJointsTest::aHollowJointHasNoCorner_data() {
    QTest::addColumn<bool>("oneWay");
    QTest::addColumn<double>("turn");
    for (const bool oneWay : {true, false}) {
        for (const double degrees : {0.01, 1.0, 10.0, 45.0, 90.0, 135.0, 170.0}) {
            QTest::addRow("%s turning left by %g°", oneWay ? "edges" : "lines", degrees) << oneWay << degrees;
        }
    }
}

void WallJointsTest::aHollowJointHasNoCorner() {
    QFETCH(bool, oneWay);
    QFETCH(double, turn);
    const double angle = turn * std::numbers::pi / 180;
    const Vec2 along = Rot::fromAngle(angle).right();
    const std::vector<Part> walls = chain({Vec2(-30, 0), Vec2(0, 0), 30 * along}, oneWay);
    for (const double t : {-0.5, -0.1, -0.01, 0.0}) {
        // Rolling along the first wall into the hollow, until both faces are touched.
        const double contact = -0.2 * std::tan(angle / 2); // where the ball touches both
        const auto found = contacts(walls, ball(0.2), {Vec2(contact + t, 0.199), {}}, 0.001);
        QVERIFY(!found.empty());
        for (const Manifold& manifold : found) {
            QVERIFY(isNear(manifold.normal, Vec2(0, 1)) || isNear(manifold.normal, leftOf(along)));
        }
    }
}

void WallJointsTest::behindAHollowJointSomethingStillPushes() {
    for (const double depth : {0.5, inf}) {
        const std::vector<Part> wedge = chain({Vec2(-1, 1), Vec2(0, 0), Vec2(1, 1)}, true, depth);
        for (const double x : {-0.1, 0.0, 0.1}) {
            for (const Part& body : {ball(0.2), box(0.2, 0.2)}) {
                const auto found = contacts(wedge, body, {Vec2(x, -0.3), {}}, 0);
                QVERIFY(!found.empty());
                for (const Manifold& manifold : found) {
                    QVERIFY(manifold.normal.y() > 0.7);
                }
            }
        }
    }
}

void WallJointsTest::aBoxOverAConvexJointIsHeldByFaceOrCorner_data() {
    QTest::addColumn<double>("turn");
    for (const double degrees : {0.1, 2.0, 10.0, 30.0, 60.0, 90.0}) {
        QTest::addRow("%g°", degrees) << degrees;
    }
}

void WallJointsTest::aBoxOverAConvexJointIsHeldByFaceOrCorner() {
    QFETCH(double, turn);
    const double angle = turn * std::numbers::pi / 180;
    const std::vector<Part> walls = chain({Vec2(-5, 0), Vec2(0, 0), 5 * Rot::fromAngle(-angle).right()}, true);
    for (int i = 0; i <= 50; ++i) {
        // The middle of the box's lower side on the corner, leaning from one wall to the other.
        const Rot lean = Rot::fromAngle(-angle * i / 50);
        const auto found = contacts(walls, box(0.3, 0.2), {Vec2((0.2 - 0.002) * lean.up()), lean}, 0.001);
        QVERIFY2(!found.empty(), QByteArray::number(i));
        for (const Manifold& manifold : found) {
            // No other direction than one between the two normals, and no deeper than the box is.
            QVERIFY(manifold.normal.y() >= std::cos(angle) - 1e-9);
            QVERIFY(cross(Vec2(0, 1), manifold.normal) <= 1e-9);
        }
        QVERIFY2(deepest(found) > -0.004 && deepest(found) <= -0.0019, QByteArray::number(deepest(found)));
    }
}

void WallJointsTest::anyPolygonOnAJointedChainIsPushedOut_data() {
    QTest::addColumn<bool>("oneWay");
    QTest::newRow("edges") << true;
    QTest::newRow("lines") << false;
}

/// Random polygons lowered on to a random hilly chain until they overlap it a little: some wall always answers, its
/// normal is no steeper than the polygon or the chain allows, and never tells of more than the true overlap.
void WallJointsTest::anyPolygonOnAJointedChainIsPushedOut() {
    QFETCH(bool, oneWay);
    for (unsigned seed = 0; seed < usualOrThin(2000u, 400u); ++seed) {
        Random random(seed);
        std::vector<Vec2> points;
        for (int i = 0; i <= 30; ++i) {
            points.emplace_back(0.2 * i - 3, random.uniform(0, 0.15));
        }
        const std::vector<Part> walls = chain(points, oneWay);
        const Part body = randomConvex(random);
        Transform pose{Vec2(random.uniform(-1, 1), 0), Rot::fromAngle(random.uniform(-4, 4))};
        // Lower it until the deepest corner over the terrain, or the highest peak under it, is sunk by `sunk`.
        const double sunk = random.uniform(0.0002, 0.01);
        const auto crosses = [&](double y) {
            pose.position.y() = y;
            for (std::size_t i = 1; i < points.size(); ++i) {
                for (int k = 0; k <= 20; ++k) {
                    if (contains(body, pose, points[i - 1] + k / 20.0 * (points[i] - points[i - 1]))) {
                        return true;
                    }
                }
            }
            return false;
        };
        double low = 3;
        while (!crosses(low)) {
            low -= 0.05;
        }
        double high = low + 0.05;
        for (int k = 0; k < 30; ++k) {
            const double middle = 0.5 * (low + high);
            (crosses(middle) ? low : high) = middle;
        }
        pose.position.y() = low - sunk;
        const auto found = contacts(walls, body, pose, 0);
        QVERIFY2(!found.empty(), "seed " + QByteArray::number(seed));
        for (const Manifold& manifold : found) {
            // A sharp tip that straddles a line may belong to either side; then it is hardly pushed at all.
            const bool hardly = !oneWay && deepest({manifold}) > -0.006;
            QVERIFY2(manifold.normal.y() > 0 || hardly, "seed " + QByteArray::number(seed));
        }
        // A sharp corner that slid in sideways, or between the samples, is deeper than it was lowered.
        QVERIFY2(deepest(found) >= -(4 * sunk + 0.05), "seed " + QByteArray::number(seed) + " sunk " +
                                                           QByteArray::number(sunk) + " reported " +
                                                           QByteArray::number(deepest(found)));
    }
}

SPACETOW_TEST(WallJointsTest)
#include "wall_joints_test.moc"
