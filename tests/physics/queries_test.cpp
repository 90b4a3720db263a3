#include "core/base/random.h"
#include "core/geometry/polygon.h"
#include "core/physics/query/queries.h"
#include "tests/support/bodies.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Vec2 randomPoint(Random& random) {
    return {random.uniform(-5, 5), random.uniform(-5, 5)};
}

/// Circles and regular polygons at random places, turned at random.
World randomWorld(Random& random) {
    World world;
    for (int i = 0; i < 12; ++i) {
        BodyDef def = ball(randomPoint(random), random.uniform(0.1, 1));
        if (random.below(2) == 0) {
            def.shapes = {
                Polygon{regularPolygon(3 + static_cast<int>(random.below(8)), std::get<Circle>(def.shapes[0]).radius)}};
        }
        def.kind = random.below(2) == 0 ? BodyKind::Static : BodyKind::Dynamic;
        def.angle = random.uniform(-3, 3);
        add(world, def);
    }
    return world;
}

} // namespace

class QueriesTest : public QObject {
    Q_OBJECT

  private slots:
    void theQuadtreeCellsKnowHowManyBoxesTheyHold() {
        World world;
        QVERIFY(std::ranges::all_of(occupiedCells(world), [](const QuadtreeCell& cell) { return cell.held == 0; }));
        BodyDef post = ball({0, 0}, 0.5);
        post.kind = BodyKind::Static;
        for (int i = 0; i < 40; ++i) {
            post.position = Vec2(3.0 * i, 0);
            add(world, post);
        }
        world.update();
        int most = 0;
        int sum = 0;
        for (const QuadtreeCell& cell : occupiedCells(world)) {
            most = std::max(most, cell.held);
            sum += cell.held;
        }
        QVERIFY(sum >= 40 && most >= 1 && most < 40); // each somewhere, and not all in one
        QVERIFY(occupiedCells(world, Aabb{{30, -1}, {33, 1}}).size() < occupiedCells(world).size());
        QVERIFY(occupiedCells(world, Aabb{{-9, -1}, {-8, 1}}).empty());
    }

    void theQuadtreeCellsCoverEveryBody() {
        World world = [] {
            Random random(5);
            return randomWorld(random);
        }();
        world.update();
        const std::vector<QuadtreeCell> cells = occupiedCells(world);
        QVERIFY(!cells.empty());
        for (const BodyId id : world.bodies()) {
            const Vec2 at = world.body(id).massCenter;
            QVERIFY(std::any_of(cells.begin(), cells.end(),
                                [&](const QuadtreeCell& cell) { return cell.box.contains(at); }));
        }
    }
};

SPACETOW_TEST(QueriesTest)
#include "queries_test.moc"
