#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

#include "core/base/random.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double height = 6;          // m, of the walls
constexpr int updatesUntilRest = 250; // 5 s: fallen, settled, and at rest

/// Balls, boxes, hexagons and ships that do not overlap, dropped into a room; nothing bounces.
World randomPile(Random& random, int iterations) {
    World world(withIterations(iterations));
    const double half = random.uniform(1, 2);
    const QString walls = random.below(2) == 0 ? "edges" : "lines";
    const Vec2 corners[] = {{-half, height}, {-half, 0}, {half, 0}, {half, height}};
    BodyDef room{.kind = BodyKind::Static};
    for (int i = 0; i < 3; ++i) {
        if (walls == "edges") {
            room.shapes.emplace_back(Edge{corners[i], corners[i + 1]});
        } else {
            room.shapes.emplace_back(Line{corners[i], corners[i + 1]});
        }
    }
    room.friction = random.uniform(0, 1);
    add(world, room);
    const char* const kinds[] = {"ball", "box", "hexagon", "ship"};
    const int rows = 2 + static_cast<int>(random.below(6));
    for (int row = 0; row < rows; ++row) {
        for (double x = -half + 0.4; x < half - 0.3; x += 0.7) {
            if (random.below(4) == 0) {
                continue;
            }
            BodyDef def = dropped(kinds[random.below(4)], {x, 0.5 + 0.8 * row});
            def.angle = random.uniform(-pi, pi);
            def.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
            def.angularVelocity = random.uniform(-2, 2);
            def.friction = random.uniform(0, 1);
            add(world, def);
        }
    }
    return world;
}

/// One above the other, with room in between, thrown at the floor.
World randomFew(Random& random, const QString& what, int count, int iterations) {
    World world(withIterations(iterations));
    add(world, floorOf("edge"));
    for (int i = 0; i < count; ++i) {
        BodyDef def = dropped(what, {random.uniform(-0.15, 0.15), 0.5 + 0.6 * i});
        def.mass = 1;
        def.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
        def.angle = random.uniform(-3, 3);
        add(world, def);
    }
    return world;
}

/// By which share of the lowest energy there has been it rose again.
double riseOf(World& world, int updateCount) {
    double lowest = totals(world).energy();
    double rise = 0;
    for (int i = 0; i < updateCount; ++i) {
        world.update();
        rise = std::max(rise, totals(world).energy() / lowest - 1);
        lowest = std::min(lowest, totals(world).energy());
    }
    return rise;
}

} // namespace

class EnergyTest : public QObject {
    Q_OBJECT

    template <class Rise>
    void expectNoRise(std::uint64_t first, std::uint64_t count, const Rise& riseFrom) {
        double worst = 0;
        std::uint64_t worstSeed = 0;
        int rising = 0;
        for (std::uint64_t seed = first; seed < first + count; ++seed) {
            Random random(seed);
            const double rise = riseFrom(random);
            rising += rise > 1e-6 ? 1 : 0;
            worstSeed = rise > worst ? seed : worstSeed;
            worst = std::max(worst, rise);
        }
        QVERIFY2(rising == 0, qPrintable(QString("%1 of %2 gain energy; worst by %3 of it, seed %4")
                                             .arg(rising)
                                             .arg(count)
                                             .arg(worst)
                                             .arg(worstSeed)));
    }

  private slots:
    void aPileGainsNoEnergy_data() {
        QTest::addColumn<int>("iterations");
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("count");
        for (const int iterations : iterationCounts) {
            const int count = isFullRun() ? 100 : std::max(60 / iterations, 1);
            for (int first = 1; first <= (isFullRun() ? 1000 : 1); first += count) {
                QTest::addRow("%d iterations, from seed %d", iterations, first) << iterations << first << count;
            }
        }
    }
    /// The lowest energy there has been, measured from the floor, is not exceeded by a millionth at any later time.
    void aPileGainsNoEnergy() {
        QFETCH(int, iterations);
        QFETCH(int, first);
        QFETCH(int, count);
        expectNoRise(static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(count),
                     [iterations](Random& random) {
                         World world = randomPile(random, iterations);
                         return riseOf(world, updatesUntilRest);
                     });
    }

    void aFewBodiesThatLandGainNoEnergy_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("iterations");
        for (const int iterations : iterationCounts) {
            for (const char* what : {"ball", "box", "hexagon", "ship"}) {
                for (const int count : {1, 2, 3}) {
                    QTest::addRow("%d of %s, %d iterations", count, what, iterations) << what << count << iterations;
                }
            }
        }
    }
    void aFewBodiesThatLandGainNoEnergy() {
        QFETCH(QString, what);
        QFETCH(int, count);
        QFETCH(int, iterations);
        expectNoRise(1, isFullRun() ? 1000 : std::max(200 / iterations, 4), [&](Random& random) {
            World world = randomFew(random, what, count, iterations);
            return riseOf(world, 150);
        });
    }

    void aBoxThatLandsFlatStaysWhereItLands() {
        World world(withIterations(20));
        add(world, floorOf("edge"));
        BodyDef def = box({0, 0.5}, 0.2, 0.2);
        def.mass = 1;
        def.velocity = {0.14968310436233878, 0.72202826570719481};
        def.angle = -0.10934208193793893;
        add(world, def);
        const double rise = riseOf(world, 150);
        QVERIFY2(rise <= 1e-6, qPrintable(QString::number(rise)));
    }
};

SPACETOW_TEST(EnergyTest)
#include "energy_test.moc"
