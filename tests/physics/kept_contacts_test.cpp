// Contacts that the solver keeps are those that it would find anew.

#include "core/physics/world/world.h"

#include "core/base/random.h"
#include "core/physics/state/world_data.h"
#include "tests/support/bodies.h"
#include "tests/support/test_main.h"

#include <numbers>
#include <optional>

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
