#include "editor/editing/snap.h"

#include "core/base/random.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <numbers>

using namespace spacetow;

namespace {

Pointer pointerAt(const Vec2& world, Modifiers modifiers = {}) {
    return {world, {0, 0}, modifiers, 0.01};
}

constexpr Modifiers withShift{true, false, false};
constexpr Modifiers withCtrl{false, true, false};
constexpr Modifiers withBoth{true, true, false};

double angleOf(const Vec2& v) {
    return std::atan2(v.y(), v.x()) * 180 / std::numbers::pi;
}

} // namespace

class SnapTest : public QObject {
    Q_OBJECT

  private slots:
    void aPointLandsOnTheGrid_data();
    void aPointLandsOnTheGrid();
    void gridNumbersAreTheOnesThatPeopleWrite();
    void shiftKeepsToMultiplesOfFifteenDegrees();
    void shiftOnTheGridEndsOnAGridLine();
    void axesAndDiagonalsStayOnTheGrid();
    void withoutShiftTheStartDoesNotMatter();
};

void SnapTest::aPointLandsOnTheGrid_data() {
    QTest::addColumn<bool>("grid");
    QTest::addColumn<bool>("inverted");
    QTest::addColumn<double>("step");
    QTest::addColumn<double>("expected");

    QTest::newRow("on") << true << false << 0.25 << 1.25;
    QTest::newRow("off") << false << false << 0.25 << 1.2;
    QTest::newRow("inverted to off") << true << true << 0.25 << 1.2;
    QTest::newRow("inverted to on") << false << true << 0.25 << 1.25;
    QTest::newRow("no step") << true << false << 0.0 << 1.2;
    QTest::newRow("coarse") << true << false << 5.0 << 0.0;
}

void SnapTest::aPointLandsOnTheGrid() {
    QFETCH(bool, grid);
    QFETCH(bool, inverted);
    QFETCH(double, step);
    QFETCH(double, expected);
    SnapSettings settings{grid, step};
    settings.smart = false;
    const Vec2 point = snapped(settings, pointerAt({1.2, -1.2}, {false, inverted, false}));
    QCOMPARE(point.x(), expected);
    QCOMPARE(point.y(), -expected);
    QVERIFY(!std::signbit(point.y()) || point.y() < 0);
}

void SnapTest::gridNumbersAreTheOnesThatPeopleWrite() {
    QVERIFY(onGrid({true, 0.1}, 0.31) == 0.3);
    QVERIFY(onGrid({true, 0.1}, 0.69) == 0.7);
    QVERIFY(onGrid({true, 0.3}, 0.88) == 3 * 0.3);
    QVERIFY(!std::signbit(onGrid({true, 0.25}, -0.1)));
}

void SnapTest::shiftKeepsToMultiplesOfFifteenDegrees() {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Random random(seed);
        const Vec2 from(random.uniform(-5, 5), random.uniform(-5, 5));
        const Vec2 to(random.uniform(-5, 5), random.uniform(-5, 5));
        const bool grid = random.below(2) == 0;
        const Vec2 point = snappedFrom({grid, 0.25}, pointerAt(to, withShift), from);
        if ((point - from).norm() < 0.1) {
            continue;
        }
        const double steps = angleOf(point - from) / 15;
        QVERIFY2(std::abs(steps - std::round(steps)) < 1e-6, qPrintable(QString("seed %1").arg(seed)));
        const double turn = std::remainder(angleOf(point - from) - angleOf(to - from), 360);
        QVERIFY2(std::abs(turn) <= 7.5 + 1e-6, qPrintable(QString("seed %1: %2°").arg(seed).arg(turn)));
        if (!grid) {
            // The foot of the perpendicular from the pointer: no other point that way is nearer.
            QVERIFY(std::abs((to - point).dot(point - from)) < 1e-9);
        }
    }
}

void SnapTest::shiftOnTheGridEndsOnAGridLine() {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Random random(seed);
        const Vec2 from(random.uniform(-5, 5), random.uniform(-5, 5));
        const Vec2 to(random.uniform(-5, 5), random.uniform(-5, 5));
        const Vec2 point = snappedFrom({true, 0.25}, pointerAt(to, withShift), from);
        const auto offGrid = [](double x) { return std::abs(x * 4 - std::round(x * 4)); };
        QVERIFY2(std::min(offGrid(point.x()), offGrid(point.y())) < 1e-9, qPrintable(QString("seed %1").arg(seed)));
    }
}

void SnapTest::axesAndDiagonalsStayOnTheGrid() {
    const Vec2 from(0.5, -1.25);
    for (const Vec2& to : {Vec2(3.1, -1.2), Vec2(0.6, 4.3), Vec2(-2.1, -1.3), Vec2(0.45, -7.3), Vec2(3.1, 1.3),
                           Vec2(-2.1, 1.2), Vec2(-3.3, -5.1), Vec2(2.2, -3.1)}) {
        const Vec2 point = snappedFrom({true, 0.25}, pointerAt(to, withShift), from);
        QVERIFY(point == onGrid({true, 0.25}, point));
        QVERIFY((point - to).norm() < 0.5);
    }
    const Vec2 free = snappedFrom({true, 0.25}, pointerAt({3.1, -1.2}, withBoth), from);
    QVERIFY(free == Vec2(3.1, -1.25));
}

void SnapTest::withoutShiftTheStartDoesNotMatter() {
    QVERIFY(snappedFrom({true, 0.25}, pointerAt({1.2, 0.4}), {9, 9}) == Vec2(1.25, 0.5));
    QVERIFY(snappedFrom({true, 0.25}, pointerAt({1.2, 0.4}, withCtrl), {9, 9}) == Vec2(1.2, 0.4));
}

SPACETOW_TEST(SnapTest)
#include "snap_test.moc"
