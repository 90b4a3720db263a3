#include "core/math/view_transform.h"

#include "tests/support/test_main.h"

using namespace spacetow;

class ViewTransformTest : public QObject {
    Q_OBJECT

  private slots:
    void yIsTurnedOverAndTheMiddleStaysInTheMiddle() {
        const ViewTransform view{.center = {10, 5}, .scale = 64, .size = {800, 600}};
        QVERIFY(view.toView(Vec2(10, 5)) == Vec2(400, 300));
        QVERIFY(view.toView(Vec2(11, 7)) == Vec2(464, 172));
        const Aabb box = view.toView(Aabb{{9, 4}, {11, 7}});
        QVERIFY(box.min == Vec2(336, 172) && box.max == Vec2(464, 364));
        QCOMPARE(view.toView(2.0), 128.0);
    }

    void thereAndBackAgainIsTheSamePlace() {
        const ViewTransform view{.center = {-3, 8}, .scale = 17.5, .size = {1600, 600}};
        for (const Vec2& p : {Vec2(0, 0), Vec2(-40, 3), Vec2(1e6, -1e6)}) {
            QVERIFY((view.toWorld(view.toView(p)) - p).norm() < 1e-9);
        }
    }

    void aBoxFitsWholeAndInTheMiddle_data() {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::newRow("same shape") << 400.0 << 200.0;
        QTest::newRow("wide") << 1600.0 << 600.0;
        QTest::newRow("tall") << 300.0 << 900.0;
    }
    void aBoxFitsWholeAndInTheMiddle() {
        QFETCH(double, width);
        QFETCH(double, height);
        const Aabb box{{-7, 3}, {1, 7}};
        const Aabb seen = ViewTransform::fitting(box, {width, height}).toView(box);
        QVERIFY(Aabb({{0, 0}, {width, height}}).grown(1e-9).contains(seen));
        QVERIFY((seen.center() - Vec2(width / 2, height / 2)).norm() < 1e-9);
        QVERIFY(std::abs(seen.size().x() - 2 * seen.size().y()) < 1e-9);
        QVERIFY(seen.size().x() > width - 1e-9 || seen.size().y() > height - 1e-9);
    }
};

SPACETOW_TEST(ViewTransformTest)
#include "view_transform_test.moc"
