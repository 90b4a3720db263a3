#include "core/game/grab.h"
#include "core/game/session.h"
#include "tests/support/live_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A stick of this mass, alone in space or under gravity.
Level stick(std::optional<double> mass, const Vec2& velocity = Vec2(0, 0)) {
    Level level;
    level.gravity = Vec2(0, -10);
    level.iterations = 4;
    addBodyObject(level, boxKey,
                  {.kind = BodyKind::Dynamic,
                   .shapes = {Polygon{{{-1, -0.1}, {1, -0.1}, {1, 0.1}, {-1, 0.1}}}},
                   .velocity = velocity,
                   .mass = mass});
    return level;
}

StepInput holding(const Vec2& anchor, const Vec2& target) {
    return {{}, Grab{boxKey, anchor, target}, {}};
}

double distance(const Session& session, const Grab& grab) {
    return (stateOf(session, boxKey).pose.toWorld(grab.anchor) - grab.target).norm();
}

} // namespace

class GrabTest : public QObject {
    Q_OBJECT

  private slots:
    void aGrabbedBodyComesToTheTargetWhateverItsMass() {
        for (const double mass : {1e-9, 1e-3, 1.0, 1e3, 1e9}) {
            Session session(stick(mass));
            const StepInput input = holding(Vec2(0.9, 0), Vec2(3, 2));
            stepOn(session, 250, input);
            QVERIFY(distance(session, *input.grab) < 0.02); // and hangs a little below it
            QVERIFY(stateOf(session, boxKey).pose.position.y() < 1.5);
            QVERIFY(session.grabForce().has_value());
            const double weight = 10 * mass;
            QVERIFY(std::abs(session.grabForce()->force.y() / weight - 1) < 0.2);
        }
    }
    void theWayThereIsTheSameForAllMasses() {
        Session light(stick(1e-3)), heavy(stick(1e3));
        stepOn(light, 30, holding(Vec2(0.9, 0), Vec2(3, 2)));
        stepOn(heavy, 30, holding(Vec2(0.9, 0), Vec2(3, 2)));
        QVERIFY((stateOf(light, boxKey).pose.position - stateOf(heavy, boxKey).pose.position).norm() < 1e-6);
    }
    void whatIsVeryFastIsCaught() {
        for (const double speed : {1e3, 1e6}) {
            World world({.gravity = Vec2(0, -10), .iterations = 4});
            const Result<BodyId> body = world.addBody({.shapes = {Circle{{0, 0}, 0.5}}, .velocity = Vec2(speed, 0)});
            const Grab grab{boxKey, Vec2(-0.2, 0), Vec2(0, 0)};
            double fastest = 0;
            for (int i = 0; i < 200; ++i) {
                QVERIFY(pull(world, body.value(), grab).has_value());
                world.update();
                fastest = std::max(fastest, world.body(body.value()).velocity.norm());
            }
            QVERIFY(fastest < 1.01 * speed);
            double far = (world.body(body.value()).pose.toWorld(grab.anchor) - grab.target).norm();
            for (int i = 0; i < 50 * 120 && far > 0.05; ++i) { // the way back
                pull(world, body.value(), grab);
                world.update();
                far = (world.body(body.value()).pose.toWorld(grab.anchor) - grab.target).norm();
            }
            QVERIFY2(far < 0.05, qPrintable(QString("%1 m, thrown at %2 m/s").arg(far).arg(speed)));
        }
    }
    void aTargetThatIsThrownAboutThrowsTheBodyNoFasterThanTheSpringAllows() {
        Session session(stick(1.0));
        for (int i = 0; i < 300; ++i) { // a million metres a second
            session.step(holding(Vec2(0.9, 0), Vec2(i % 20 * 2e4, i % 7 * -2e4)));
            const BodyState now = stateOf(session, boxKey);
            QVERIFY(now.velocity.norm() < 3000);
            QVERIFY(std::isfinite(now.angularVelocity));
        }
        const StepInput input = holding(Vec2(0.9, 0), Vec2(0, 0));
        stepOn(session, 1500, input);
        QVERIFY(distance(session, *input.grab) < 0.05);
    }
    void aSpinningBodyIsCalmed() {
        Level level = stick(1.0);
        level = *edited<BodyObject>(level, boxKey, [](BodyObject& body) { body.angularVelocity = 300; });
        Session session(level);
        const StepInput input = holding(Vec2(0.9, 0), Vec2(0, 0));
        stepOn(session, 500, input);
        QVERIFY(distance(session, *input.grab) < 0.05);
        QVERIFY(std::abs(stateOf(session, boxKey).angularVelocity) < 1);
    }
    void whatNothingMovesIsNotMoved() {
        const auto kept = [](auto change) {
            Session session(*edited<BodyObject>(stick(1.0), boxKey, change));
            const BodyState before = stateOf(session, boxKey);
            stepOn(session, 20, holding(Vec2(0.9, 0), Vec2(3, 2)));
            return stateOf(session, boxKey).pose.position == before.pose.position && !session.grabForce();
        };
        QVERIFY(kept([](BodyObject& body) { body.frozen = true; }));
        QVERIFY(kept([](BodyObject& body) { body.kind = BodyKind::Static; }));
        QVERIFY(kept([](BodyObject& body) { body.kind = BodyKind::Kinematic; }));
    }
    void whatIsRemovedWhileItIsHeldIsHeldNoMore() {
        Session session(yard());
        const StepInput input = holding(Vec2(0, 0), Vec2(1, 5));
        stepOn(session, 20, input);
        session.step({{}, input.grab, without(yard(), boxKey)});
        QVERIFY(!session.bodyOf(boxKey));
        stepOn(session, 20, input);
        QVERIFY(!session.grabForce());
    }
    void numbersThatAreNoneAreRefused() {
        Session session(stick(1.0)), other(stick(1.0));
        const double bad = std::nan("");
        stepOn(session, 5, holding(Vec2(0, 0), Vec2(bad, 0)));
        stepOn(session, 5, holding(Vec2(0, std::numeric_limits<double>::infinity()), Vec2(0, 0)));
        stepOn(other, 10);
        QCOMPARE(session.hash(), other.hash());
    }
    void theShipOfAGameCanBeHeldOnceItFlies() {
        Session session(openSpace());
        const StepInput input{idle, Grab{shipKey, Vec2(0, 0), Vec2(-2, 0)}, {}};
        stepOn(session, 30, input);
        QVERIFY(session.ship()->pose.position == Vec2(0, 0));
        session.step(left);
        stepOn(session, 150, input);
        QVERIFY((session.ship()->pose.position - Vec2(-2, 0)).norm() < 0.05);
        QCOMPARE(session.phase(), Phase::Flying);
    }
    void aSleeperIsWokenByTheHand() {
        Session session(yard());
        stepOn(session, 400);
        stepOn(session, 100, holding(Vec2(0, 0), Vec2(0, 3)));
        QVERIFY(stateOf(session, boxKey).pose.position.y() > 2.5);
    }
};

SPACETOW_TEST(GrabTest)
#include "grab_test.moc"
