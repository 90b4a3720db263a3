#include "core/level/level_shape.h"

#include "core/level/edits.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <array>
#include <functional>

using namespace spacetow;
using namespace spacetow::test;

namespace {

ShapeList twoShapes() {
    return {Circle{{1, 2}, 3}, LineChain{{{0, 0}, {1, 0}}, false}};
}

const LevelShape* placeOf(const ShapeList& shapes) {
    return &shapes.front();
}

} // namespace

class LevelShapeTest : public QObject {
    Q_OBJECT

  private slots:
    void copiesShareTheirShapesUntilOneIsChanged() {
        const ShapeList original = twoShapes();
        ShapeList copy = original;
        QCOMPARE(placeOf(copy), placeOf(original));
        std::get<Circle>(copy[0]).radius = 5;
        QVERIFY(placeOf(copy) != placeOf(original));
        QCOMPARE(std::get<Circle>(original[0]).radius, 3.0);
        QVERIFY(!(copy == original));
        std::get<Circle>(copy.front()).radius = 3;
        QVERIFY(copy == original);
    }

    void everyWayOfChangingLeavesTheCopyAlone() {
        const std::vector<std::function<void(ShapeList&)>> changes{
            [](ShapeList& s) { s.push_back(Circle{}); },
            [](ShapeList& s) { s.emplace_back(Polygon{}); },
            [](ShapeList& s) { s.erase(s.begin()); },
            [](ShapeList& s) { s.insert(s.begin(), LevelShape(Circle{})); },
            [](ShapeList& s) { s.clear(); },
            [](ShapeList& s) { s.back() = Circle{}; },
            [](ShapeList& s) { *s.begin() = EdgeChain{}; },
            [](ShapeList& s) { static_cast<std::vector<LevelShape>&>(s).pop_back(); },
            [](ShapeList& s) { s = {}; },
        };
        for (const auto& change : changes) {
            const ShapeList original = twoShapes();
            ShapeList copy = original;
            change(copy);
            QVERIFY(original == twoShapes());
            QVERIFY(!(copy == original));
        }
    }

    void withoutShapesItIsEmpty() {
        const ShapeList none;
        QVERIFY(none.empty() && none.size() == 0 && none.begin() == none.end());
        QVERIFY(none == ShapeList(std::vector<LevelShape>()));
        ShapeList some;
        some.push_back(Circle{});
        QCOMPARE(some.size(), std::size_t{1});
    }

    void movingABodySharesItsShapes() {
        const Level before = populatedLevel();
        const auto* found = firstOf<BodyObject>(before);
        QVERIFY(found != nullptr);
        const Level after = moved(before, std::array{found->key}, Vec2(1, 2));
        const auto& a = std::get<BodyObject>(found->data);
        const auto& b = std::get<BodyObject>(after.objects.find(found->key)->data);
        QVERIFY(a.position != b.position);
        QCOMPARE(placeOf(b.shapes), placeOf(a.shapes));
    }
};

SPACETOW_TEST(LevelShapeTest)
#include "level_shape_test.moc"
