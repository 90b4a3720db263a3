#include "core/geometry/bounds.h"

#include "tests/geometry/contains.h"
#include "tests/geometry/random_parts.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

bool isBox(const Aabb& box, const Vec2& min, const Vec2& max) {
    return isNear(box.min, min, 1e-12) && isNear(box.max, max, 1e-12);
}

} // namespace

class BoundsTest : public QObject {
    Q_OBJECT

  private slots:
    void boxesAreTight();
    void edgesCoverTheBandOfTheirDepth();
    void enlargedBoxesFollowTheReport();
    void shapesAndTheirPartsHaveTheSameBox();
    void nothingLiesOutside();
};

void BoundsTest::boxesAreTight() {
    const Transform pose{Vec2(2, 1), Rot::fromAngle(std::numbers::pi / 2)};
    QVERIFY(isBox(boundsOf(Shape(Circle{Vec2(1, 0), 0.5}), pose), Vec2(1.5, 1.5), Vec2(2.5, 2.5)));
    QVERIFY(isBox(boundsOf(Shape(Line{Vec2(0, 0), Vec2(1, 2)}), pose), Vec2(0, 1), Vec2(2, 2)));
    const Polygon triangle{{Vec2(0, 0), Vec2(2, 0), Vec2(0, 1)}};
    QVERIFY(isBox(boundsOf(Shape(triangle), pose), Vec2(1, 1), Vec2(2, 3)));
}

void BoundsTest::edgesCoverTheBandOfTheirDepth() {
    const Vec2 a(0, 0);
    const Vec2 b(10, 0);
    QVERIFY(isBox(boundsOf(Shape(Edge{a, b, 0}), {}), Vec2(0, 0), Vec2(10, 0)));
    QVERIFY(isBox(boundsOf(Shape(Edge{a, b, 0.15}), {}), Vec2(0, -0.15), Vec2(10, 0)));
    QVERIFY(isBox(boundsOf(Shape(Edge{a, b, noBack}), {}), Vec2(0, -10), Vec2(10, 0)));
    QVERIFY(isBox(boundsOf(Shape(Edge{b, a, 0.15}), {}), Vec2(0, 0), Vec2(10, 0.15)));
}

void BoundsTest::enlargedBoxesFollowTheReport() {
    const Edge open{Vec2(0, 0), Vec2(10, 0), noBack};
    QVERIFY(isBox(enlargedEdgeBounds(boundsOf(Shape(open), {})), Vec2(-0.61, -10.61), Vec2(10.61, 0.61)));
    const Edge thin{Vec2(0, 0), Vec2(10, 0), 0.15};
    QVERIFY(isBox(enlargedEdgeBounds(boundsOf(Shape(thin), {})), Vec2(-0.61, -0.2675), Vec2(10.61, 0.1175)));
}

void BoundsTest::shapesAndTheirPartsHaveTheSameBox() {
    Random random(3);
    Polygon wheel{regularPolygon(20, 2)};
    const std::vector<Shape> shapes{Circle{Vec2(1, 2), 0.3}, Edge{Vec2(0, 1), Vec2(3, 2), 0.4},
                                    Line{Vec2(0, 1), Vec2(3, 2)}, wheel};
    for (const Shape& shape : shapes) {
        const Transform pose = randomPose(random, 5);
        Aabb ofParts;
        for (const Part& part : partsOf(shape)) {
            ofParts.include(boundsOf(part, pose));
        }
        const Aabb box = boundsOf(shape, pose);
        QVERIFY(isBox(ofParts, box.min, box.max));
    }
}

void BoundsTest::nothingLiesOutside() {
    for (unsigned seed = 0; seed < 300; ++seed) {
        Random random(seed);
        const Part part = randomPart(random);
        const Transform pose = randomPose(random, 3);
        const Aabb box = boundsOf(part, pose);
        for (int i = 0; i < 50; ++i) {
            const Vec2 p = pose.position + randomPoint(random, 3);
            QVERIFY(!contains(part, pose, p) || box.contains(p));
        }
    }
}

SPACETOW_TEST(BoundsTest)
#include "bounds_test.moc"
