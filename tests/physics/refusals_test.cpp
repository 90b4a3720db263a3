#include "core/physics/def/codes.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/odd_numbers.h"
#include "tests/support/rows.h"

#include <functional>
#include <limits>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using MakeBody = std::function<void(BodyDef&, double)>;
using MakeConnector = std::function<void(ConnectorDef&, double)>;
using Push = std::function<bool(World&, BodyId, double)>;

const std::pair<const char*, MakeBody> bodyFields[] = {
    {"position", [](BodyDef& d, double x) { d.position.x() = x; }},
    {"position", [](BodyDef& d, double x) { d.position.y() = x; }},
    {"angle", [](BodyDef& d, double x) { d.angle = x; }},
    {"velocity", [](BodyDef& d, double x) { d.velocity.x() = x; }},
    {"velocity", [](BodyDef& d, double x) { d.velocity.y() = x; }},
    {"angular velocity", [](BodyDef& d, double x) { d.angularVelocity = x; }},
    {"mass", [](BodyDef& d, double x) { d.mass = x; }},
    {"density", [](BodyDef& d, double x) { d.density = x; }},
    {"restitution", [](BodyDef& d, double x) { d.restitution = x; }},
    {"friction", [](BodyDef& d, double x) { d.friction = x; }},
    {"linear damping", [](BodyDef& d, double x) { d.linearDamping = x; }},
    {"angular damping", [](BodyDef& d, double x) { d.angularDamping = x; }},
};

const std::pair<const char*, MakeBody> shapeFields[] = {
    {"the centre of a circle",
     [](BodyDef& d, double x) {
         d.shapes = {Circle{{x, 0}, 1}};
     }},
    {"the radius of a circle",
     [](BodyDef& d, double x) {
         d.shapes = {Circle{{0, 0}, x}};
     }},
    {"the start of an edge",
     [](BodyDef& d, double x) {
         d.shapes = {Edge{{x, 0}, {1, 0}, 1}};
     }},
    {"the end of an edge",
     [](BodyDef& d, double x) {
         d.shapes = {Edge{{0, 0}, {1, x}, 1}};
     }},
    {"the start of a line",
     [](BodyDef& d, double x) {
         d.shapes = {Line{{0, x}, {1, 0}}};
     }},
    {"the end of a line",
     [](BodyDef& d, double x) {
         d.shapes = {Line{{0, 0}, {x, 0}}};
     }},
    {"a vertex of a polygon",
     [](BodyDef& d, double x) {
         d.shapes = {Polygon{{Vec2(0, 0), Vec2(1, x), Vec2(0, 1)}}};
     }},
    {"the second of two shapes",
     [](BodyDef& d, double x) {
         d.shapes = {Circle{{0, 0}, 1}, Circle{{0, x}, 1}};
     }},
};

const std::pair<const char*, MakeConnector> connectorFields[] = {
    {"anchor", [](ConnectorDef& d, double x) { d.anchorA.x() = x; }},
    {"anchor", [](ConnectorDef& d, double x) { d.anchorB.y() = x; }},
    {"length", [](ConnectorDef& d, double x) { d.length = x; }},
    {"stiffness", [](ConnectorDef& d, double x) { d.stiffness = x; }},
    {"damping", [](ConnectorDef& d, double x) { d.damping = x; }},
    {"limit",
     [](ConnectorDef& d, double x) {
         d.truncation = {TruncationRule::Clamp, x, 0.5, {}};
     }},
    {"proportion",
     [](ConnectorDef& d, double x) {
         d.truncation = {TruncationRule::PartialTanh, 1, x, {}};
     }},
};

const std::pair<const char*, Push> pushes[] = {
    {"a force to the side",
     [](World& w, BodyId id, double x) {
         return w.applyForce(id, {x, 0});
     }},
    {"a force upwards",
     [](World& w, BodyId id, double x) {
         return w.applyForce(id, {0, x}, ForceSource::Engine);
     }},
    {"a force at a point",
     [](World& w, BodyId id, double x) {
         return w.applyForceAt(id, {x, 1}, {0, 0});
     }},
    {"a force at no point",
     [](World& w, BodyId id, double x) {
         return w.applyForceAt(id, {1, 1}, {0, x});
     }},
    {"a torque", [](World& w, BodyId id, double x) { return w.applyTorque(id, x); }},
    {"an impulse",
     [](World& w, BodyId id, double x) {
         return w.applyImpulseAt(id, {0, x}, {0, 0});
     }},
    {"an impulse at no point",
     [](World& w, BodyId id, double x) {
         return w.applyImpulseAt(id, {1, 0}, {x, 0});
     }},
    {"an angular impulse", [](World& w, BodyId id, double x) { return w.applyAngularImpulse(id, x); }},
};

void badNumberRows(const char* what, int index) {
    QTest::addRow("%d: %s not a number", index, what) << index << notANumber;
    QTest::addRow("%d: %s infinite", index, what) << index << infinite;
    QTest::addRow("%d: %s minus infinity", index, what) << index << -infinite;
}

template <class Fields>
void badNumbers(const Fields& fields, const std::function<const char*(int)>& nameOf) {
    QTest::addColumn<int>("index");
    QTest::addColumn<double>("value");
    for (int i = 0; i < static_cast<int>(std::size(fields)); ++i) {
        badNumberRows(nameOf(i), i);
    }
}

/// Three balls on a floor, two of them on a rope.
struct Company {
    World world{withIterations(4)};
    std::vector<BodyId> ids;

    Company() {
        add(world, floorOf("edge"));
        for (const double x : {-3.0, 0.0, 1.0}) {
            ids.push_back(add(world, ball({x, 0.5}, 0.2)));
        }
        static_cast<void>(world.addConnector({.a = ids[1], .b = ids[2]}).value());
        run(world, 0.2);
    }
};

} // namespace

class RefusalsTest : public QObject {
    Q_OBJECT

  private slots:
    void aBodyOfNoNumbersIsRefused_data() {
        badNumbers(bodyFields, [](int i) { return bodyFields[i].first; });
    }
    void aBodyOfNoNumbersIsRefused() {
        QFETCH(int, index);
        QFETCH(double, value);
        World world;
        BodyDef def = ball({0, 0}, 0.1);
        bodyFields[index].second(def, value);
        const std::uint64_t before = world.hash();
        const auto made = world.addBody(def);
        QVERIFY(!made);
        QCOMPARE(made.error(), (Error{PhysicsCode("not-finite"), {bodyFields[index].first}}));
        QCOMPARE(world.hash(), before);
        QCOMPARE(world.bodyCount(), 0);
    }

    void aShapeOfNoNumbersIsRefused_data() {
        badNumbers(shapeFields, [](int i) { return shapeFields[i].first; });
    }
    void aShapeOfNoNumbersIsRefused() {
        QFETCH(int, index);
        QFETCH(double, value);
        World world;
        for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic}) {
            BodyDef def{.kind = kind};
            shapeFields[index].second(def, value);
            QCOMPARE(world.addBody(def).error(), (Error{PhysicsCode("bad-shape"), {"shapes"}}));
        }
    }

    void aConnectorOfNoNumbersIsRefused_data() {
        badNumbers(connectorFields, [](int i) { return connectorFields[i].first; });
    }
    void aConnectorOfNoNumbersIsRefused() {
        QFETCH(int, index);
        QFETCH(double, value);
        Company company;
        ConnectorDef def{.a = company.ids[0], .b = company.ids[1]};
        connectorFields[index].second(def, value);
        const std::uint64_t before = company.world.hash();
        QCOMPARE(company.world.addConnector(def).error(),
                 (Error{PhysicsCode("not-finite"), {connectorFields[index].first}}));
        QCOMPARE(company.world.hash(), before);
    }

    void aPushOfNoNumbersIsRefusedAndChangesNothing_data() {
        badNumbers(pushes, [](int i) { return pushes[i].first; });
    }
    void aPushOfNoNumbersIsRefusedAndChangesNothing() {
        QFETCH(int, index);
        QFETCH(double, value);
        Company company;
        World undisturbed = company.world;
        for (const BodyId id : company.world.bodies()) {
            QVERIFY(!pushes[index].second(company.world, id, value));
            QVERIFY(pushes[index].second(undisturbed, id, 0) && pushes[index].second(company.world, id, 0));
        }
        for (int i = 0; i < 20; ++i) {
            company.world.update();
            undisturbed.update();
            QCOMPARE(company.world.hash(), undisturbed.hash());
            QVERIFY(company.world.events().faults.empty());
        }
    }

    void whatIsOutOfRangeIsRefused_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("code");
        const auto row = [](const char* name, int index, double value, const char* code) {
            QTest::newRow(name) << index << value << code;
        };
        row("a mass of zero", 6, 0, "bad-mass");
        row("a negative mass", 6, -1, "bad-mass");
        row("a density of zero", 7, 0, "bad-mass");
        row("a negative density", 7, -1, "bad-mass");
        row("a mass without an inverse", 6, 1e-320, "bad-mass");
        row("a density without an inverse", 7, 1e-320, "bad-mass");
        row("a density so small that nothing is left of the mass", 7, 5e-324, "bad-mass");
        row("a restitution of 1.2, which would make energy", 8, 1.2, "out-of-range");
        row("a restitution just above 1", 8, std::nextafter(1.0, 2), "out-of-range");
        row("a negative restitution", 8, -0.1, "out-of-range");
        row("a negative friction", 9, -0.1, "out-of-range");
        row("a negative linear damping", 10, -0.1, "out-of-range");
        row("a negative angular damping", 11, -0.1, "out-of-range");
        row("a place where doubles are too coarse", 0, 1e10, "out-of-range");
    }
    void whatIsOutOfRangeIsRefused() {
        QFETCH(int, index);
        QFETCH(double, value);
        QFETCH(QString, code);
        World world;
        BodyDef def = ball({0, 0}, 0.1);
        bodyFields[index].second(def, value);
        QCOMPARE(QString::fromUtf8(world.addBody(def).error().code.text()), code);
        QCOMPARE(world.bodyCount(), 0);
    }

    void aMassOrInertiaThatOverflowsIsRefused_data() {
        QTest::addColumn<double>("size");
        QTest::addColumn<double>("mass");
        QTest::addColumn<double>("density");
        QTest::newRow("an area beyond all numbers") << 1e200 << 0.0 << 1.0;
        QTest::newRow("an area beyond all numbers, with a mass") << 1e200 << 1.0 << 1.0;
        QTest::newRow("a mass beyond all numbers") << 10.0 << 0.0 << 1e308;
        QTest::newRow("an inertia beyond all numbers") << 1e3 << 1e308 << 1.0;
        QTest::newRow("an inertia without an inverse") << 1e-5 << 1e-300 << 1.0;
        QTest::newRow("an inertia of zero") << 1e-100 << 1e-300 << 1.0;
        QTest::newRow("a density that leaves no mass to scale") << 0.1 << 1.0 << 5e-324;
    }
    void aMassOrInertiaThatOverflowsIsRefused() {
        QFETCH(double, size);
        QFETCH(double, mass);
        QFETCH(double, density);
        World world;
        const Polygon square{{Vec2(-size, -size), Vec2(size, -size), Vec2(size, size), Vec2(-size, size)}};
        for (const Shape& shape : {Shape(Circle{{0, 0}, size}), Shape(square)}) {
            for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Dynamic}) {
                BodyDef def{.kind = kind, .shapes = {shape}};
                def.mass = mass > 0 ? std::optional<double>(mass) : std::nullopt;
                def.density = density;
                QCOMPARE(world.addBody(def).error(), (Error{PhysicsCode("bad-mass"), {mass > 0 ? "mass" : "density"}}));
            }
        }
    }

    void anImpulseWhoseTurnOverflowsChangesNothing() {
        Company company;
        const std::uint64_t before = company.world.hash();
        for (const BodyId id : company.world.bodies()) {
            QVERIFY(!company.world.applyImpulseAt(id, {0, 1e200}, {1e200, 0}));
        }
        QCOMPARE(company.world.hash(), before);
    }

    void theErrorNamesWhatIsMissing() {
        World world;
        QCOMPARE(world.addBody({}).error(), (Error{PhysicsCode("no-shape"), {"shapes"}}));
        QVERIFY(bool(world.addBody({.kind = BodyKind::Static}))); // a place for things to be tied to
    }
};

SPACETOW_TEST(RefusalsTest)
#include "refusals_test.moc"
