#include "editor/editing/viewport.h"

#include "core/base/random.h"
#include "tests/support/test_main.h"

#include <limits>

using namespace spacetow;

namespace {

Viewport randomView(Random& random) {
    Viewport view;
    view.center = {random.uniform(-100, 100), random.uniform(-100, 100)};
    view.scale = std::exp(random.uniform(std::log(Viewport::minScale), std::log(Viewport::maxScale)));
    view.size = {random.uniform(50, 3000), random.uniform(50, 2000)};
    return view;
}

} // namespace

class ViewportTest : public QObject {
    Q_OBJECT

  private slots:
    void upInTheWorldIsUpOnTheScreen();
    void screenAndWorldAreInverse();
    void zoomingKeepsThePointUnderThePointer();
    void theScaleStaysWithinItsLimits_data();
    void theScaleStaysWithinItsLimits();
    void panningMovesTheWorldWithThePointer();
    void theVisibleBoxReachesTheCorners();
    void aBoxIsShownWholeAndCentred();
    void aBoxWithoutExtentKeepsTheUsualScale();
    void anEmptyBoxGivesTheDefaultView();
};

void ViewportTest::upInTheWorldIsUpOnTheScreen() {
    Viewport view;
    view.scale = 10;
    view.size = {200, 100};
    QCOMPARE(view.toScreen({0, 0}).x(), 100.0);
    QCOMPARE(view.toScreen({0, 0}).y(), 50.0);
    QCOMPARE(view.toScreen({1, 2}).x(), 110.0);
    QCOMPARE(view.toScreen({1, 2}).y(), 30.0);
}

void ViewportTest::screenAndWorldAreInverse() {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Random random(seed);
        const Viewport view = randomView(random);
        const Vec2 screen(random.uniform(-10, 3000), random.uniform(-10, 3000));
        const double error = (view.toScreen(view.toWorld(screen)) - screen).norm();
        QVERIFY2(error < 1e-6, qPrintable(QString("seed %1: %2 pixels off").arg(seed).arg(error)));
    }
}

void ViewportTest::zoomingKeepsThePointUnderThePointer() {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Random random(seed);
        const Viewport view = randomView(random);
        const Vec2 screen(random.uniform(0, view.size.x()), random.uniform(0, view.size.y()));
        const Viewport zoomed = view.zoomedAt(screen, random.uniform(0.05, 20));
        const double error = (zoomed.toScreen(view.toWorld(screen)) - screen).norm();
        QVERIFY2(error < 1e-5, qPrintable(QString("seed %1: %2 pixels off").arg(seed).arg(error)));
    }
}

void ViewportTest::theScaleStaysWithinItsLimits_data() {
    QTest::addColumn<double>("factor");
    QTest::addColumn<double>("scale");

    QTest::newRow("in") << 1e9 << Viewport::maxScale;
    QTest::newRow("out") << 1e-9 << Viewport::minScale;
    QTest::newRow("infinitely") << std::numeric_limits<double>::infinity() << Viewport::maxScale;
    QTest::newRow("by nothing") << 0.0 << 66.0;
    QTest::newRow("by less than nothing") << -2.0 << 66.0;
    QTest::newRow("by no number") << std::numeric_limits<double>::quiet_NaN() << 66.0;
}

void ViewportTest::theScaleStaysWithinItsLimits() {
    QFETCH(double, factor);
    QFETCH(double, scale);
    const Viewport zoomed = Viewport().zoomedAt({10, 20}, factor);
    QCOMPARE(zoomed.scale, scale);
    QVERIFY(isFinite(zoomed.center));
}

void ViewportTest::panningMovesTheWorldWithThePointer() {
    const Viewport view;
    const Vec2 world = view.toWorld({300, 200});
    const Vec2 after = view.panned({30, -50}).toScreen(world);
    QVERIFY((after - Vec2(330, 150)).norm() < 1e-9);
}

void ViewportTest::theVisibleBoxReachesTheCorners() {
    const Viewport view;
    const Aabb box = view.visible();
    QVERIFY((view.toScreen(box.min) - Vec2(0, view.size.y())).norm() < 1e-9);
    QVERIFY((view.toScreen(box.max) - Vec2(view.size.x(), 0)).norm() < 1e-9);
}

void ViewportTest::aBoxIsShownWholeAndCentred() {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Random random(seed);
        const Viewport view = randomView(random);
        Aabb box;
        box.include(Vec2(random.uniform(-50, 50), random.uniform(-50, 50)));
        box.include(Vec2(random.uniform(-50, 50), random.uniform(-50, 50)));
        const Viewport shown = view.showing(box);
        QVERIFY2(shown.size == view.size && (shown.center - box.center()).norm() < 1e-12,
                 qPrintable(QString::number(seed)));
        const Vec2 share = (box.size() * shown.scale).cwiseQuotient(view.size);
        const bool limited = shown.scale == Viewport::minScale || shown.scale == Viewport::maxScale;
        QVERIFY2(limited || (share.maxCoeff() < 1 && share.maxCoeff() > 0.75), qPrintable(QString::number(seed)));
    }
}

void ViewportTest::aBoxWithoutExtentKeepsTheUsualScale() {
    const Viewport shown = Viewport().showing({{3, 4}, {3, 4}});
    QVERIFY(shown.center == Vec2(3, 4));
    QCOMPARE(shown.scale, Viewport().scale);
}

void ViewportTest::anEmptyBoxGivesTheDefaultView() {
    Viewport moved;
    moved.center = {5, 6};
    moved.scale = 3;
    moved.size = {300, 200};
    const Viewport shown = moved.showing({});
    QVERIFY(shown.center == Vec2(0, 0));
    QCOMPARE(shown.scale, Viewport().scale);
    QVERIFY(shown.size == Vec2(300, 200));
}

SPACETOW_TEST(ViewportTest)
#include "viewport_test.moc"
