#include "core/level/build.h"

#include "core/geometry/polygon.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class BuildTest : public QObject {
    Q_OBJECT

  private slots:
    void aChainBecomesOneWallASegment_data() {
        QTest::addColumn<bool>("closed");
        QTest::addColumn<int>("walls");
        QTest::newRow("open") << false << 2;
        QTest::newRow("closed") << true << 3;
    }
    void aChainBecomesOneWallASegment() {
        QFETCH(bool, closed);
        QFETCH(int, walls);
        const std::vector<Vec2> vertices{{0, 0}, {1, 0}, {1, 1}};
        BodyObject body;
        body.shapes = {EdgeChain{vertices, closed, 0.5}, LineChain{vertices, closed}};
        const std::vector<Shape> shapes = physicsShapes(body);
        QCOMPARE(shapes.size(), static_cast<std::size_t>(2 * walls));
        for (int i = 0; i < walls; ++i) {
            const Vec2& a = vertices[static_cast<std::size_t>(i)];
            const Vec2& b = vertices[static_cast<std::size_t>((i + 1) % 3)];
            QVERIFY((std::get<Edge>(shapes[static_cast<std::size_t>(i)]) == Edge{a, b, 0.5}));
            QVERIFY((std::get<Line>(shapes[static_cast<std::size_t>(i + walls)]) == Line{a, b}));
        }
    }

    void segmentsWithoutLengthAreLeftOut() {
        BodyObject body;
        body.shapes = {EdgeChain{{{0, 0}, {0, 0}, {1, 0}, {1, 0}}, false, 1},
                       LineChain{{{0, 0}, {1, 0}, {0, 0}}, true}};
        QCOMPARE(physicsShapes(body).size(), std::size_t{3});
    }

    void clockwisePolygonsAreTakenTheOtherWayRound() {
        BodyObject body;
        body.shapes = {Polygon{{{0, 0}, {0, 1}, {0, 1}, {1, 0}, {0, 0}}}};
        const auto polygon = std::get<Polygon>(physicsShapes(body).at(0));
        QCOMPARE(polygon.vertices.size(), std::size_t{3});
        QVERIFY(signedArea(polygon.vertices) > 0);
    }

    void everyFieldReachesTheWorld() {
        Level level = populatedLevel();
        Object thawed = level.objects[0];
        std::get<BodyObject>(thawed.data).frozen = false;
        level.objects.replace(0, thawed);
        const BuiltWorld built = builtWorld(level);
        QCOMPARE(built.bodies.size(), std::size_t{3});
        QCOMPARE(built.bodies[0].first, Key{1});
        const auto& object = std::get<BodyObject>(level.objects[0].data);
        const BodyState body = built.world.body(built.bodies[0].second);
        QCOMPARE(body.user, std::uint64_t{1});
        QCOMPARE(body.kind, object.kind);
        QVERIFY(body.pose.position == object.position);
        QVERIFY(std::abs(body.angle - object.angle) < 1e-12);
        QVERIFY(body.velocity == object.velocity);
        QCOMPARE(body.angularVelocity, object.angularVelocity);
        QCOMPARE(body.mass, *object.mass);
        QVERIFY(body.filter == object.filter);
        QVERIFY(!body.tangible && !body.positionFrozen && !body.rotationFrozen);
        const auto connectors = built.world.connectors();
        QCOMPARE(connectors.size(), std::size_t{1});
        QCOMPARE(built.world.connector(connectors[0]).length, 1.5);
        QCOMPARE(built.world.connector(connectors[0]).a, built.bodies[0].second);
        QVERIFY((built.world.parameters() == UpdateParameters{{0.5, -2}, 0.01, 50, 4}));
    }

    void aFrozenObjectIsFrozenInPlaceAndAngle() {
        const BuiltWorld built = builtWorld(populatedLevel());
        const BodyState body = built.world.body(built.bodies[0].second);
        QVERIFY(body.positionFrozen && body.rotationFrozen);
    }

    void equalLevelsMakeEqualWorlds() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Level level = randomLevel(seed);
            QVERIFY2(builtWorld(level).world.hash() == builtWorld(level).world.hash(), std::to_string(seed).c_str());
        }
    }

    void updateParametersThatLintRejectsAreReplacedByStandardOnes() {
        Level level;
        level.gravity = {0, std::numeric_limits<double>::quiet_NaN()};
        level.updateSeconds = -1;
        level.iterations = 0;
        level.substeps = 1000000;
        const Level standard;
        QVERIFY(updateParameters(level) == updateParameters(standard));
    }
};

SPACETOW_TEST(BuildTest)
#include "build_test.moc"
