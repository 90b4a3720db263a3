// Mass and material of a body that is changed in place: formulas, and contacts that go on.

#include "core/base/random.h"
#include "core/physics/def/codes.h"
#include "core/physics/state/world_data.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/odd_numbers.h"
#include "tests/support/random_shapes.h"
#include "tests/support/sleepers.h"

#include <optional>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// What a body is made of, read from the world; its mass stands for its density.
BodyMaterial materialIn(const World& world, BodyId id) {
    const BodyRecord& r = world.data().bodies.records[id.index];
    const std::optional<double> mass = r.kind == BodyKind::Static ? std::nullopt : std::optional(r.mass);
    return {.mass = mass,
            .restitution = r.restitution,
            .friction = r.friction,
            .linearDamping = r.linearDamping,
            .angularDamping = r.angularDamping};
}

template <class Change>
void changeMaterial(World& world, BodyId id, const Change& change) {
    BodyMaterial material = materialIn(world, id);
    change(material);
    QVERIFY(world.setMaterial(id, material).value());
}

BodyMaterial randomMaterial(Random& random) {
    return {.mass = random.uniform(0.1, 10),
            .restitution = random.below(2) == 0 ? 0 : random.unit(),
            .friction = random.uniform(0, 1),
            .linearDamping = random.below(2) == 0 ? 0 : random.uniform(0, 2),
            .angularDamping = random.below(2) == 0 ? 0 : random.uniform(0, 2)};
}

/// A heap of all kinds of bodies between walls, some of them frozen, kinematic or asleep.
World heap(Random& random) {
    World world({.gravity = {0, -9.81}, .iterations = 4});
    world.setSleeping(random.below(2) == 0);
    BodyDef walls{.kind = BodyKind::Static};
    walls.shapes = {Edge{{-1.5, 4}, {-1.5, 0}}, Edge{{-1.5, 0}, {1.5, 0}}, Edge{{1.5, 0}, {1.5, 4}}};
    add(world, walls);
    for (int i = 0; i < 12; ++i) {
        const Vec2 at(random.uniform(-1.2, 1.2), random.uniform(0.4, 3));
        const double radius = random.uniform(0.1, 0.3);
        BodyDef def = random.below(3) == 0 ? ball(at, radius) : random.below(2) == 0 ? box(at, radius, 0.2) : BodyDef{};
        if (def.shapes.empty()) {
            def = {.shapes = {smallStar(random, radius)}, .position = at};
        }
        const BodyMaterial material = randomMaterial(random);
        def.mass = material.mass;
        def.restitution = material.restitution;
        def.friction = material.friction;
        def.linearDamping = material.linearDamping;
        def.positionFrozen = random.below(10) == 0;
        def.kind = random.below(8) == 0 ? BodyKind::Kinematic : BodyKind::Dynamic;
        add(world, def);
    }
    runUpdates(world, static_cast<int>(random.below(200)));
    return world;
}

/// What any contact has is mixed from the materials of its bodies.
bool isMixedFromBodies(const World& world) {
    const WorldData& data = world.data();
    for (const PairTable* table : {&data.contacts.table, &data.sleep.table}) {
        for (const Pair& pair : table->pairs) {
            const BodyRecord& a = data.bodies.records[pair.bodyA];
            const BodyRecord& b = data.bodies.records[pair.bodyB];
            if (pair.contact != Pair::none &&
                (data.contacts.pool[pair.contact].friction != std::sqrt(a.friction * b.friction) ||
                 data.contacts.pool[pair.contact].restitution != 0.5 * (a.restitution + b.restitution))) {
                return false;
            }
        }
    }
    return true;
}

struct Impulses {
    double tangent, first, second;
    Vec2 where;
    bool operator==(const Impulses&) const = default;
};

std::vector<Impulses> impulsesOf(const World& world) {
    std::vector<Impulses> all;
    for (const Pair& pair : world.data().contacts.table.pairs) {
        if (pair.contact != Pair::none) {
            const spacetow::Contact& c = world.data().contacts.pool[pair.contact];
            all.push_back(
                {c.tangentImpulse, c.points[0].normalImpulse, c.points[1].normalImpulse, c.manifold.relative.position});
        }
    }
    return all;
}

/// The height to which a ball rises from a floor on which it has come down from 1 m.
double heightOfRebound(World& world, BodyId ball, double radius) {
    bool rises = false;
    for (int i = 0; i < 200; ++i) {
        world.update();
        const double speed = world.body(ball).velocity.y();
        if (rises && speed <= 0) {
            break;
        }
        rises |= speed > 0;
    }
    const BodyState s = world.body(ball);
    return s.massCenter.y() - radius + s.velocity.squaredNorm() / (2 * 9.81);
}

} // namespace

class MaterialsTest : public QObject {
    Q_OBJECT

  private slots:
    void inFreeFlightAChangedBodyIsToTheBitOneThatWasMadeSo_data() {
        QTest::addColumn<int>("shape");
        QTest::newRow("ball") << 0;
        QTest::newRow("box") << 1;
        QTest::newRow("star") << 2;
    }
    void inFreeFlightAChangedBodyIsToTheBitOneThatWasMadeSo() {
        QFETCH(int, shape);
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            Random random(seed);
            BodyDef made = shape == 0 ? ball({0, 2}, 0.2) : box({0, 2}, 0.3, 0.2);
            if (shape == 2) {
                made.shapes = {smallStar(random, 0.3)};
            }
            made.velocity = {random.uniform(-3, 3), random.uniform(0, 3)};
            made.angularVelocity = random.uniform(-5, 5);
            made.linearDamping = random.uniform(0, 1);
            made.angularDamping = made.linearDamping;
            BodyDef first = made;
            const BodyMaterial material = randomMaterial(random);
            made.mass = material.mass;
            made.restitution = material.restitution;
            made.friction = material.friction;
            World worlds[2] = {World(withIterations(4)), World(withIterations(4))};
            BodyId ids[2];
            for (int i = 0; i < 2; ++i) {
                add(worlds[i], edgeBody({-20, 0}, {20, 0}));
                ids[i] = add(worlds[i], i == 0 ? made : first);
                runUpdates(worlds[i], 10);
            }
            QVERIFY(worlds[0].hash() != worlds[1].hash());
            QVERIFY(worlds[1].setMaterial(ids[1], materialOf(made)).value());
            for (int i = 0; i < 150; ++i) {
                QVERIFY2(worlds[0].hash() == worlds[1].hash(), seedText(seed));
                worlds[0].applyForceAt(ids[0], {1, 0}, {0, 3});
                worlds[1].applyForceAt(ids[1], {1, 0}, {0, 3});
                worlds[0].update();
                worlds[1].update();
            }
        }
    }

    void aKnownPushGivesTheSpeedOfTheNewMass() {
        for (const double mass : {0.5, 4.0, 300.0}) {
            World world({.gravity = {0, 0}, .iterations = 4});
            const BodyId id = add(world, box({0, 0}, 0.3, 0.1));
            world.update();
            changeMaterial(world, id, [mass](BodyMaterial& m) { m.mass = mass; });
            const double inertia = mass * (0.6 * 0.6 + 0.2 * 0.2) / 12;
            QCOMPARE(world.body(id).mass, mass);
            QVERIFY(std::abs(world.body(id).inertia / inertia - 1) < 1e-12);
            world.applyImpulseAt(id, {0, 2}, {0.25, 0});
            QVERIFY((world.body(id).velocity - Vec2(0, 2 / mass)).norm() < 1e-12);
            QVERIFY(std::abs(world.body(id).angularVelocity - 0.5 / inertia) < 1e-9 / inertia);
            world.applyForce(id, {3, 0});
            world.update();
            QVERIFY(std::abs(world.body(id).velocity.x() - 3 * 0.02 / mass) < 1e-12 / mass);
        }
    }

    void withoutAMassItIsTheDensityThatCounts() {
        World world;
        const BodyId id = add(world, box({0, 0}, 0.5, 1));
        QVERIFY(world.setMaterial(id, {.density = 7}).value());
        QVERIFY(std::abs(world.body(id).mass - 14) < 1e-12);
        QVERIFY(!world.setMaterial(id, {.density = 7}).value());
    }

    void aHitIsAsHeavyAsTheBodyIsNow() {
        // Elastic, and both change after they have touched once: v₂ = 2 m₁ v / (m₁ + m₂).
        World world({.gravity = {0, 0}, .iterations = 4});
        BodyDef def = ball({0, 0}, 0.1);
        def.mass = 1;
        const BodyId first = add(world, def);
        def.position.x() = 0.2;
        const BodyId second = add(world, def);
        runUpdates(world, 3);
        changeMaterial(world, first, [](BodyMaterial& m) { m.restitution = 1, m.mass = 3; });
        changeMaterial(world, second, [](BodyMaterial& m) { m.restitution = 1; });
        world.setPose(first, {-0.3, 0}, 0);
        world.setVelocity(first, {2, 0}, 0);
        runUpdates(world, 20);
        QVERIFY(std::abs(world.body(first).velocity.x() - 1) < 1e-6);
        QVERIFY(std::abs(world.body(second).velocity.x() - 3) < 1e-6);
    }

    void whatHasLainOnAFloorBouncesToESquaredOfItsHeight() {
        for (const QString& what : {QString("ball"), QString("box")}) {
            for (const double e : {0.3, 0.6, 0.9}) {
                World world(withIterations(20));
                const BodyId ground = add(world, edgeBody({-20, 0}, {20, 0}));
                const BodyId id = add(world, dropped(what, {0, 0.2}));
                runUpdates(world, 10); // touches
                for (const BodyId body : {ground, id}) {
                    changeMaterial(world, body, [e](BodyMaterial& m) { m.restitution = e; });
                }
                world.setVelocity(id, {0, std::sqrt(2 * 9.81)}, 0); // to a height of 1 m
                runUpdates(world, 30);
                const double rebound = heightOfRebound(world, id, 0.2);
                QVERIFY2(std::abs(rebound - e * e) < 0.01 * e * e,
                         qPrintable(QString("%1, e = %2: %3 m").arg(what).arg(e).arg(rebound)));
            }
        }
    }

    void whatHasLainOnASlopeSlidesByItsNewFriction() {
        const double slope = 0.4;
        const Vec2 along(std::cos(slope), std::sin(slope));
        for (const bool ground : {false, true}) {
            World world(withIterations(20));
            const BodyId floor = add(world, edgeBody(-20 * along, 20 * along));
            BodyDef def = box(0.2 * leftOf(along), 0.2, 0.2);
            def.angle = slope;
            def.friction = 1;
            const BodyId id = add(world, def);
            QVERIFY(world.setMaterial(floor, {.friction = 1}).value());
            runUpdates(world, 50);
            QVERIFY(world.body(id).velocity.norm() < 1e-3);
            const Vec2 start = world.body(id).massCenter;
            changeMaterial(world, ground ? floor : id, [](BodyMaterial& m) { m.friction = 0.04; });
            runUpdates(world, 50); // a second
            const double way = 0.5 * 9.81 * (std::sin(slope) - 0.2 * std::cos(slope));
            QVERIFY(std::abs((start - world.body(id).massCenter).dot(along) - way) < 0.02 * way);
        }
    }

    void itsSpeedFadesByTheNewDamping() {
        World world({.gravity = {0, 0}, .iterations = 4});
        BodyDef def = box({0, 0}, 0.2, 0.1);
        def.velocity = {3, 0};
        def.angularVelocity = 2;
        const BodyId id = add(world, def);
        runUpdates(world, 10);
        changeMaterial(world, id, [](BodyMaterial& m) { m.linearDamping = 1, m.angularDamping = 3; });
        runUpdates(world, 50);
        QVERIFY(std::abs(world.body(id).velocity.x() - 3 * std::exp(-1.0)) < 1e-9);
        QVERIFY(std::abs(world.body(id).angularVelocity - 2 * std::exp(-3.0)) < 1e-9);
    }

    void contactsKeepManifoldsAndImpulsesAndNoTouchEnds() {
        World world(withIterations(4));
        add(world, edgeBody({-20, 0}, {20, 0}));
        std::vector<BodyId> ids;
        for (int i = 0; i < 4; ++i) {
            ids.push_back(add(world, box({0, 0.2 + 0.4 * i}, 0.2, 0.2)));
        }
        runUpdates(world, 50);
        const std::vector<Impulses> before = impulsesOf(world);
        QCOMPARE(before.size(), std::size_t(4));
        changeMaterial(world, ids[1], [](BodyMaterial& m) { m = {.mass = 1, .restitution = 0.3, .friction = 0.9}; });
        QVERIFY(impulsesOf(world) == before);
        world.update();
        QVERIFY(world.events().began.empty() && world.events().ended.empty());
    }

    void anImpossibleMaterialIsRefusedAndChangesNothing() {
        const std::pair<Error, BodyMaterial> bad[] = {
            {{PhysicsCode("not-finite"), {"mass"}}, {.mass = notANumber}},
            {{PhysicsCode("not-finite"), {"mass"}}, {.mass = infinite}},
            {{PhysicsCode("not-finite"), {"density"}}, {.density = infinite}},
            {{PhysicsCode("not-finite"), {"restitution"}}, {.restitution = notANumber}},
            {{PhysicsCode("not-finite"), {"friction"}}, {.friction = infinite}},
            {{PhysicsCode("not-finite"), {"linear damping"}}, {.linearDamping = notANumber}},
            {{PhysicsCode("not-finite"), {"angular damping"}}, {.angularDamping = infinite}},
            {{PhysicsCode("out-of-range"), {"restitution"}}, {.restitution = 1.5}},
            {{PhysicsCode("out-of-range"), {"restitution"}}, {.restitution = -0.1}},
            {{PhysicsCode("out-of-range"), {"friction"}}, {.friction = -1}},
            {{PhysicsCode("out-of-range"), {"linear damping"}}, {.linearDamping = -1}},
            {{PhysicsCode("out-of-range"), {"angular damping"}}, {.angularDamping = -1}},
            {{PhysicsCode("bad-mass"), {"mass"}}, {.mass = 0}},
            {{PhysicsCode("bad-mass"), {"mass"}}, {.mass = -2}},
            {{PhysicsCode("bad-mass"), {"mass"}}, {.mass = 1e-320}},
            {{PhysicsCode("bad-mass"), {"density"}}, {.density = 0}},
            {{PhysicsCode("bad-mass"), {"density"}}, {.density = 1e-320}},
        };
        World world(withIterations(4));
        const BodyId id = add(world, box({0, 1}, 0.2, 0.2));
        const std::uint64_t before = world.hash();
        for (const auto& [error, material] : bad) {
            const Result<bool> changed = world.setMaterial(id, material);
            QVERIFY(!changed);
            QCOMPARE(changed.error(), error);
            QCOMPARE(world.hash(), before);
        }
    }

    void withFreezingAndRemovalThatWaitItActsAtOnce() {
        World world({.gravity = {0, 0}, .iterations = 4});
        const BodyId id = add(world, ball({0, 0}, 0.1));
        const BodyId other = add(world, ball({5, 0}, 0.1));
        runUpdates(world, 2);
        world.setFrozen(id, true);
        changeMaterial(world, id, [](BodyMaterial& m) { m.mass = 8; });
        world.removeBody(other);
        changeMaterial(world, other, [](BodyMaterial& m) { m.mass = 8; });
        QCOMPARE(world.body(id).mass, 8.0);
        world.update();
        QVERIFY(!world.contains(other));
        world.applyImpulseAt(id, {1, 0}, {0, 0});
        QVERIFY(world.body(id).velocity == Vec2(0, 0));
        changeMaterial(world, id, [](BodyMaterial& m) { m.mass = 4; });
        world.setFrozen(id, false);
        world.update();
        world.applyImpulseAt(id, {1, 0}, {0, 0});
        QVERIFY(world.body(id).velocity == Vec2(0.25, 0));
    }

    void inAnyHeapTheSameMaterialChangesNothingAndAnotherIsPartOfTheState() {
        const std::uint64_t seeds = isFullRun() ? 2000 : 60;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            Random random(seed);
            World world = heap(random);
            World untouched = world;
            for (const BodyId id : world.bodies()) {
                QVERIFY2(!world.setMaterial(id, materialIn(world, id)).value(), seedText(seed));
            }
            QVERIFY2(world.hash() == untouched.hash(), seedText(seed));
            runUpdates(world, 5);
            runUpdates(untouched, 5);
            QVERIFY2(world.hash() == untouched.hash(), seedText(seed));
            const std::vector<BodyId> ids = world.bodies();
            for (int i = 0; i < 40; ++i) {
                const BodyId id = ids[random.below(static_cast<std::uint32_t>(ids.size()))];
                const BodyMaterial material = randomMaterial(random);
                const std::uint64_t before = world.hash();
                QVERIFY2(world.setMaterial(id, material).value() && world.hash() != before, seedText(seed));
                World copy = world;
                QVERIFY2(copy.hash() == world.hash() && isMixedFromBodies(world), seedText(seed));
                const int updates = 1 + 10 * static_cast<int>(random.below(4));
                runUpdates(world, updates);
                runUpdates(copy, updates);
                QVERIFY2(copy.hash() == world.hash(), seedText(seed));
                QVERIFY2(world.events().faults.empty(), seedText(seed));
            }
        }
    }
};

SPACETOW_TEST(MaterialsTest)
#include "materials_test.moc"
