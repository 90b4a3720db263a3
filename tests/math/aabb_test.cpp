#include "core/math/aabb.h"

#include "tests/support/test_main.h"

using namespace spacetow;

class AabbTest : public QObject {
    Q_OBJECT

  private slots:
    void anEmptyBoxOverlapsNothing();
    void aBoxGrowsFromTheFirstPointOn();
    void bordersCount();
    void overlapsNeedsBothAxes();
    void grownMovesEverySide();
};

void AabbTest::anEmptyBoxOverlapsNothing() {
    const Aabb empty;
    QVERIFY(empty.isEmpty());
    QVERIFY(!empty.overlaps(empty));
    QVERIFY(!empty.overlaps({Vec2(-1e300, -1e300), Vec2(1e300, 1e300)}));
    QVERIFY(!empty.contains(Vec2(0, 0)));
    QVERIFY((Aabb{Vec2(0, 0), Vec2(1, std::nan(""))}).isEmpty());
}

void AabbTest::aBoxGrowsFromTheFirstPointOn() {
    Aabb box;
    box.include(Vec2(5, 7)); // the origin plays no part
    QCOMPARE(box.min, Vec2(5, 7));
    QCOMPARE(box.max, Vec2(5, 7));
    box.include(Vec2(4, 9));
    QCOMPARE(box.min, Vec2(4, 7));
    QCOMPARE(box.max, Vec2(5, 9));
    box.include(Aabb{});
    QCOMPARE(box.size(), Vec2(1, 2));
    box.include(Aabb{Vec2(0, 0), Vec2(1, 1)});
    QCOMPARE(box.min, Vec2(0, 0));
    QCOMPARE(box.center(), Vec2(2.5, 4.5));
}

void AabbTest::bordersCount() {
    const Aabb box{Vec2(0, 0), Vec2(2, 1)};
    QVERIFY(box.overlaps({Vec2(2, 1), Vec2(3, 3)}));
    QVERIFY(box.contains(Vec2(2, 0.5)));
    QVERIFY(!box.contains(Vec2(2.001, 0.5)));
    QVERIFY(box.contains(box));
    QVERIFY(!box.contains(box.grown(0.001)));
}

void AabbTest::overlapsNeedsBothAxes() {
    const Aabb box{Vec2(0, 0), Vec2(2, 1)};
    QVERIFY(!box.overlaps({Vec2(0, 2), Vec2(2, 3)}));
    QVERIFY(!box.overlaps({Vec2(3, 0), Vec2(4, 1)}));
    QVERIFY(box.overlaps({Vec2(-1, -1), Vec2(5, 5)}));
    QVERIFY((Aabb{Vec2(-1, -1), Vec2(5, 5)}).overlaps(box));
}

void AabbTest::grownMovesEverySide() {
    const Aabb box = Aabb{Vec2(0, 0), Vec2(2, 1)}.grown(0.5);
    QCOMPARE(box.min, Vec2(-0.5, -0.5));
    QCOMPARE(box.max, Vec2(2.5, 1.5));
}

SPACETOW_TEST(AabbTest)
#include "aabb_test.moc"
