#include "core/level/guides.h"

#include "tests/support/test_main.h"

#include <cmath>
#include <numbers>

using namespace spacetow;

namespace {

constexpr double pi = std::numbers::pi;

Guide guideAt(double x, double y, double angle) {
    Guide guide;
    guide.point = Vec2(x, y);
    guide.angle = angle;
    return guide;
}

Level guidedLevel(std::initializer_list<Guide> guides) {
    Level level;
    level.guides = guides;
    return level;
}

} // namespace

class GuidesTest : public QObject {
    Q_OBJECT

  private slots:
    void levelAndUprightGuidesAreExact() {
        for (const double angle : {0.0, pi, -pi, 2 * pi}) {
            QCOMPARE(directionOf(guideAt(0, 0, angle)).y(), 0.0);
            QCOMPARE(footOn(guideAt(1, 0.1, angle), Vec2(0.3, 7)), Vec2(0.3, 0.1));
        }
        for (const double angle : {pi / 2, -pi / 2, 3 * pi / 2}) {
            QCOMPARE(directionOf(guideAt(0, 0, angle)).x(), 0.0);
            QCOMPARE(footOn(guideAt(0.1, 1, angle), Vec2(7, 0.3)), Vec2(0.1, 0.3));
        }
    }

    void theFootIsTheNearestPointOfTheLine() {
        const Guide guide = guideAt(1, 2, 0.7);
        const Vec2 point(-3, 5);
        const Vec2 foot = footOn(guide, point);
        QVERIFY(distanceTo(guide, foot) < 1e-12);
        QVERIFY(std::abs((point - foot).norm() - distanceTo(guide, point)) < 1e-12);
        for (const double off : {-0.1, 0.1}) {
            QVERIFY((foot + off * directionOf(guide) - point).norm() > distanceTo(guide, point));
        }
    }

    void theDistanceIsThatFromALineWithoutEnds() {
        const Guide slope = guideAt(0, 0, pi / 4);
        QVERIFY(std::abs(distanceTo(slope, Vec2(1000, 1000))) < 1e-9);
        QVERIFY(std::abs(distanceTo(slope, Vec2(1, 0)) - std::sqrt(0.5)) < 1e-12);
    }

    void editsLeaveTheLevelTheyStartFrom() {
        const Level before = guidedLevel({guideAt(0, 1, 0), guideAt(2, 0, pi / 2)});
        const Level copy = before;
        QCOMPARE(guideAdded(before, guideAt(5, 5, 1)).guides.size(), std::size_t{3});
        QVERIFY(guideReplaced(before, 1, guideAt(9, 9, 0)).guides[1] == guideAt(9, 9, 0));
        QVERIFY(guideRemoved(before, 0).guides == std::vector{guideAt(2, 0, pi / 2)});
        QVERIFY(guidesCleared(before).guides.empty());
        QVERIFY(before == copy);
    }

    void aGuideThatIsNotThereChangesNothing() {
        const Level level = guidedLevel({guideAt(0, 1, 0)});
        QVERIFY(guideReplaced(level, 1, guideAt(9, 9, 0)) == level);
        QVERIFY(guideRemoved(level, 1) == level);
        QVERIFY(guidesCleared(Level()) == Level());
    }
};

SPACETOW_TEST(GuidesTest)
#include "guides_test.moc"
