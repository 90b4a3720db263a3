#include "core/level/object_geometry.h"

#include "core/base/random.h"
#include "core/level/bounds.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "core/level/outline.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double quarter = std::numbers::pi / 2;
using KeyList = std::vector<Key>;

Object triangle(const Vec2& position) {
    BodyObject body;
    body.position = position;
    body.shapes = {Polygon{{{0, 0}, {3, 0}, {0, 1}}}};
    return {1, "triangle", body, {}};
}

Level with(Object object) {
    Level level;
    level.objects.append(std::move(object));
    return level;
}

std::vector<Vec2> corners(const Level& level) {
    return Outlines(level).of(level.objects[0]).paths.front().points;
}

double signedAreaOf(const std::vector<Vec2>& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        sum += cross(points[i], points[(i + 1) % points.size()]);
    }
    return sum / 2;
}

} // namespace

class ObjectGeometryTest : public QObject {
    Q_OBJECT

  private slots:
    void fourQuarterTurnsGiveEveryBitBack() {
        for (const double angle : {0.0, 0.3, -2.0, 1.234567}) {
            Level level = with(triangle({0.25, 0.5}));
            Object object = level.objects[0];
            std::get<BodyObject>(object.data).angle = angle;
            level = withObject(std::move(level), object);
            const std::string before = levelText(level);
            for (int i = 0; i < 4; ++i) {
                level = rotated(std::move(level), KeyList{1}, {1.25, 0.75}, quarter);
            }
            QCOMPARE(levelText(level), before);
        }
    }

    void aQuarterTurnAboutAGridPointKeepsThePlaceOnTheGrid() {
        const Level level = rotated(with(triangle({0.25, 0.5})), KeyList{1}, {1.25, 0.75}, quarter);
        QVERIFY((std::get<BodyObject>(level.objects[0].data).position == Vec2(1.5, -0.25)));
    }

    void mappingMovesEveryPointOfAnOutlineAsTheMapDoes() {
        Random random(5);
        for (int i = 0; i < 500; ++i) {
            Object object = triangle({random.uniform(-5, 5), random.uniform(-5, 5)});
            std::get<BodyObject>(object.data).angle = random.uniform(-3, 3);
            const Level before = with(object);
            const Affine map{{random.uniform(-2, 2), random.uniform(-2, 2)},
                             {random.uniform(-2, 2), random.uniform(-2, 2)},
                             {random.uniform(-9, 9), random.uniform(-9, 9)}};
            if (std::abs(map.determinant()) < 0.1) {
                continue;
            }
            std::vector<Vec2> expected = corners(before);
            for (Vec2& corner : expected) {
                corner = map(corner);
            }
            const std::vector<Vec2> found = corners(transformed(before, KeyList{1}, map));
            for (const Vec2& corner : expected) {
                QVERIFY(std::ranges::any_of(found, [&](const Vec2& p) { return (p - corner).norm() < 1e-8; }));
            }
            // Mirrored polygons stay anticlockwise, mirrored walls solid on the same side.
            QVERIFY(signedAreaOf(found) > 0);
        }
    }

    void mirroringTwiceGivesEveryBitBack() {
        Object object = triangle({0.25, 0.5});
        std::get<BodyObject>(object.data).angle = 0.7;
        std::get<BodyObject>(object.data).shapes.emplace_back(EdgeChain{{{0, 0}, {1, 0.1}, {2, 0}}, true, 0.5});
        const Level before = with(object);
        const Affine flip = Affine::scaling({1, 2}, {-1, 1});
        const Level once = transformed(before, KeyList{1}, flip);
        QVERIFY(!(once == before));
        QCOMPARE(levelText(transformed(once, KeyList{1}, flip)), levelText(before));
    }

    void mirroringTheShipTurnsItsNoseRound() {
        const Level before = with({1, "", ShipObject{{1, 2}, 0.5}, {}});
        const Level after = transformed(before, KeyList{1}, Affine::scaling({0, 0}, {-1, 1}));
        QVERIFY((std::get<ShipObject>(after.objects[0].data) == ShipObject{{-1, 2}, -0.5}));
    }

    void scalingKeepsAnglesAndGrowsShapes() {
        Object object = triangle({1, 1});
        const Level after = transformed(with(object), KeyList{1}, Affine::scaling({0, 0}, {2, 3}));
        const auto& body = std::get<BodyObject>(after.objects[0].data);
        QVERIFY((body.position == Vec2(2, 3)));
        QCOMPARE(body.angle, 0.0);
        QVERIFY((body.shapes[0] == LevelShape(Polygon{{{0, 0}, {6, 0}, {0, 3}}})));
    }

    void theAnchorsOfAConnectorGoWithItsBodies() {
        Level level;
        BodyObject body;
        body.angle = 0.4;
        body.shapes = {Circle{{0, 0}, 1}};
        level.objects.append({1, "", body, {}});
        body.position = {5, 0};
        level.objects.append({2, "", body, {}});
        ConnectorObject connector;
        connector.a = 1;
        connector.b = 2;
        connector.anchorA = {0.5, 0.25};
        level.objects.append({3, "", connector, {}});
        const auto anchors = [](const Level& of) { return Outlines(of).of(of.objects[2]).paths.front().points; };
        const Affine map = Affine::scaling({1, 1}, {-2, 1.5});
        const std::vector<Vec2> before = anchors(level);
        const std::vector<Vec2> after = anchors(transformed(level, KeyList{1, 2}, map));
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY((after[i] - map(before[i])).norm() < 1e-9);
        }
    }

    void boundsAreThoseOfTheOutline() {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const Level level = randomLevel(seed, 20);
            const Outlines outlines(level);
            for (const Object& object : level.objects) {
                const Aabb box = ownBounds(object.data);
                if (!box.isEmpty()) {
                    const Aabb exact = spacetow::boundsOf(outlines.of(object));
                    QVERIFY2(box.min == exact.min && box.max == exact.max, qPrintable(QString::number(seed)));
                }
            }
        }
    }

    void tidyingTouchesRoundingErrorsOnly() {
        QCOMPARE(tidied(0.1 + 0.2), 0.3);
        QCOMPARE(tidied(1.0 / 3), 1.0 / 3);
        QVERIFY(!std::signbit(tidied(-1e-17)));
        QVERIFY(std::isinf(tidied(noBack)));
    }
};

SPACETOW_TEST(ObjectGeometryTest)
#include "object_geometry_test.moc"
