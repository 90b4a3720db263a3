#include "core/level/combine.h"

#include "core/geometry/polygon.h"
#include "core/level/arrange.h"
#include "core/level/edits.h"
#include "tests/support/body_with.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

Q_DECLARE_METATYPE(spacetow::Vec2)

namespace {

using CombineKeys = std::vector<Key>;

Object boxWith(Key key, const Vec2& position, const Vec2& size, double angle = 0) {
    BodyObject body;
    body.position = position;
    body.angle = angle;
    body.density = static_cast<double>(key);
    body.shapes = {Polygon{{{0, 0}, {size.x(), 0}, size, {0, size.y()}}}};
    return {key, "", body, {}};
}

Level boxes() {
    Level level;
    level.objects.append(boxWith(1, {0, 0}, {2, 2}));
    level.objects.append(boxWith(2, {2, 1}, {2, 1}, std::numbers::pi / 2)); // from (1, 1) to (2, 3)
    BodyObject ball;
    ball.shapes = {Circle{{0, 0}, 1}};
    level.objects.append({3, "ball", ball, {}});
    ConnectorObject rope;
    rope.a = 2;
    rope.b = 3;
    level.objects.append({4, "", rope, {}});
    level.objects.append(boxWith(5, {20, 0}, {1, 1}));
    return level;
}

double areaOf(const Level& level, Key key) {
    double area = 0;
    for (const LevelShape& shape : std::get<BodyObject>(level.objects.find(key)->data).shapes) {
        area += signedArea(std::get<Polygon>(shape).vertices);
    }
    return area;
}

} // namespace

class CombineTest : public QObject {
    Q_OBJECT

  private slots:
    void theFirstBodyTakesTheShapeAndKeepsAllElse_data() {
        QTest::addColumn<int>("how");
        QTest::addColumn<double>("area");
        QTest::addColumn<Vec2>("max");
        QTest::newRow("union") << int(PolygonBoolean::Union) << 5.0 << Vec2(2, 3);
        QTest::newRow("difference") << int(PolygonBoolean::Difference) << 3.0 << Vec2(2, 2);
        QTest::newRow("intersection") << int(PolygonBoolean::Intersection) << 1.0 << Vec2(2, 2);
    }

    void theFirstBodyTakesTheShapeAndKeepsAllElse() {
        QFETCH(int, how);
        QFETCH(double, area);
        QFETCH(Vec2, max);
        const Level before = boxes();
        const Result<CombinedBodies> result =
            combinedBodies(before, CombineKeys{1, 2}, static_cast<PolygonBoolean>(how));
        QVERIFY(bool(result));
        QCOMPARE(result.value().key, Key{1});
        const Level& level = result.value().level;
        QVERIFY(std::abs(areaOf(level, 1) - area) < 1e-9);
        QVERIFY(placedBounds(level, CombineKeys{1}).max == max);
        QCOMPARE(std::get<BodyObject>(level.objects.find(1)->data).density, 1.0);
        QVERIFY(level.objects.find(2) == nullptr && level.objects.find(4) == nullptr);
        QVERIFY(level.objects.find(3) != nullptr);
        QVERIFY(before == boxes());
    }

    /// The sliver goes through a corner of the triangle, and rounding leaves a corner of one piece on a side of it.
    void aResultThatRoundingWouldLetCrossItselfIsRefused() {
        Level level;
        level.objects.append(bodyWith(1, Polygon{{{3, 4}, {0, 4}, {0, 1}}}));
        level.objects.append(bodyWith(2, Polygon{{{0, 3}, {5, 4}, {4, 4}}}));
        const Result<CombinedBodies> result = combinedBodies(level, CombineKeys{1, 2}, PolygonBoolean::Difference);
        QVERIFY(!result);
        QCOMPARE(result.error().code.text(), std::string("combine-not-simple"));
    }

    void whatCannotBeCombinedIsRefused() {
        const auto code = [](const CombineKeys& keys, PolygonBoolean how) {
            const Result<CombinedBodies> result = combinedBodies(boxes(), keys, how);
            return result ? std::string() : std::string(result.error().code.text());
        };
        QCOMPARE(code({1}, PolygonBoolean::Union), std::string("combine-too-few"));
        QCOMPARE(code({}, PolygonBoolean::Union), std::string("combine-too-few"));
        QCOMPARE(code({1, 3}, PolygonBoolean::Union), std::string("combine-no-polygon"));
        const Result<CombinedBodies> unnamed =
            combinedBodies(renamed(boxes(), 3, ""), CombineKeys{1, 3}, PolygonBoolean::Union);
        QCOMPARE(unnamed.error().code.text(), std::string("combine-unnamed-no-polygon")); // and tells no key
        QVERIFY(unnamed.error().arguments.empty());
        QCOMPARE(code({1, 5}, PolygonBoolean::Intersection), std::string("combine-empty"));
        QCOMPARE(code({1, 5}, PolygonBoolean::Union), std::string());
        Level far = boxes();
        far.objects.append(boxWith(6, {1e9, 0}, {1, 1}));
        QCOMPARE(combinedBodies(far, CombineKeys{1, 6}, PolygonBoolean::Union).error().code.text(),
                 std::string("combine-too-far"));
    }
};

SPACETOW_TEST(CombineTest)
#include "combine_test.moc"
