#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"

#include "core/physics/state/world_data.h"
#include "tests/support/rows.h"

#include "tests/support/scenes.h"

#include <functional>
#include <memory>

using namespace spacetow;
using namespace spacetow::test;

namespace {

int updateCount() {
    return isFullRun() ? 10000 : 200;
}

/// Hashes from then on, one every 50 updates and one at the end.
std::vector<std::uint64_t> futureOf(World& world, int updates) {
    std::vector<std::uint64_t> hashes;
    for (int i = 1; i <= updates; ++i) {
        world.update();
        if (i % 50 == 0 || i == updates) {
            hashes.push_back(world.hash());
        }
    }
    return hashes;
}

void sceneRows() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("n");
    QTest::newRow("balls") << "balls" << 300;
    QTest::newRow("pyramid") << "pyramid" << 12;
    QTest::newRow("tumbler") << "tumbler" << 150;
    QTest::newRow("tow") << "tow" << 1;
    QTest::newRow("mesh") << "mesh" << 10;
}

} // namespace

class CopiesTest : public QObject {
    Q_OBJECT

  private slots:
    void aCopyASavedAndAnEqualWorldHaveTheSameFuture_data() { sceneRows(); }
    void aCopyASavedAndAnEqualWorldHaveTheSameFuture() {
        QFETCH(QString, name);
        QFETCH(int, n);
        const Scene scene = *makeScene(name.toStdString(), n);
        const int before = updateCount() / 4;
        const int after = updateCount() - before;
        World world = worldOf(scene);
        futureOf(world, before);
        const World saved = world;
        World copy = world;
        const std::vector<std::uint64_t> future = futureOf(world, after);
        QVERIFY(future.front() != saved.hash());
        QVERIFY(futureOf(copy, after) == future);
        World loaded = worldOf(*makeScene("balls", 20)); // that was in the middle of something else
        futureOf(loaded, 10);
        loaded = saved;
        QCOMPARE(loaded.hash(), saved.hash());
        QVERIFY(futureOf(loaded, after) == future);
        World equal = worldOf(scene);
        futureOf(equal, before);
        QCOMPARE(equal.hash(), saved.hash());
        World moved = std::move(equal);
        QVERIFY(futureOf(moved, after) == future);
    }

    void aCopyHasNoWorkingMemory() {
        World world = worldOf(*makeScene("balls", 50));
        futureOf(world, 5);
        QVERIFY(!world.data().scratch.solver.velocities.empty() && !world.data().scratch.search.foundPairs.empty());
        World assigned = world;
        futureOf(assigned, 5);
        assigned = world;
        const World copy = world;
        for (const World* each : std::initializer_list<const World*>{&copy, &assigned}) {
            const Scratch& scratch = each->data().scratch;
            QCOMPARE(scratch.solver.velocities.capacity(), std::size_t{0});
            QCOMPARE(scratch.search.foundPairs.capacity(), std::size_t{0});
            QCOMPARE(each->hash(), world.hash());
        }
    }

    void whatMovedInASlotDoesNotDragWhatStandsInItLater() {
        World world({.gravity = {0, -9.81}, .seconds = 0.02, .iterations = 4});
        BodyDef passing = ball({0, 50}, 0.2);
        passing.velocity = {30, 0};
        const BodyId gone = add(world, passing);
        world.update();
        world.removeBody(gone);
        world.update();
        BodyDef floor = box({0, 0}, 5, 1);
        floor.friction = 1;
        floor.kind = BodyKind::Static;
        const BodyId here = add(world, floor);
        QCOMPARE(here.index, gone.index);
        BodyDef crate = box({0, 1.5}, 0.5, 0.5);
        crate.friction = 1;
        const BodyId resting = add(world, crate);
        futureOf(world, 50);
        QVERIFY2(std::abs(world.body(resting).massCenter.x()) < 1e-6,
                 qPrintable(QString("%1 m").arg(world.body(resting).massCenter.x())));
    }

    void aCopyLivesOnWithoutItsOriginal_data() { sceneRows(); }
    void aCopyLivesOnWithoutItsOriginal() {
        QFETCH(QString, name);
        QFETCH(int, n);
        auto original = std::make_unique<World>(worldOf(*makeScene(name.toStdString(), n)));
        futureOf(*original, 20);
        World copy = *original;
        World second = *original;
        for (const BodyId id : original->bodies()) {
            original->removeBody(id);
        }
        original->update();
        original.reset();
        QVERIFY(futureOf(copy, 50) == futureOf(second, 50));
    }

    void looksAtAWorldChangeNothing() {
        World world = worldOf(*makeScene("tumbler", 60));
        World watched = world;
        for (int i = 0; i < 100; ++i) {
            world.update();
            watched.update();
            for (const BodyId id : watched.bodies()) {
                static_cast<void>(watched.body(id));
                static_cast<void>(watched.bounds(id));
            }
            static_cast<void>(totals(watched).energy());
            QCOMPARE(watched.hash(), watched.hash());
            QCOMPARE(watched.hash(), world.hash());
        }
    }

    void everySettingOfAWorldCountsInItsHash() {
        const World world = worldOf(*makeScene("tow", 1));
        const BodyId ship = world.bodies()[1];
        const std::function<void(World&)> changes[] = {
            [](World& w) {
                w.setParameters({.gravity = {0, -1}});
            },
            [](World& w) { w.setParameters({.seconds = 0.01}); },
            [](World& w) { w.setParameters({.iterations = 99}); },
            [](World& w) { w.setParameters({.substeps = 3}); },
            [ship](World& w) {
                w.setPose(ship, {0, 1}, 1e-9);
            },
            [ship](World& w) {
                w.setPose(ship, {1e-9, 1}, 0);
            },
            [ship](World& w) {
                w.setVelocity(ship, {1e-9, 0}, 0);
            },
            [ship](World& w) {
                w.setVelocity(ship, {0, 0}, 1e-9);
            },
            [ship](World& w) {
                w.setFilter(ship, {TagMask{3}, TagMask::all()});
            },
            [ship](World& w) { w.setActive(ship, false); },
            [ship](World& w) { w.setTangible(ship, false); },
            [ship](World& w) { w.setFrozen(ship, true, false); },
            [ship](World& w) { w.setFrozen(ship, false, true); },
            [ship](World& w) { w.removeBody(ship); },
            [ship](World& w) {
                w.applyForce(ship, {1e-9, 0});
            },
            [ship](World& w) { w.applyTorque(ship, 1e-9); },
            [](World& w) { w.removeConnector(w.connectors().front()); },
        };
        int number = 0;
        for (const auto& change : changes) {
            World other = world;
            change(other);
            QVERIFY2(other.hash() != world.hash(), qPrintable(QString("change %1").arg(number)));
            other.update();
            World undisturbed = world;
            undisturbed.update();
            QVERIFY2(other.hash() != undisturbed.hash(), qPrintable(QString("after change %1").arg(number)));
            ++number;
        }
    }
};

SPACETOW_TEST(CopiesTest)
#include "copies_test.moc"
