#include "core/geometry/collide.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/near_points.h"
#include "core/geometry/wall_side.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

WallPart wallFrom(const Part& part) {
    return std::get<WallPart>(part);
}

Part blockBetween(const Vec2& low, const Vec2& high) {
    return partsOf(Polygon{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}}).front();
}

void joinBlocks(std::vector<Part>& blocks) {
    std::vector<ConvexPart*> parts;
    for (Part& block : blocks) {
        parts.push_back(&std::get<ConvexPart>(block));
    }
    joinConvexParts(parts);
}

} // namespace

class NearJointsTest : public QObject {
    Q_OBJECT

  private slots:
    void pointsWithinTheToleranceAreFound();
    void endsThatNearlyMeetAreJoined();
    void aShortWallIsNotJoinedWithItself();
    void blocksThatNearlyMeetShareAFace();
    void whatTheShorterOfTwoBlocksCoversIsAnInnerFace();
    void facesThatLieFlatOnEachOtherHaveTwoPoints();
    void aLineGoesOnAsAnEdgeOnTheSolidSideAlone();
};

void NearJointsTest::pointsWithinTheToleranceAreFound() {
    for (unsigned seed = 0; seed < 50; ++seed) {
        Random random(seed);
        std::vector<Vec2> points;
        for (int i = 0; i < 200; ++i) {
            const Vec2 site(random.below(5) * 0.1, random.below(5) * 0.1 - 0.2);
            points.push_back(site + Vec2(random.uniform(-3e-6, 3e-6), random.uniform(-3e-6, 3e-6)));
        }
        const NearPoints near(points);
        for (const Vec2& at : points) {
            std::set<std::uint32_t> found;
            QVERIFY(near.visit(at, [&](std::uint32_t i) { found.insert(i); }));
            for (std::uint32_t i = 0; i < points.size(); ++i) {
                QCOMPARE(found.count(i) == 1, (points[i] - at).norm() <= jointTolerance);
            }
        }
    }
}

void NearJointsTest::endsThatNearlyMeetAreJoined() {
    for (const double gap : {0.0, 1e-16, 1e-12, 1e-9, 1e-6, 1.9e-6, 2.1e-6, 1e-3}) {
        for (const Vec2& way : {Vec2(1, 0), Vec2(0, -1), Vec2(-0.6, 0.8)}) {
            const Vec2 miss = gap * way;
            WallPart first = wallFrom(edge({0, 0.3}, {0.3, 0.3}));
            WallPart second = wallFrom(edge(Vec2(0.3, 0.3) + miss, Vec2(1.3, 0.4) + miss));
            joinWalls(std::array{&first, &second});
            QCOMPARE(first.joinedAtB, gap < jointTolerance);
            QCOMPARE(second.joinedAtA, gap < jointTolerance);
            if (first.joinedAtB) { // the neighbour's direction is its own, wherever it is
                QVERIFY(isNear(first.afterB - first.b, second.b - second.a, 1e-15));
                QVERIFY(isNear(second.a - second.beforeA, first.b - first.a, 1e-15));
            }
        }
    }
}

void NearJointsTest::aShortWallIsNotJoinedWithItself() {
    WallPart first = wallFrom(line({-1, 0}, {0, 0}));
    WallPart second = wallFrom(line({0, 0}, {1e-6, 0}));
    WallPart third = wallFrom(line({1e-6, 0}, {1, 0}));
    joinWalls(std::array{&first, &second, &third});
    QVERIFY(first.afterB == Vec2(1e-6, 0) && second.beforeA == Vec2(-1, 0));
    QVERIFY(second.afterB == Vec2(1, 0) && third.beforeA == Vec2(0, 0));
}

void NearJointsTest::blocksThatNearlyMeetShareAFace() {
    for (const double gap : {0.0, 1e-15, -1e-9, 1e-6, -1e-6, 1e-4}) {
        std::vector<Part> blocks{blockBetween({-1, -1}, {0, 0}), blockBetween({gap, -1 + gap}, {1, gap})};
        joinBlocks(blocks);
        const bool meets = std::abs(gap) < 1e-5;
        QCOMPARE(static_cast<int>(std::get<ConvexPart>(blocks[0]).outerFaces), meets ? 0b1101 : 0b1111);
        QCOMPARE(static_cast<int>(std::get<ConvexPart>(blocks[1]).outerFaces), meets ? 0b0111 : 0b1111);
    }
}

void NearJointsTest::whatTheShorterOfTwoBlocksCoversIsAnInnerFace() {
    for (const double miss : {0.0, 1e-12, 1e-7, -1e-6}) {
        std::vector<Part> blocks{blockBetween({-5, -1}, {0, 0}), blockBetween({0, -2}, {5, miss})};
        joinBlocks(blocks);
        QCOMPARE(std::get<ConvexPart>(blocks[0]).count, 4);
        QCOMPARE(std::get<ConvexPart>(blocks[1]).count, 5);
        // On top the way is free,
        for (const double x : {-0.3, -0.25, -0.25 + 1e-9, -0.2, 0.0, 0.2}) {
            for (const Part& block : blocks) {
                const Manifold manifold = collide(block, {}, box(0.25, 0.25), {{x, 0.25 - 1e-5}, {}}, 0.02);
                QVERIFY(manifold.count == 0 || isNear(manifold.normal, Vec2(0, 1), 1e-9));
            }
        }
        // below the shorter block it is not.
        const Manifold under = collide(blocks[1], {}, box(0.25, 0.25), {{-0.251, -1.3}, {}}, 0.02);
        QCOMPARE(under.count, 2);
        QVERIFY(isNear(under.normal, Vec2(-1, 0), 1e-9));
    }
}

void NearJointsTest::facesThatLieFlatOnEachOtherHaveTwoPoints() {
    const Part part = box(0.15, 0.26);
    for (const double gap : {1e-3, 1e-5, 1.5e-6, 0.5e-6, 0.0, -1e-6, -1e-4}) {
        for (int exponent = -17; exponent <= -6; ++exponent) {
            for (const double sign : {-1.0, 1.0}) {
                const double little = sign * std::pow(10.0, exponent);
                const Manifold aside = collide(part, {}, part, {{little, 0.52 + gap}, {}}, 0.05);
                QVERIFY2(aside.count == 2, qPrintable(QString("%1 m aside, gap %2").arg(little).arg(gap)));
                for (const double shift : {0.0, little}) {
                    const Transform tilted{{shift, 0.52 + gap}, Rot::fromAngle(little)};
                    const Manifold manifold = collide(part, {}, part, tilted, 0.05);
                    QVERIFY2(manifold.count == 2, qPrintable(QString("turned by %1, gap %2").arg(little).arg(gap)));
                    QVERIFY(manifold.normal.y() > 1 - 1e-11);
                }
            }
        }
    }
}

void NearJointsTest::aLineGoesOnAsAnEdgeOnTheSolidSideAlone() {
    for (const double gap : {0.0, 1e-15, -1e-6}) {
        for (const bool reversed : {false, true}) {
            WallPart first = wallFrom(edge({-1, 0}, {0, 0}));
            WallPart second = reversed ? wallFrom(line({2, 0}, {gap, 0})) : wallFrom(line({gap, 0}, {2, 0}));
            joinWalls(std::array{&first, &second});
            QVERIFY(first.joinedAtB && !first.joinedAtA);
            QVERIFY(sideOf(first, false).end.kind == WallEnd::Kind::Smooth);
            const WallSide above = sideOf(second, reversed);
            const WallSide below = sideOf(second, !reversed);
            QVERIFY(above.normal.y() > 0 && above.start.kind == WallEnd::Kind::Smooth);
            QVERIFY(below.end.kind == WallEnd::Kind::Free);
        }
    }
    WallPart first = wallFrom(edge({-1, 0}, {0, 0}));
    WallPart second = wallFrom(edge({0, 0}, {1, 1}));
    WallPart third = wallFrom(line({0, 0}, {1, 0}));
    joinWalls(std::array{&first, &second, &third}); // edges go before
    QVERIFY(first.afterB == second.b && !third.joinedAtA);
}

SPACETOW_TEST(NearJointsTest)
#include "near_joints_test.moc"
