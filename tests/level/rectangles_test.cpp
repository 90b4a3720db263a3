#include "core/level/rectangles.h"

#include "core/level/object_geometry.h"
#include "tests/support/body_with.h"
#include "tests/support/test_main.h"

#include <array>
#include <cmath>
#include <numbers>

using namespace spacetow;
using spacetow::test::bodyWith;

namespace {

/// Corners of a rectangle of 3 m × 1 m whose lower left one is there.
Polygon plank(const Vec2& at = {0, 0}) {
    return {{at, at + Vec2(3, 0), at + Vec2(3, 1), at + Vec2(0, 1)}};
}

Level plankLevel(const Vec2& corner, double angle) {
    Object object = bodyWith(1, plank(corner), {5, -2});
    std::get<BodyObject>(object.data).angle = angle;
    Level level;
    level.objects.append(object);
    return level;
}

FieldEdit sizeTo(const char* id, double value) {
    return {id, [value](const FieldValue&) { return std::optional(FieldValue(value)); }};
}

Vec2 middleOf(const Object& object) {
    const auto& body = std::get<BodyObject>(object.data);
    const auto& corners = std::get<Polygon>(body.shapes.front()).vertices;
    return poseOf(object)->toWorld(0.5 * (corners[0] + corners[2]));
}

} // namespace

class RectanglesTest : public QObject {
    Q_OBJECT

  private slots:
    void whatHasFourRightAnglesHasAWidthAndAHeight() {
        QCOMPARE(rectangleSize(bodyWith(1, plank())), std::optional(Vec2(3, 1)));
        const Polygon fromElsewhere{{{3, 1}, {3, 0}, {0, 0}, {0, 1}}}; // the other way round, from another corner
        QCOMPARE(rectangleSize(bodyWith(1, fromElsewhere)), std::optional(Vec2(3, 1)));
        const Polygon upright{{{0, 0}, {1, 0}, {1, 3}, {0, 3}}};
        QCOMPARE(rectangleSize(bodyWith(1, upright)), std::optional(Vec2(1, 3)));
        QVERIFY(!rectangleSize(bodyWith(1, Polygon{{{0, 0}, {3, 0}, {4, 1}, {1, 1}}}))); // sheared
        QVERIFY(!rectangleSize(bodyWith(1, Polygon{{{0, 0}, {3, 0}, {3, 1}}})));
        QVERIFY(!rectangleSize(bodyWith(1, Polygon{{{0, 0}, {0, 0}, {3, 0}, {3, 0}}})));
        QVERIFY(!rectangleSize(bodyWith(1, EdgeChain{plank().vertices, true, 1})));
        QVERIFY(!rectangleSize({1, "", ShipObject{}, {}}));
    }

    void aNewSizeLeavesMiddleAndAngle_data() {
        QTest::addColumn<double>("cornerX");
        QTest::addColumn<double>("angle");
        QTest::newRow("origin in the middle") << -1.5 << 0.0;
        QTest::newRow("origin at a corner") << 0.0 << 0.0;
        QTest::newRow("turned") << -1.5 << 0.7;
        QTest::newRow("turned, origin elsewhere") << 4.0 << -2.0;
        QTest::newRow("a quarter") << 0.0 << 0.5 * std::numbers::pi;
    }
    void aNewSizeLeavesMiddleAndAngle() {
        QFETCH(double, cornerX);
        QFETCH(double, angle);
        const Level level = plankLevel({cornerX, -0.5}, angle);
        FieldEditResult result = withSizeEdited(level, std::array{Key{1}}, sizeTo("width", 0.3));
        QCOMPARE(result.changed, 1);
        result = withSizeEdited(result.level, std::array{Key{1}}, sizeTo("height", 2.1));
        const Object& after = *result.level.objects.find(1);
        QCOMPARE(rectangleSize(after), std::optional(Vec2(0.3, 2.1))); // to the last bit
        QVERIFY((middleOf(after) - middleOf(level.objects[0])).norm() < 1e-9);
        QCOMPARE(std::get<BodyObject>(after.data).angle, angle);
    }

    void oneThatStandsAtHalfARightAngleKeepsItsOtherSide() {
        for (int i = 0; i < 200; ++i) { // rounding makes one side lean more than the other
            Level level;
            const Vec2 along(std::sqrt(0.5), std::sqrt(0.5)), across(-along.y(), along.x());
            const Vec2 corner(0.01 * i, 0.37 * i);
            Polygon polygon;
            for (const Vec2& at : {Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(0, 1)}) {
                polygon.vertices.push_back(tidied(Vec2(corner + at.x() * along + at.y() * across)));
            }
            level.objects.append(bodyWith(1, polygon));
            const FieldEditResult result = withSizeEdited(level, std::array{Key{1}}, sizeTo("width", 3));
            const Vec2 size = rectangleSize(*result.level.objects.find(1)).value_or(Vec2(0, 0));
            QVERIFY2((size - Vec2(3, 1)).norm() < 1e-6, qPrintable(QString::number(i)));
        }
    }

    void aSizeThatRoundingWouldTakeAwayIsRefused() {
        const Level level = plankLevel({-1.5, -0.5}, 0);
        for (const double extent : {1e-17, 1e-9, 9e-7}) {
            const FieldEditResult result = withSizeEdited(level, std::array{Key{1}}, sizeTo("width", extent));
            QCOMPARE(result.refused, 1);
            QVERIFY(result.level == level);
        }
        const FieldEditResult least = withSizeEdited(level, std::array{Key{1}}, sizeTo("width", 1e-6));
        QVERIFY(rectangleSize(*least.level.objects.find(1)).has_value());
    }

    void connectorsGoWithTheirCorners() {
        Level level = plankLevel({-1.5, -0.5}, 0);
        level.objects.append(bodyWith(2, Circle{{0, 0}, 1}));
        ConnectorObject rope;
        rope.a = 1;
        rope.b = 2;
        rope.anchorA = {1.5, 0.5};
        level.objects.append({3, "", rope, {}});
        const FieldEditResult result = withSizeEdited(level, std::array{Key{1}}, sizeTo("width", 6));
        QCOMPARE(std::get<ConnectorObject>(result.level.objects[2].data).anchorA, Vec2(3, 0.5));
    }

    void whatIsNoSizeIsRefusedAndWhatIsNoRectangleStays() {
        Level level = plankLevel({0, 0}, 0);
        level.objects.append(bodyWith(2, Circle{{0, 0}, 1}));
        const std::array keys{Key{1}, Key{2}};
        for (const double value : {0.0, -1.0, 2e6}) {
            QCOMPARE(withSizeEdited(level, keys, sizeTo("width", value)).refused, 1);
        }
        const FieldEditResult result = withSizeEdited(level, keys, sizeTo("width", 3));
        QCOMPARE(result.changed, 0);
        QVERIFY(result.level == level);
    }

    void severalRectanglesAreSurveyedTogether() {
        SizeSurvey survey;
        survey.add(bodyWith(1, Circle{{0, 0}, 1}));
        QVERIFY(survey.summaries().empty());
        survey.add(bodyWith(2, plank()));
        survey.add(bodyWith(3, Polygon{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}));
        const std::vector<FieldSummary> sizes = survey.summaries();
        QCOMPARE(sizes.size(), std::size_t{2});
        QVERIFY(sizes[0].id == "width" && sizes[0].isMixed && sizes[0].count == 2);
        QVERIFY(sizes[1].id == "height" && !sizes[1].isMixed && sizes[1].value == FieldValue(1.0));
    }
};

SPACETOW_TEST(RectanglesTest)
#include "rectangles_test.moc"
