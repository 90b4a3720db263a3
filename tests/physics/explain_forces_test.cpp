// What acts on a body, by its source: connectors, damping, and what the owner of the world applied.
#include "tests/support/contact_scenes.h"

#include "core/physics/query/explain.h"

using namespace spacetow;
using namespace spacetow::test;

class ExplainForcesTest : public QObject {
    Q_OBJECT

  private slots:
    void aConnectorTurnsABodyAboutTheAnchorOfThatBody_data() {
        QTest::addColumn<bool>("first");
        QTest::newRow("the body is the first") << true;
        QTest::newRow("the body is the second") << false;
    }
    void aConnectorTurnsABodyAboutTheAnchorOfThatBody() {
        QFETCH(bool, first);
        World world(withIterations(100, {0, 0}));
        BodyDef hook = ball({3, 4}, 0.1);
        hook.kind = BodyKind::Static;
        const BodyId fixed = add(world, hook);
        const BodyId bar = add(world, box({0, 0}, 1, 0.1));
        const Vec2 end(1, 0);
        const ConnectorDef spring =
            first ? ConnectorDef{.a = bar, .b = fixed, .anchorA = end, .length = 1, .stiffness = 2}
                  : ConnectorDef{.a = fixed, .b = bar, .anchorB = end, .length = 1, .stiffness = 2};
        QVERIFY(bool(world.addConnector(spring)));
        world.update();
        const BodyReading before = explained(world, bar);
        world.update();
        const BodyReading reading = explained(world, bar);
        QVERIFY(reading.forces.connectors.force.x() > 1 && reading.forces.connectors.force.y() > 1);
        QVERIFY(reading.forces.connectors.torque > 1);
        const double change = reading.spin - before.spin;
        const double torque = 0.5 * (before.forces.sum().torque + reading.forces.sum().torque);
        QVERIFY2(std::abs(change - 0.02 * torque) < 0.01 * change,
                 qPrintable(QString("%1, not %2 N m s").arg(change).arg(0.02 * torque)));
    }

    void whatMayOnlyTurnIsToldWhatTurnsIt() {
        World world(withIterations(4));
        BodyDef def = ball({0, 0}, 0.5);
        def.positionFrozen = true;
        def.angularDamping = 0.25;
        def.angularVelocity = 2;
        const BodyId wheel = add(world, def);
        world.applyTorque(wheel, 3);
        world.applyForce(wheel, {5, 0});
        world.update();
        const BodyForces forces = explained(world, wheel).forces;
        QCOMPARE(forces.applied.torque, 3.0);
        QVERIFY(forces.sum().force.norm() == 0); // what holds it where it is takes whatever pushes it
        const double inertia = world.body(wheel).inertia;
        QVERIFY(std::abs(forces.damping.torque + 0.25 * inertia * world.body(wheel).angularVelocity) < 1e-9);
        world.update();
        QCOMPARE(explained(world, wheel).forces.applied.torque, 0.0);
    }

    void whatIsMadeOrSwitchedOnSinceHasNothingApplied() {
        World world(withIterations(4));
        const BodyId old = add(world, ball({0, 0}, 0.2));
        world.update();
        world.removeBody(old);
        world.update();
        const BodyId id = add(world, ball({0, 0}, 0.2)); // in the place of the other
        QCOMPARE(id.index, old.index);
        QVERIFY(explained(world, id).forces.applied.force.norm() == 0);
        world.applyForce(id, {4, 0});
        world.update();
        world.setActive(id, false);
        world.update();
        world.setActive(id, true);
        world.update();
        QVERIFY(explained(world, id).forces.applied.force.norm() < 1e-9);
    }
};

SPACETOW_TEST(ExplainForcesTest)
#include "explain_forces_test.moc"
