// Contacts that the solver keeps are those that it would find anew.

#include "core/physics/world.h"

#include "core/base/random.h"
#include "tests/support/bodies.h"
#include "tests/support/test_main.h"

#include <numbers>

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
};

SPACETOW_TEST(KeptContactsTest)
#include "kept_contacts_test.moc"
