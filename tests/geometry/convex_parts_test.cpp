#include "core/geometry/convex_parts.h"

#include "core/geometry/collide.h"
#include "core/geometry/triangulate.h"
#include "tests/geometry/contains.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<ConvexPart> convexPartsOf(const std::vector<Vec2>& outline) {
    std::vector<ConvexPart> result;
    for (const Part& part : partsOf(Polygon{outline})) {
        result.push_back(std::get<ConvexPart>(part));
    }
    return result;
}

std::span<const Vec2> cornersOf(const ConvexPart& part) {
    return std::span(part.corners).first(static_cast<std::size_t>(part.count));
}

/// A simple outline: radii that vary with the angle, so concave in many places.
std::vector<Vec2> randomStar(Random& random, int count) {
    std::vector<Vec2> outline;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.uniform(0, 0.8)) / count;
        outline.push_back(random.uniform(0.1, 1) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

double outerLength(const ConvexPart& part) {
    double length = 0;
    for (int i = 0; i < part.count; ++i) {
        const Vec2& a = part.corners[static_cast<std::size_t>(i)];
        const Vec2& b = part.corners[static_cast<std::size_t>((i + 1) % part.count)];
        length += (part.outerFaces >> i & 1) != 0 ? (b - a).norm() : 0;
    }
    return length;
}

double lengthOf(const std::vector<Vec2>& outline) {
    double length = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    }
    return length;
}

void checkPart(const ConvexPart& part, const QByteArray& name) {
    QVERIFY2(part.count >= 3 && part.count <= ConvexPart::maxCorners, name);
    QVERIFY2(signedArea(cornersOf(part)) > 0, name);
    QVERIFY2(isNear(centroid(cornersOf(part)), part.center, 1e-12), name);
    for (int i = 0; i < part.count; ++i) {
        const Vec2& a = part.corners[static_cast<std::size_t>(i)];
        const Vec2& b = part.corners[static_cast<std::size_t>((i + 1) % part.count)];
        const Vec2& normal = part.normals[static_cast<std::size_t>(i)];
        QVERIFY2(isNear(normal.norm(), 1, 1e-12) && isNear(normal.dot(b - a), 0, 1e-12), name);
        for (const Vec2& corner : cornersOf(part)) {
            QVERIFY2(normal.dot(corner - a) <= 1e-9, name);
        }
    }
}

/// The parts are convex, cover the outline's area without overlap, and have its sides as outer faces.
void checkParts(const std::vector<Vec2>& outline, const QByteArray& name) {
    double area = 0;
    double length = 0;
    for (const ConvexPart& part : convexPartsOf(outline)) {
        checkPart(part, name);
        if (QTest::currentTestFailed()) {
            return;
        }
        area += signedArea(cornersOf(part));
        length += outerLength(part);
    }
    QVERIFY2(isNear(area, std::fabs(signedArea(outline)), 1e-9), name);
    QVERIFY2(isNear(length, lengthOf(outline), 1e-9), name);
}

} // namespace

class ConvexPartsTest : public QObject {
    Q_OBJECT

  private slots:
    void roundAndThinShapesStayWhatTheyAre();
    void polygonsAreCutIntoConvexParts_data();
    void polygonsAreCutIntoConvexParts();
    void randomPolygonsAreCutIntoConvexParts();
    void pointsAreInThePartsOfWhatContainsThem();
    void degenerateOutlinesDoNoHarm_data();
    void degenerateOutlinesDoNoHarm();
    void aLargeOutlineIsCutInReasonableTime();
    void aSpiralIsCutWithFewLooksAtItsCorners();
    void edgesAreJoinedInTheirDirection();
    void linesAreJoinedInEitherDirection();
    void wallsOnTopOfEachOtherAreNotJoined();
    void atACrossingTheStraightestPairsAreJoined();
    void aClosedLoopIsJoinedAllRound();
    void joiningDoesNotDependOnTheOrder();
    void aRowOfBoxesIsAsSmoothAsOne();
    void joinedPartsKnowTheOutlineBeyondTheirCorners();
};

void ConvexPartsTest::roundAndThinShapesStayWhatTheyAre() {
    const auto circle = partsOf(Circle{Vec2(1, 2), 3});
    QVERIFY(circle.size() == 1 && std::get<Circle>(circle[0]) == (Circle{Vec2(1, 2), 3}));
    const auto edges = partsOf(Edge{Vec2(1, 2), Vec2(3, 4), 0.5});
    const auto& wall = std::get<WallPart>(edges.at(0));
    QVERIFY(wall.oneWay && wall.depth == 0.5 && wall.a == Vec2(1, 2) && wall.b == Vec2(3, 4));
    QVERIFY(!wall.joinedAtA && !wall.joinedAtB);
    QVERIFY(!std::get<WallPart>(partsOf(Line{Vec2(1, 2), Vec2(3, 4)}).at(0)).oneWay);
}

void ConvexPartsTest::polygonsAreCutIntoConvexParts_data() {
    QTest::addColumn<std::vector<Vec2>>("outline");
    QTest::addColumn<std::size_t>("mostParts");
    QTest::newRow("square") << std::vector{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)} << std::size_t{1};
    QTest::newRow("clockwise square") << std::vector{Vec2(0, 1), Vec2(1, 1), Vec2(1, 0), Vec2(0, 0)} << std::size_t{1};
    QTest::newRow("octagon") << regularPolygon(8, 1) << std::size_t{1};
    QTest::newRow("nonagon") << regularPolygon(9, 1) << std::size_t{2};
    QTest::newRow("wheel") << regularPolygon(40, 1) << std::size_t{12};
    QTest::newRow("straight corners") << std::vector{Vec2(0, 0), Vec2(1, 0), Vec2(2, 0),
                                                     Vec2(2, 1), Vec2(2, 2), Vec2(0, 2)}
                                      << std::size_t{1};
    QTest::newRow("ship") << std::vector{Vec2(0, 0.7 / 3), Vec2(-0.2, -0.5 / 3), Vec2(0, -0.2 / 3), Vec2(0.2, -0.5 / 3)}
                          << std::size_t{2};
    QTest::newRow("L") << std::vector{Vec2(0, 0), Vec2(3, 0), Vec2(3, 1), Vec2(1, 1), Vec2(1, 3), Vec2(0, 3)}
                       << std::size_t{2};
    QTest::newRow("comb") << std::vector{Vec2(0, 0), Vec2(5, 0), Vec2(5, 2), Vec2(4.5, 2), Vec2(4.5, 1), Vec2(3, 1),
                                         Vec2(3, 2), Vec2(2, 2), Vec2(2, 1), Vec2(1, 1),   Vec2(1, 2),   Vec2(0, 2)}
                          << std::size_t{6};
}

void ConvexPartsTest::polygonsAreCutIntoConvexParts() {
    QFETCH(std::vector<Vec2>, outline);
    QFETCH(std::size_t, mostParts);
    checkParts(outline, QTest::currentDataTag());
    const std::size_t count = convexPartsOf(outline).size();
    QVERIFY2(count <= mostParts, QByteArray::number(static_cast<int>(count)));
}

void ConvexPartsTest::randomPolygonsAreCutIntoConvexParts() {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        checkParts(randomStar(random, 5 + static_cast<int>(random.below(40))), "seed " + QByteArray::number(seed));
        if (QTest::currentTestFailed()) {
            return;
        }
    }
}

void ConvexPartsTest::pointsAreInThePartsOfWhatContainsThem() {
    for (unsigned seed = 0; seed < 200; ++seed) {
        Random random(seed);
        const Polygon polygon{randomStar(random, 12)};
        const std::vector<Part> parts = partsOf(polygon);
        for (int i = 0; i < 100; ++i) {
            const Vec2 p = randomPoint(random, 1);
            const bool inParts =
                std::any_of(parts.begin(), parts.end(), [&](const Part& part) { return contains(part, {}, p); });
            QVERIFY2(contains(Shape(polygon), {}, p) == inParts, "seed " + QByteArray::number(seed));
        }
    }
}

void ConvexPartsTest::degenerateOutlinesDoNoHarm_data() {
    QTest::addColumn<std::vector<Vec2>>("outline");
    QTest::addColumn<bool>("solid");
    QTest::newRow("nothing") << std::vector<Vec2>{} << false;
    QTest::newRow("a point") << std::vector{Vec2(1, 1)} << false;
    QTest::newRow("a line") << std::vector{Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)} << false;
    QTest::newRow("one point many times") << std::vector<Vec2>(20, Vec2(1, 1)) << false;
    QTest::newRow("repeated vertices") << std::vector{Vec2(0, 0), Vec2(0, 0), Vec2(1, 0),
                                                      Vec2(1, 1), Vec2(1, 1), Vec2(0, 0)}
                                       << true;
    QTest::newRow("a spike") << std::vector{Vec2(0, 0), Vec2(1, 0), Vec2(5, 0), Vec2(1, 0), Vec2(1, 1)} << true;
    QTest::newRow("bow tie") << std::vector{Vec2(0, 0), Vec2(2, 2), Vec2(2, 0), Vec2(0, 3)} << true;
    QTest::newRow("star drawn through itself") << [] {
        const auto ring = regularPolygon(5, 1);
        return std::vector{ring[0], ring[2], ring[4], ring[1], ring[3]};
    }() << true;
    QTest::newRow("hair thin") << std::vector{Vec2(0, 0), Vec2(10, 0), Vec2(10, 1e-9), Vec2(5, 2e-9), Vec2(0, 1e-9)}
                               << true;
    QTest::newRow("not a number") << std::vector{Vec2(0, 0), Vec2(std::nan(""), 0), Vec2(1, 1), Vec2(0, 1)} << true;
}

void ConvexPartsTest::degenerateOutlinesDoNoHarm() {
    QFETCH(std::vector<Vec2>, outline);
    QFETCH(bool, solid);
    const auto parts = convexPartsOf(outline);
    QVERIFY(solid || parts.empty());
    for (const ConvexPart& part : parts) {
        QVERIFY(part.count >= 3 && part.count <= ConvexPart::maxCorners);
        for (int i = 0; i < part.count; ++i) {
            QVERIFY(isFinite(part.normals[static_cast<std::size_t>(i)]));
        }
    }
}

void ConvexPartsTest::aLargeOutlineIsCutInReasonableTime() {
    Random random(5);
    QElapsedTimer timer;
    timer.start();
    checkParts(randomStar(random, 3000), "star of 3000");
    QVERIFY(timer.elapsed() < 10000);
}

void ConvexPartsTest::aSpiralIsCutWithFewLooksAtItsCorners() {
    // Every corner of the inner side is reflex. Held against each triangle that is tried they make ten million looks.
    constexpr int turns = 512;
    std::vector<Vec2> outline;
    for (const double width : {0.0, 0.3}) {
        for (int i = 0; i < turns; ++i) {
            const double angle = 0.15 * (width > 0 ? turns - 1 - i : i);
            outline.push_back((1 + 0.2 * angle - width) * Vec2(std::cos(angle), std::sin(angle)));
        }
    }
    checkParts(outline, "spiral");
    std::size_t looks = 0;
    convexPieces(cleanOutline(outline), ConvexPart::maxCorners, &looks);
    QVERIFY2(looks > 0 && looks < 60 * outline.size(), QByteArray::number(static_cast<qulonglong>(looks)));
}

void ConvexPartsTest::edgesAreJoinedInTheirDirection() {
    auto first = std::get<WallPart>(edge(Vec2(0, 0), Vec2(1, 0)));
    auto second = std::get<WallPart>(edge(Vec2(1, 0), Vec2(2, 1)));
    auto against = std::get<WallPart>(edge(Vec2(3, 1), Vec2(2, 1)));
    joinWalls(std::array{&first, &second, &against});
    QVERIFY(!first.joinedAtA && first.joinedAtB && first.afterB == Vec2(2, 1));
    QVERIFY(second.joinedAtA && second.beforeA == Vec2(0, 0));
    QVERIFY(!second.joinedAtB && !against.joinedAtA && !against.joinedAtB); // both end there
    joinWalls(std::array{&second});
    QVERIFY(!second.joinedAtA); // earlier joints are forgotten
}

void ConvexPartsTest::linesAreJoinedInEitherDirection() {
    auto first = std::get<WallPart>(line(Vec2(0, 0), Vec2(1, 0)));
    auto second = std::get<WallPart>(line(Vec2(2, 1), Vec2(1, 0)));
    joinWalls(std::array{&first, &second});
    QVERIFY(first.joinedAtB && first.afterB == Vec2(2, 1));
    QVERIFY(second.joinedAtB && second.afterB == Vec2(0, 0));
    QVERIFY(!first.joinedAtA && !second.joinedAtA);
}

void ConvexPartsTest::wallsOnTopOfEachOtherAreNotJoined() {
    auto first = std::get<WallPart>(line(Vec2(1, 0), Vec2(2, 0)));
    for (const bool oneWay : {false, true}) {
        auto same = std::get<WallPart>(oneWay ? edge(Vec2(2, 0), Vec2(1, 0)) : line(Vec2(2, 0), Vec2(1, 0)));
        joinWalls(std::array{&first, &same});
        QVERIFY(!first.joinedAtA && !first.joinedAtB);
    }
}

void ConvexPartsTest::atACrossingTheStraightestPairsAreJoined() {
    auto west = std::get<WallPart>(line(Vec2(-1, 0), Vec2(0, 0)));
    auto east = std::get<WallPart>(line(Vec2(0, 0), Vec2(1, 0.1)));
    auto south = std::get<WallPart>(line(Vec2(0, -1), Vec2(0, 0)));
    joinWalls(std::array{&west, &east, &south});
    QVERIFY(west.joinedAtB && west.afterB == Vec2(1, 0.1));
    QVERIFY(east.joinedAtA && east.beforeA == Vec2(-1, 0));
    QVERIFY(!south.joinedAtB);
}

void ConvexPartsTest::aClosedLoopIsJoinedAllRound() {
    const auto ring = regularPolygon(12, 6);
    std::vector<WallPart> walls;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        walls.push_back(std::get<WallPart>(edge(ring[i], ring[(i + 1) % ring.size()])));
    }
    std::vector<WallPart*> pointers;
    for (WallPart& wall : walls) {
        pointers.push_back(&wall);
    }
    joinWalls(pointers);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        QVERIFY(walls[i].joinedAtA && walls[i].joinedAtB);
        QCOMPARE(walls[i].afterB, walls[(i + 1) % 12].b);
        QCOMPARE(walls[i].beforeA, walls[(i + 11) % 12].a);
    }
}

void ConvexPartsTest::joiningDoesNotDependOnTheOrder() {
    for (unsigned seed = 0; seed < 200; ++seed) {
        Random random(seed);
        std::vector<WallPart> walls;
        for (int i = 0; i < 30; ++i) { // on a small grid, so that many ends meet
            const Vec2 a(random.below(4), random.below(4));
            const Vec2 b(random.below(4), random.below(4));
            walls.push_back(std::get<WallPart>(random.below(2) == 0 ? edge(a, b) : line(a, b)));
        }
        std::vector<WallPart*> pointers;
        for (WallPart& wall : walls) {
            pointers.push_back(&wall);
        }
        joinWalls(pointers);
        for (const WallPart& wall : walls) {
            const auto leads = [&](const Vec2& from, const Vec2& to) {
                return std::any_of(walls.begin(), walls.end(), [&](const WallPart& other) {
                    const bool eitherWay = !wall.oneWay || !other.oneWay;
                    return (other.a == from && other.b == to) || (eitherWay && other.b == from && other.a == to);
                });
            };
            QVERIFY(!wall.joinedAtB || leads(wall.b, wall.afterB));
            QVERIFY(!wall.joinedAtA || leads(wall.beforeA, wall.a));
        }
        const std::vector<WallPart> before = walls;
        joinWalls(pointers);
        for (std::size_t i = 0; i < walls.size(); ++i) {
            QVERIFY(before[i].joinedAtA == walls[i].joinedAtA && before[i].beforeA == walls[i].beforeA);
            QVERIFY(before[i].joinedAtB == walls[i].joinedAtB && before[i].afterB == walls[i].afterB);
        }
    }
}

void ConvexPartsTest::aRowOfBoxesIsAsSmoothAsOne() {
    std::vector<Part> boxes;
    for (int i = 0; i < 20; ++i) {
        boxes.push_back(box(0.25, 0.25, Vec2(0.5 * i, -0.25)));
    }
    std::vector<ConvexPart*> pointers;
    for (Part& part : boxes) {
        pointers.push_back(&std::get<ConvexPart>(part));
    }
    joinConvexParts(pointers);
    QCOMPARE(static_cast<int>(pointers[0]->outerFaces), 0b1101);
    QCOMPARE(static_cast<int>(pointers[5]->outerFaces), 0b0101);
    for (int i = 0; i <= 1000; ++i) {
        const Vec2 center(1 + 0.005 * i, 0.195);
        for (const Part& body : {Part(Circle{Vec2(0, 0), 0.2}), box(0.2, 0.2)}) {
            int contacts = 0;
            for (const Part& part : boxes) {
                const Manifold manifold = collide(part, {}, body, {center, {}}, 0.002);
                contacts += manifold.count;
                QVERIFY2(manifold.count == 0 || isNear(manifold.normal, Vec2(0, 1)), QByteArray::number(i));
            }
            QVERIFY2(contacts > 0, QByteArray::number(i));
        }
    }
}

void ConvexPartsTest::joinedPartsKnowTheOutlineBeyondTheirCorners() {
    // An L: one box beside another that carries a third. Parts that were moved before their faces became inner ones
    // know nothing of what is beyond.
    std::vector<Part> boxes{box(0.5, 0.5, Vec2(-0.5, 0.5)), box(0.5, 0.5, Vec2(0.5, 0.5)),
                            box(0.5, 0.5, Vec2(0.5, 1.5))};
    std::vector<ConvexPart*> parts;
    for (Part& part : boxes) {
        parts.push_back(&std::get<ConvexPart>(part));
        parts.back()->normalsBeyond.fill(Vec2(0.6, -0.8));
    }
    joinConvexParts(parts);
    const Vec2 left(-1, 0);
    const Vec2 right(1, 0);
    const Vec2 up(0, 1);
    const Vec2 down(0, -1);
    struct Expected {
        std::size_t part, corner;
        Vec2 normal;
    };
    const Expected all[] = {
        {0, 0, left}, {0, 1, down},  {0, 2, left},  {0, 3, up}, // 2: in the notch
        {1, 0, down}, {1, 1, down},  {1, 2, right},             // 3 is inside
        {2, 0, up},   {2, 1, right}, {2, 2, right}, {2, 3, up}, // 0: in the notch
    };
    for (const Expected& expected : all) {
        const Vec2& normal = parts[expected.part]->normalsBeyond[expected.corner];
        QVERIFY2(isNear(normal, expected.normal),
                 qPrintable(QString("part %1, corner %2").arg(expected.part).arg(expected.corner)));
    }
}

SPACETOW_TEST(ConvexPartsTest)
#include "convex_parts_test.moc"
