// Contacts that the solver keeps are those that it would find anew.

#include "core/physics/world/world.h"

#include "core/base/random.h"
#include "core/physics/broad_phase/pairs.h"
#include "core/physics/contacts/constraint_list.h"
#include "core/physics/contacts/narrow_phase.h"
#include "core/physics/solver/integrate.h"
#include "core/physics/state/world_data.h"
#include "tests/support/bodies.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int scenes = 40;
constexpr int updates = 300;

/// A body that bounces between the walls of a room, in one iteration an update.
World roomWith(BodyDef def, Random& random) {
    World world({.gravity = {0, -9.81}, .seconds = 1.0 / 240, .iterations = 1});
    BodyDef walls = edgeBody({-2, 0}, {2, 0});
    walls.shapes = {Edge{{-2, 3}, {-2, 0}}, Edge{{-2, 0}, {2, 0}}, Edge{{2, 0}, {2, 3}}};
    walls.restitution = 1;
    walls.friction = 0.3;
    add(world, walls);
    def.position = {random.uniform(-1, 1), random.uniform(0.6, 1.5)};
    def.angle = random.uniform(-std::numbers::pi, std::numbers::pi);
    def.velocity = {random.uniform(-3, 3), random.uniform(-3, 3)};
    def.angularVelocity = random.uniform(-4, 4);
    def.restitution = random.uniform(0, 0.6);
    def.friction = 0.3;
    add(world, def);
    return world;
}

bool samePlaces(const World& a, const World& b) {
    for (const BodyId id : a.bodies()) {
        const BodyState s = a.body(id);
        const BodyState t = b.body(id);
        if (s.massCenter != t.massCenter || s.angle != t.angle || s.velocity != t.velocity ||
            s.angularVelocity != t.angularVelocity) {
            return false;
        }
    }
    return true;
}

/// A box that slides on another one, which stands on a floor.
struct Ride {
    World world{{.iterations = 4}};
    BodyId carrier, rider;

    Ride() {
        add(world, edgeBody({-5, 0}, {5, 0}));
        BodyDef below = box({0, 1}, 1, 1);
        BodyDef above = box({-0.4, 2.5}, 0.5, 0.5);
        below.friction = above.friction = 0.01;
        above.velocity = {0.4, 0};
        carrier = add(world, below);
        rider = add(world, above);
    }
    Vec2 carrierFromRider() const { return world.body(carrier).massCenter - world.body(rider).massCenter; }
    /// The same when the manifold between them was made, where there is one: it alone has something below it.
    std::optional<Vec2> whenManifoldWasMade() const {
        for (const Contact& contact : world.data().contacts.pool) {
            const KeptManifold& manifold = contact.manifold;
            if (manifold.tolerance >= 0 && manifold.relative.position.y() < 0) {
                return manifold.relative.position;
            }
        }
        return std::nullopt;
    }
};

/// Boxes, triangles and half discs that have been thrown together.
World heapOfPolygons() {
    World world({.iterations = 4});
    add(world, lineBody({-3, 0}, {3, 0}));
    add(world, lineBody({-1.5, 3}, {-1.5, 0}));
    add(world, lineBody({1.5, 0}, {1.5, 3}));
    Random random(3);
    for (int i = 0; i < 24; ++i) {
        BodyDef def = box({0, 0}, random.uniform(0.1, 0.3), random.uniform(0.1, 0.3));
        if (i % 3 == 1) {
            def.shapes = {Polygon{{{-0.3, -0.1}, {0.3, -0.15}, {0.1, 0.3}}}};
        }
        if (i % 6 == 5) {
            def.shapes.emplace_back(Circle{{0.2, 0.1}, 0.15});
        }
        def.position = {-1.1 + 0.55 * (i % 5), 0.4 + 0.6 * (i / 5)};
        def.angle = random.uniform(-3, 3);
        def.velocity = {random.uniform(-1, 1), random.uniform(-2, 0)};
        def.angularVelocity = random.uniform(-3, 3);
        def.friction = 0.2;
        add(world, def);
    }
    return world;
}

/// The next iteration up to where its contacts are known.
void findNextContacts(WorldData& data) {
    const double dt = data.parameters.seconds / data.parameters.iterations;
    const IterationStep step{dt, dt, 1, dt, 0, 2};
    integrateVelocities(data, step);
    measureMotion(data.bodies, data.flags, data.scratch.search, 0);
    findContacts(data, step);
}

/// All that the solver has of the contact, with a name for each number.
std::vector<std::pair<const char*, double>> numbersOf(const WorldData& data, const GeneralContact& contact) {
    const ConstraintBatch& c = data.constraints.batches.general[contact.lane.batch];
    const std::uint32_t i = contact.lane.lane;
    return {{"normal x", c.normalX[i]},
            {"normal y", c.normalY[i]},
            {"first separation", c.separation1[i]},
            {"second separation", c.separation2[i]},
            {"first target", c.target1[i]},
            {"second target", c.target2[i]},
            {"first closing limit", c.closingLimit1[i]},
            {"second closing limit", c.closingLimit2[i]},
            {"first lever of a", c.leverA1[i]},
            {"first lever of b", c.leverB1[i]},
            {"second lever of a", contact.count == 2 ? c.leverA2[i] : 0},
            {"second lever of b", contact.count == 2 ? c.leverB2[i] : 0},
            {"lever of the friction of a", c.tangentLeverA[i]},
            {"lever of the friction of b", c.tangentLeverB[i]},
            {"mass for friction", c.tangentMass[i]},
            {"first mass", c.mass1[i]},
            {"second mass", c.mass2[i]},
            {"coupling", c.coupling[i]},
            {"inverse determinant", c.inverseDeterminant[i]}};
}

double angularMomentum(const World& world) {
    double sum = 0;
    for (const BodyId id : world.bodies()) {
        const BodyState s = world.body(id);
        sum += s.mass * cross(s.massCenter, s.velocity) + s.inertia * s.angularVelocity;
    }
    return sum;
}

} // namespace

class KeptContactsTest : public QObject {
    Q_OBJECT

  private slots:
    /// What bounces keeps no manifold, so that nothing but its contacts is known from one update to the next.
    void keptContactsMoveABodyAsNewOnesDo_data() {
        QTest::addColumn<int>("corners");
        QTest::newRow("a ball") << 0;
        QTest::newRow("a triangle") << 3;
        QTest::newRow("a box") << 4;
        QTest::newRow("a hexagon") << 6;
    }
    void keptContactsMoveABodyAsNewOnesDo() {
        QFETCH(int, corners);
        BodyDef def = ball({0, 0}, 0.3);
        if (corners > 0) {
            Polygon polygon;
            for (int i = 0; i < corners; ++i) {
                const Rot turn = Rot::fromAngle(2 * std::numbers::pi * i / corners);
                polygon.vertices.push_back(0.3 * turn.right());
            }
            def.shapes = {polygon};
        }
        for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
            Random random(seed);
            World keeping = roomWith(def, random);
            World forgetting = keeping;
            const BodyId body = forgetting.bodies().back();
            for (int i = 0; i < updates; ++i) {
                forgetting.setFilter(body, forgetting.body(body).filter); // so that pairs and contacts are found anew
                keeping.update();
                forgetting.update();
                QVERIFY2(samePlaces(keeping, forgetting), qPrintable(QString("seed %1, update %2").arg(seed).arg(i)));
            }
        }
    }

    /// What does not bounce keeps its manifold for several updates, and slides all the same.
    void aKeptManifoldMovesABodyNearlyAsNewOnesDo() {
        constexpr double moreThanAnUpdate = 0.02; // m; of one it is 0.008 m
        Ride keeping;
        Ride forgetting;
        int kept = 0;
        for (int i = 0; i < 60; ++i) {
            forgetting.world.setFilter(forgetting.rider, forgetting.world.body(forgetting.rider).filter);
            keeping.world.update();
            forgetting.world.update();
            const BodyState a = keeping.world.body(keeping.rider);
            const BodyState b = forgetting.world.body(forgetting.rider);
            QVERIFY((a.massCenter - b.massCenter).norm() < 1e-3 && std::abs(a.angle - b.angle) < 1e-3);
            QVERIFY((a.velocity - b.velocity).norm() < 1e-3 && a.velocity.x() > 0.2);
            const std::optional<Vec2> old = keeping.whenManifoldWasMade();
            kept += old && (*old - keeping.carrierFromRider()).norm() > moreThanAnUpdate ? 1 : 0;
            const std::optional<Vec2> fresh = forgetting.whenManifoldWasMade();
            QVERIFY(!fresh || (*fresh - forgetting.carrierFromRider()).norm() < moreThanAnUpdate);
        }
        QVERIFY2(kept > 10, qPrintable(QString::number(kept)));
    }

    /// Contacts that have a lane are updated four at a time by a kernel, new ones by other code one by one.
    void whatAKernelUpdatesIsWhatANewContactWouldHave() {
        World world = heapOfPolygons();
        int compared = 0;
        int withTwoPoints = 0;
        for (int update = 0; update < 240; ++update) {
            world.update();
            WorldData kept = world.data();
            WorldData anew = world.data();
            releaseConstraints(anew.contacts, anew.constraints, anew.flags);
            findNextContacts(kept);
            findNextContacts(anew);
            if (kept.flags.constraintsRebuilt) {
                continue;
            }
            for (const GeneralContact& c : anew.constraints.generalContacts) {
                const auto same =
                    std::find_if(kept.constraints.generalContacts.begin(), kept.constraints.generalContacts.end(),
                                 [&](const GeneralContact& other) { return other.points[0].pair == c.points[0].pair; });
                QVERIFY(same != kept.constraints.generalContacts.end() && same->count == c.count);
                const auto expected = numbersOf(anew, c);
                const auto updated = numbersOf(kept, *same);
                for (std::size_t i = 0; i < expected.size(); ++i) {
                    const auto [name, value] = expected[i];
                    const double other = updated[i].second;
                    QVERIFY2(
                        value == other || std::abs(value - other) <= 1e-8 * (1 + std::abs(value)),
                        qPrintable(QString("update %1, %2: %3, not %4").arg(update).arg(name).arg(other).arg(value)));
                }
                ++compared;
                withTwoPoints += c.count == 2 ? 1 : 0;
            }
        }
        QVERIFY2(compared > 1000 && withTwoPoints > 300 && compared - withTwoPoints > 100,
                 qPrintable(QString("%1 contacts, %2 with two points").arg(compared).arg(withTwoPoints)));
    }

    /// The points of a kept manifold move with the bodies, and the impulses act where they are.
    void whatSlidesKeepsItsAngularMomentum_data() {
        QTest::addColumn<double>("speed");
        QTest::newRow("slowly") << 0.1;
        QTest::newRow("faster") << 0.3;
        QTest::newRow("fast") << 1.0;
    }
    void whatSlidesKeepsItsAngularMomentum() {
        QFETCH(double, speed);
        World world({.gravity = {0, 0}, .seconds = 1.0 / 60, .iterations = 4});
        BodyDef carrier = box({0, 0}, 1, 1);
        BodyDef rider = box({0.4, 1.52}, 0.5, 0.5);
        carrier.friction = rider.friction = 0.4;
        rider.velocity = {speed, -speed};
        rider.angularVelocity = 0.3;
        add(world, carrier);
        const BodyId id = add(world, rider);
        const double before = angularMomentum(world);
        for (int i = 0; i < 240; ++i) {
            world.update();
            const double change = angularMomentum(world) - before;
            QVERIFY2(std::abs(change) < 1e-12, qPrintable(QString("update %1: %2").arg(i).arg(change)));
        }
        QVERIFY(world.body(id).velocity != rider.velocity);
    }
};

SPACETOW_TEST(KeptContactsTest)
#include "kept_contacts_test.moc"
