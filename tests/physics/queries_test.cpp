#include "core/base/random.h"
#include "core/geometry/polygon.h"
#include "core/physics/query/queries.h"
#include "tests/support/bodies.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <cstdlib>

using namespace spacetow;
using namespace spacetow::test;

namespace {

int queryScenes() {
    return std::getenv("SPACETOW_FULL") != nullptr ? 10000 : 500;
}

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

bool covers(const World& world, BodyId id, const Vec2& point) {
    const Vec2 local = world.body(id).pose.toLocal(point);
    const Shape& shape = world.shapes(id).front();
    if (const auto* circle = std::get_if<Circle>(&shape)) {
        return (local - circle->center).norm() <= circle->radius;
    }
    return contains(std::get<Polygon>(shape).vertices, local);
}

} // namespace

class QueriesTest : public QObject {
    Q_OBJECT

  private slots:
    void pointQueriesAgreeWithEveryShape() {
        for (int seed = 1; seed <= queryScenes(); ++seed) {
            Random random(static_cast<std::uint64_t>(seed));
            const World world = randomWorld(random);
            const Vec2 point = randomPoint(random);
            std::vector<BodyId> expected;
            for (const BodyId id : world.bodies()) {
                if (covers(world, id, point)) {
                    expected.push_back(id);
                }
            }
            QVERIFY2(bodiesAt(world, point) == expected, qPrintable(QString("seed %1").arg(seed)));
        }
    }

    void aRayStopsWhereMarchingAlongItFirstEntersABody() {
        for (int seed = 1; seed <= queryScenes(); ++seed) {
            Random random(static_cast<std::uint64_t>(seed));
            const World world = randomWorld(random);
            const Vec2 from = randomPoint(random);
            const Vec2 to = randomPoint(random);
            if (!bodiesAt(world, from).empty()) {
                continue;
            }
            double entered = 2;
            for (int i = 1; i <= 2000 && entered > 1; ++i) {
                if (!bodiesAt(world, from + i / 2000.0 * (to - from)).empty()) {
                    entered = i / 2000.0;
                }
            }
            const std::optional<RayHit> hit = rayCast(world, from, to);
            if (entered <= 1) {
                QVERIFY2(hit.has_value(), qPrintable(QString("seed %1: nothing hit").arg(seed)));
                QVERIFY2(hit->fraction <= entered + 1e-9, qPrintable(QString("seed %1: late").arg(seed)));
            }
            if (hit) { // nothing lies before the hit, and the hit lies on its body's outline
                QVERIFY2(bodiesAt(world, from + (hit->fraction - 1e-6) * (to - from)).empty() || hit->fraction < 1e-6,
                         qPrintable(QString("seed %1: something lies before").arg(seed)));
                QVERIFY2(covers(world, hit->body, hit->point - 1e-9 * hit->normal),
                         qPrintable(QString("seed %1: not on the outline").arg(seed)));
                QVERIFY(hit->normal.dot(to - from) <= 0);
            }
        }
    }

    void aRayMeetsAnEdgeFromTheFrontOnlyAndSkipsOtherTags() {
        World world;
        BodyDef edge = edgeBody({-1, 0}, {1, 0});
        edge.filter.tags = TagMask::bit(31);
        const BodyId id = add(world, edge);
        QVERIFY(rayCast(world, {0, 1}, {0, -1}).has_value());
        QCOMPARE(rayCast(world, {0, 1}, {0, -1})->body, id);
        QCOMPARE(rayCast(world, {0, 1}, {0, -1})->fraction, 0.5);
        QVERIFY(!rayCast(world, {0, -1}, {0, 1}).has_value());
        QVERIFY(!rayCast(world, {0, 1}, {0, -1}, TagMask::bit(0)).has_value());
    }

    void boxQueriesFindWhatOverlapsInOrderOfCreation() {
        World world;
        const BodyId first = add(world, ball({0, 0}, 0.5));
        const BodyId second = add(world, ball({3, 0}, 0.5));
        add(world, ball({9, 9}, 0.5));
        QVERIFY(bodiesIn(world, {{-1, -1}, {4, 1}}) == (std::vector<BodyId>{first, second}));
        QVERIFY(bodiesIn(world, {{0.5, -1}, {2.4, 1}}) == std::vector<BodyId>{first}); // borders count
    }

    void aBoxFindsABodyByTheBoxOfAllItsShapes() {
        World world;
        const Polygon hollow{
            {Vec2(0, 0), Vec2(3, 0), Vec2(3, 3), Vec2(2, 3), Vec2(2, 1), Vec2(1, 1), Vec2(1, 3), Vec2(0, 3)}};
        const BodyId u = add(world, {.kind = BodyKind::Static, .shapes = {hollow}});
        const BodyId two =
            add(world, {.kind = BodyKind::Static, .shapes = {Circle{{9, 0}, 0.5}, Circle{{13, 0}, 0.5}}});
        for (int i = 0; i < 2; ++i) { // before and after there is a tree
            QCOMPARE(bodiesIn(world, {{1.4, 2}, {1.6, 2.2}}), std::vector<BodyId>{u});
            QCOMPARE(bodiesIn(world, {{10.9, -0.1}, {11.1, 0.1}}), std::vector<BodyId>{two});
            world.update();
        }
    }

    void theClosestBodyIsWithinReachAndHasTheRightTags() {
        World world;
        BodyDef near = ball({3, 0}, 1);
        near.filter.tags = TagMask::bit(4);
        const BodyId first = add(world, near);
        const BodyId second = add(world, ball({-9, 0}, 1));
        QCOMPARE(closestBody(world, {0, 0})->body, first);
        QCOMPARE(closestBody(world, {0, 0})->point, Vec2(2, 0));
        QCOMPARE(closestBody(world, {0, 0})->distance, 2.0);
        QCOMPARE(closestBody(world, {3, 0.5})->distance, 0.0);
        QCOMPARE(closestBody(world, {3, 0.5})->point, Vec2(3, 0.5));
        QCOMPARE(closestBody(world, {0, 0}, {.mask = TagMask::bit(0)})->body, second);
        QVERIFY(!closestBody(world, {0, 0}, {.reach = 1.9}).has_value());
        QVERIFY(closestBody(world, {0, 0}, {.reach = 2}).has_value());
        QVERIFY(!closestBody(world, {std::nan(""), 0}).has_value());
        QVERIFY(!closestBody(World(), {0, 0}).has_value());
    }

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
        QCOMPARE(occupiedCells(world).size(), quadtreeCells(world).size());
    }

    void theQuadtreeCellsCoverEveryBody() {
        World world = [] {
            Random random(5);
            return randomWorld(random);
        }();
        world.update();
        const std::vector<Aabb> cells = quadtreeCells(world);
        QVERIFY(!cells.empty());
        for (const BodyId id : world.bodies()) {
            const Vec2 at = world.body(id).massCenter;
            QVERIFY(std::any_of(cells.begin(), cells.end(), [&](const Aabb& cell) { return cell.contains(at); }));
        }
    }
};

SPACETOW_TEST(QueriesTest)
#include "queries_test.moc"
