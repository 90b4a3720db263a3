#include "tests/support/contact_scenes.h"
#include "tests/support/known_values.h"
#include "tests/support/rows.h"

#include "core/base/random.h"
#include "core/geometry/bounds.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/overlaps.h"
#include "core/physics/query/queries.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using IndexPairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Aabb boxAt(const World& world, BodyId id) {
    Aabb box;
    for (const Shape& shape : world.shapes(id)) {
        box.include(boundsOf(shape, world.body(id).pose));
    }
    return box;
}

BodyDef squareAt(const Vec2& center, double half) {
    BodyDef def = box({0, 0}, half, half);
    for (Vec2& v : std::get<Polygon>(def.shapes[0]).vertices) {
        v += center; // drawn there: the body itself stays at the origin
    }
    return def;
}

/// Where a ball of radius 0.2 that falls over x = 3 comes to rest on a static square of side 2 drawn at (3, 0).
double heightOnASquareFarFromItsOrigin() {
    World world(withIterations(20));
    BodyDef def = squareAt({3, 0}, 1);
    def.kind = BodyKind::Static;
    add(world, def);
    const BodyId id = add(world, ball({3, 2}, 0.2));
    run(world, 2);
    return world.body(id).massCenter.y();
}

/// The iteration in which two overlapping bodies of a new world are first felt; −1 if they are not.
int firstFeltIn(BodyKind kind) {
    World world(withIterations(20, {0, 0}));
    BodyDef def = squareAt({3, 0}, 1);
    def.kind = kind;
    add(world, def);
    add(world, ball({3, 1.1}, 0.2));
    world.update();
    return world.events().began.empty() ? -1 : world.events().began.front().iteration;
}

/// How much larger the box of a moving edge ever is than after its first update, m.
double boxGrowth(const Vec2& velocity) {
    World world(withIterations(20, {0, 0}));
    BodyDef def = edgeBody({-1, 0}, {1, 0}, 0.2);
    def.kind = BodyKind::Kinematic;
    def.velocity = velocity;
    const BodyId id = add(world, def);
    world.update();
    const Vec2 first = world.bounds(id).size();
    double growth = 0;
    for (int i = 0; i < 500; ++i) {
        world.update();
        growth = std::max(growth, (world.bounds(id).size() - first).maxCoeff());
    }
    return growth;
}

/// The left border of all cells of a world that lies round (1000, 1000).
double leftOfAFarWorld() {
    World world(withIterations(4, {0, 0}));
    BodyDef post = ball({1000, 1000}, 0.5);
    post.kind = BodyKind::Static;
    add(world, post);
    for (int i = 0; i < 30; ++i) {
        add(world, ball({1001.0 + i, 1003}, 0.3));
    }
    world.update();
    double left = noBack;
    for (const QuadtreeCell& cell : occupiedCells(world)) {
        left = std::min(left, cell.box.min.x());
    }
    return left;
}

Shape randomShape(Random& random) {
    const Vec2 at(random.uniform(-1, 1), random.uniform(-1, 1));
    switch (random.below(4)) {
    case 0:
        return Circle{at, random.uniform(0.1, 0.6)};
    case 1:
        return Edge{at, at + Vec2(random.uniform(0.2, 1), random.uniform(-1, 1)), random.uniform(0, 0.3)};
    case 2:
        return Line{at, at + Vec2(random.uniform(-1, 1), random.uniform(0.2, 1))};
    default:
        return Polygon{regularPolygon(3 + static_cast<int>(random.below(9)), random.uniform(0.1, 0.6))};
    }
}

World randomZones(Random& random) {
    World world({.gravity = {0, 0}, .seconds = 1e-9, .iterations = 1, .substeps = 1});
    const std::uint32_t count = 2 + random.below(20);
    const double reach = random.uniform(1, 5);
    for (std::uint32_t i = 0; i < count; ++i) {
        BodyDef def{.kind = static_cast<BodyKind>(random.below(3)), .shapes = {randomShape(random)}};
        if (random.below(3) == 0) {
            def.shapes.push_back(randomShape(random));
        }
        const double x = random.uniform(-reach, reach);
        def.position = {x, random.uniform(-reach, reach)};
        def.angle = random.uniform(-3, 3);
        def.tangible = false;
        def.active = random.below(8) != 0;
        add(world, def);
    }
    return world;
}

bool meet(const World& world, BodyId a, BodyId b) {
    for (const Shape& shapeA : world.shapes(a)) {
        for (const Shape& shapeB : world.shapes(b)) {
            for (const Part& partA : partsOf(shapeA)) {
                for (const Part& partB : partsOf(shapeB)) {
                    if (overlaps(partA, world.body(a).pose, partB, world.body(b).pose)) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

/// Every pair of which one moves and which meets, whatever the trees say.
IndexPairs bruteForce(const World& world) {
    IndexPairs pairs;
    const std::vector<BodyId> ids = world.bodies();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        for (std::size_t k = i + 1; k < ids.size(); ++k) {
            const BodyState a = world.body(ids[i]);
            const BodyState b = world.body(ids[k]);
            const bool moves = a.kind != BodyKind::Static || b.kind != BodyKind::Static;
            if (a.active && b.active && moves && meet(world, ids[i], ids[k])) {
                pairs.emplace(ids[i].index, ids[k].index);
            }
        }
    }
    return pairs;
}

} // namespace

class BroadPhaseTest : public QObject {
    Q_OBJECT

  private slots:
    void everyNumberIsWhatItsSentenceSays_data() {
        knownValueColumns();
        known("a ball falls onto a static square that is drawn at x = 3, beside its body's origin",
              heightOnASquareFarFromItsOrigin(), 1.2, 0.005);
        known("a static polygon is felt in the first iteration", firstFeltIn(BodyKind::Static), 0, 0);
        known("a kinematic polygon is felt in the first iteration", firstFeltIn(BodyKind::Kinematic), 0, 0);
        known("a dynamic polygon is felt in the first iteration", firstFeltIn(BodyKind::Dynamic), 0, 0);
        known("the box of an edge that moves does not grow", boxGrowth({3, 1}), 0, 1e-9);
        known("the box of an edge that moves fast does not grow", boxGrowth({300, 0}), 0, 1e-6);
        known("the trees of a world far from the origin do not reach to the origin", std::min(leftOfAFarWorld(), 990.0),
              990, 0);
    }
    void everyNumberIsWhatItsSentenceSays() { checkKnownValue(); }

    void theBoxOfABodyCoversItsWholeWay_data() {
        QTest::addColumn<Vec2>("velocity");
        QTest::addColumn<double>("spin");
        QTest::newRow("at rest") << Vec2(0, 0) << 0.0;
        QTest::newRow("slow") << Vec2(0.1, -0.2) << 0.5;
        QTest::newRow("fast") << Vec2(-300, 100) << 0.0;
        QTest::newRow("spinning") << Vec2(1, 0) << 80.0;
    }
    void theBoxOfABodyCoversItsWholeWay() {
        QFETCH(Vec2, velocity);
        QFETCH(double, spin);
        World world({.gravity = {0, -9.81}, .iterations = 1, .substeps = 1});
        std::vector<BodyId> ids;
        for (int i = 0; i < 4; ++i) {
            BodyDef def = dropped(i == 0 ? "ball" : i == 1 ? "box" : "ship", {10.0 * i, 0});
            def.kind = i == 3 ? BodyKind::Kinematic : BodyKind::Dynamic;
            def.velocity = velocity;
            def.angularVelocity = spin;
            ids.push_back(add(world, def));
        }
        for (int i = 0; i < 100; ++i) {
            std::vector<Aabb> before;
            for (const BodyId id : ids) {
                before.push_back(boxAt(world, id));
            }
            world.update();
            for (std::size_t k = 0; k < ids.size(); ++k) {
                const Aabb swept = world.bounds(ids[k]).grown(1e-9);
                QVERIFY2(swept.contains(before[k]), qPrintable(QString("body %1, update %2: start").arg(k).arg(i)));
                QVERIFY2(swept.contains(boxAt(world, ids[k])),
                         qPrintable(QString("body %1, update %2: end").arg(k).arg(i)));
            }
        }
    }

    void theBoxOfABodyIsNeverOutOfDate_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<Vec2>("to");
        QTest::addColumn<double>("angle");
        const char* const kinds[] = {"static", "kinematic", "dynamic"};
        for (int kind = 0; kind < 3; ++kind) {
            QTest::addRow("a %s body is put elsewhere", kinds[kind]) << kind << Vec2(7, -3) << 0.7;
            QTest::addRow("a %s body is put a little aside", kinds[kind]) << kind << Vec2(0.001, 0) << 0.7;
            QTest::addRow("a %s body is turned within its old box", kinds[kind]) << kind << Vec2(0, 0) << 0.0;
        }
    }
    void theBoxOfABodyIsNeverOutOfDate() {
        QFETCH(int, kind);
        QFETCH(Vec2, to);
        QFETCH(double, angle);
        World world(withIterations(4, {0, 0}));
        BodyDef def = test::box({0, 0}, 1, 0.5);
        def.kind = static_cast<BodyKind>(kind);
        def.angle = 0.7;
        const BodyId id = add(world, def);
        world.update();
        world.setPose(id, to, angle);
        const Aabb exact = boxAt(world, id);
        const Aabb box = world.bounds(id);
        QVERIFY((box.min - exact.min).norm() < 1e-12 && (box.max - exact.max).norm() < 1e-12);
        world.update();
        QVERIFY(world.bounds(id).grown(1e-12).contains(exact));
        QVERIFY((world.bounds(id).size() - exact.size()).maxCoeff() < 0.5); // nothing is left of the old one
    }

    void theBoxOfABodyHoldsWhatIsPushedOutOfAnOverlap() {
        for (const int iterations : iterationCounts) {
            World world(withIterations(iterations, {0, 0}));
            BodyDef post = ball({0, 0}, 2);
            post.kind = BodyKind::Static;
            add(world, post);
            const BodyId id = add(world, ball({1, 0}, 0.5));
            for (int i = 0; i < 50; ++i) {
                world.update();
                QVERIFY2(world.bounds(id).grown(1e-12).contains(boxAt(world, id)),
                         qPrintable(QString("%1 iterations, update %2").arg(iterations).arg(i)));
            }
        }
    }

    void thePairsFeltAreThoseOfBruteForce() {
        int found = 0;
        for (std::uint64_t seed = 1; seed <= (isFullRun() ? 10000u : 1000u); ++seed) {
            Random random(seed);
            World world = randomZones(random);
            const IndexPairs expected = bruteForce(world);
            world.update();
            IndexPairs began;
            for (const TouchEvent& event : world.events().began) {
                const bool isNew = began.emplace(event.a.index, event.b.index).second;
                QVERIFY2(isNew && event.iteration == 0 && !event.solid, seedText(seed));
            }
            found += static_cast<int>(began.size());
            QVERIFY2(began == expected, seedText(seed));
        }
        QVERIFY(found > 2000);
    }

    void thousandsOfBodiesAtOnePlaceTakeNoMemoryForEachTwoOfThem() {
        constexpr int count = 1500;
        World world(withIterations(1, {0, 0}));
        for (int i = 0; i < count; ++i) {
            add(world, ball({0, 0}, 0.2));
        }
        for (int i = 0; i < 3; ++i) {
            world.update();
            const std::size_t pairs = world.data().contacts.table.size();
            QVERIFY2(pairs > 100 * count && pairs < 400000, qPrintable(QString::number(pairs)));
            QVERIFY(world.data().scratch.search.overlapping.capacity() < 1000000);
        }
        for (const BodyId id : world.bodies()) { // nobody is forgotten for good
            world.setPose(id, {0.39 * (id.index % 40), 0.39 * static_cast<double>(id.index / 40)}, 0);
        }
        world.update();
        world.update();
        QVERIFY(world.data().contacts.table.size() > 2 * count);
        QVERIFY(!world.data().flags.crowded);
    }
};

SPACETOW_TEST(BroadPhaseTest)
#include "broad_phase_test.moc"
