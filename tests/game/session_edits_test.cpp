#include "core/game/payload.h"
#include "core/game/session.h"
#include "core/level/file.h"
#include "core/physics/state/world_data.h"
#include "tests/support/live_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// What spelling and reading makes of it: equal, and no piece shared.
std::shared_ptr<const Level> readAgain(const Level& level) {
    const LevelFile file = parseLevel(levelText(level));
    EXPECTS(file.level);
    return std::make_shared<const Level>(*file.level);
}

/// A level that differs in many ways from a yard.
Level rebuiltYard() {
    Level level = *edited<BodyObject>(yard(), boxKey, [](BodyObject& box) {
        box.mass = 3;
        box.position += Vec2(0.5, 1);
        box.friction = 1;
    });
    level = *without(level, ballKey);
    level = *without(level, springKey);
    level.gravity = Vec2(1, -5);
    addBodyObject(level, 50, ballAt(Vec2(-3, 4)));
    return level;
}

} // namespace

class SessionEditsTest : public QObject {
    Q_OBJECT

  private slots:
    void beforeTheFirstUpdateAnEditedLevelIsAFreshSessionOfIt() {
        Session edited(yard(), 5);
        edited.step(withLevel(std::make_shared<const Level>(rebuiltYard())));
        Session fresh(rebuiltYard(), 5);
        fresh.step(idle);
        QCOMPARE(edited.hash(), fresh.hash());
        stepOn(edited, 100);
        stepOn(fresh, 100);
        QCOMPARE(edited.hash(), fresh.hash());
    }
    void theSameLevelChangesNothing() {
        Session with(yard()), without(yard());
        for (int i = 0; i < 60; ++i) {
            with.step(withLevel(i % 2 == 0 ? readAgain(yard()) : std::make_shared<const Level>(yard())));
            without.step(idle);
        }
        QCOMPARE(with.hash(), without.hash());
    }
    void whetherPiecesAreSharedMakesNoDifference() {
        Session shared(yard()), read(yard());
        stepOn(shared, 40);
        stepOn(read, 40);
        const auto after = std::make_shared<const Level>(rebuiltYard());
        shared.step(withLevel(after));
        read.step(withLevel(readAgain(*after)));
        stepOn(shared, 50);
        stepOn(read, 50);
        QCOMPARE(shared.hash(), read.hash());
    }
    void howTheShipFliesAndWhetherBodiesSleepIsTakenOver() {
        Session session = towing(openSpace());
        auto tuned = std::make_shared<Level>(openSpace());
        tuned->rules.shipMass = 4;
        tuned->rules.thrust = 8;
        tuned->rules.rope.limit = 3;
        tuned->sleeping = false;
        const double speed = session.ship()->velocity.norm();
        session.adopt(tuned);
        QCOMPARE(session.phase(), Phase::Towing);
        QCOMPARE(session.ship()->mass, 4.0);
        QVERIFY(std::abs(session.ship()->velocity.norm() - speed) < 1e-12);
        QVERIFY(!session.world().data().sleep.allowed);
        double tension = 0;
        for (int i = 0; i < 40; ++i) {
            session.step(thrust);
            tension = std::max(tension, session.snapshot()->connectors.front().tension);
        }
        QVERIFY2(tension > 0 && tension <= 3 + 1e-9, qPrintable(QString::number(tension)));
        QVERIFY(session.ship()->velocity.norm() > 1); // 8 N against 4.25 kg and 0.8 s
    }
    void theNamesInTheLevelAreOfNoConcern() {
        Session session(yard()), other(yard());
        stepOn(session, 40);
        stepOn(other, 40);
        Level renamed = yard();
        Object box = *renamed.objects.find(boxKey);
        box.name = "chest";
        box.locked = true;
        renamed.objects.replace(renamed.objects.indexOf(boxKey), box);
        session.step(withLevel(std::make_shared<const Level>(renamed)));
        other.step(idle);
        QCOMPARE(session.hash(), other.hash());
    }
    void whatIsMovedGoesOnFromWhereItIsByAsMuch() {
        Session session(yard()), other(yard());
        stepOn(session, 20);
        stepOn(other, 20);
        const auto moved = edited<BodyObject>(yard(), ballKey, [](BodyObject& ball) {
            ball.position += Vec2(1, 5);
            ball.velocity += Vec2(0, 3);
        });
        const BodyState before = stateOf(session, ballKey);
        QVERIFY(before.pose.position.y() < 1.9);
        session.adopt(moved);
        const BodyState after = stateOf(session, ballKey);
        QVERIFY((after.pose.position - before.pose.position - Vec2(1, 5)).norm() < 1e-12);
        QVERIFY((after.velocity - before.velocity - Vec2(0, 3)).norm() < 1e-12);
        QVERIFY(session.bodyOf(ballKey) == other.bodyOf(ballKey)); // the very same body
    }
    void aStaticBodyStandsWhereTheLevelSays() {
        Session session(yard());
        stepOn(session, 300);
        QVERIFY(std::abs(stateOf(session, boxKey).pose.position.y() - 0.5) < 0.01);
        session.step(
            withLevel(edited<BodyObject>(yard(), floorKey, [](BodyObject& floor) { floor.position = Vec2(0, -3); })));
        QVERIFY(stateOf(session, floorKey).pose.position == Vec2(0, -3));
        stepOn(session, 300);
        QVERIFY(std::abs(stateOf(session, boxKey).pose.position.y() + 2.5) < 0.01);
        for (const double x : {0.7, 0.1, 1.1, 0.3}) { // to the bit, though 0.7 + (0.1 - 0.7) is not 0.1
            session.step(
                withLevel(edited<BodyObject>(yard(), floorKey, [x](BodyObject& floor) { floor.position.x() = x; })));
            QCOMPARE(stateOf(session, floorKey).pose.position.x(), x);
        }
    }
    void aMassIsChangedInPlace() {
        Session session(yard());
        stepOn(session, 20);
        const BodyState before = stateOf(session, ballKey);
        session.adopt(edited<BodyObject>(yard(), ballKey, [](BodyObject& ball) { ball.mass = 40; }));
        const BodyState after = stateOf(session, ballKey);
        QCOMPARE(after.mass, 40.0);
        QVERIFY((after.pose.position - before.pose.position).norm() < 1e-12);
        QVERIFY(after.velocity == before.velocity);
        session.step(idle);
        QCOMPARE(session.world().bodyCount(), 3);
        QVERIFY(session.connectorOf(springKey)); // fastened to the heavy one
        const ConnectorState spring = session.world().connector(*session.connectorOf(springKey));
        QVERIFY(spring.b == *session.bodyOf(ballKey));
        QVERIFY(std::abs(spring.length - 2) < 1e-9); // as at the start, not as it is stretched now
    }
    void aSpringKeepsTheLengthThatItHadAtTheStartWhateverIsMovedLater() {
        Session session(yard());
        stepOn(session, 5);
        const auto moved = edited<BodyObject>(yard(), ballKey, [](BodyObject& ball) { ball.position.x() += 1; });
        session.step(withLevel(moved));
        session.step(withLevel(edited<BodyObject>(*moved, ballKey, [](BodyObject& ball) { ball.mass = 40; })));
        QVERIFY(std::abs(session.world().connector(*session.connectorOf(springKey)).length - 2) < 1e-9);
    }
    void whatIsFrozenOrMadeIntangibleIsSoAtOnceAndSeenSo() {
        const Level level = *without(yard(), ballKey);
        Session session(level);
        stepOn(session, 5);
        const auto still = edited<BodyObject>(level, boxKey, [](BodyObject& box) { box.frozen = true; });
        session.step(withLevel(still));
        const double height = stateOf(session, boxKey).pose.position.y();
        stepOn(session, 20);
        QCOMPARE(stateOf(session, boxKey).pose.position.y(), height);
        session.step(withLevel(std::make_shared<const Level>(level)));
        stepOn(session, 20);
        QVERIFY(stateOf(session, boxKey).pose.position.y() < height - 0.1);
        session.step(withLevel(edited<BodyObject>(level, boxKey, [](BodyObject& box) {
            box.tangible = false;
            box.filter.tags = TagMask::bit(7);
        })));
        stepOn(session, 100);
        QVERIFY(stateOf(session, boxKey).pose.position.y() < -1); // through the floor
        const std::shared_ptr<const Snapshot> picture = session.snapshot();
        const BodyPicture* const box = picture->find([](const BodyPicture& one) { return one.look->key == boxKey; });
        QVERIFY(box != nullptr && !box->look->tangible);
        QCOMPARE(box->look->tags, TagMask::bit(7).bits);
    }
    void aMassThatCannotBeLeavesTheBodyAsItWas() {
        for (const double mass : {0.0, -1.0, std::nan(""), 1e-320}) {
            Session session(yard());
            stepOn(session, 20);
            const double before = stateOf(session, ballKey).mass;
            const auto bad = edited<BodyObject>(yard(), ballKey, [&](BodyObject& ball) { ball.mass = mass; });
            session.step(withLevel(bad));
            QCOMPARE(stateOf(session, ballKey).mass, before);
            const double height = stateOf(session, ballKey).pose.position.y();
            session.step(withLevel(edited<BodyObject>(*bad, ballKey, [](BodyObject& ball) { ball.mass = 2; })));
            QCOMPARE(stateOf(session, ballKey).mass, 2.0);
            QVERIFY(std::abs(stateOf(session, ballKey).pose.position.y() - height) < 0.2);
        }
    }
    void bodiesComeAndGo() {
        Session session(yard());
        stepOn(session, 20);
        Level more = yard();
        addBodyObject(more, 50, ballAt(Vec2(-5, 9)));
        session.step(withLevel(std::make_shared<const Level>(more)));
        QCOMPARE(session.world().bodyCount(), 4);
        QVERIFY(std::abs(stateOf(session, 50).pose.position.y() - 9) < 0.02);
        QCOMPARE(session.snapshot()->bodies(), std::size_t(4));
        session.step(withLevel(without(more, boxKey)));
        QCOMPARE(session.world().bodyCount(), 3);
        QVERIFY(!session.bodyOf(boxKey));
        QVERIFY(!session.connectorOf(springKey)); // went with it
        QVERIFY(session.world().connectors().empty());
        session.step(withLevel(std::make_shared<const Level>(more))); // undone
        QVERIFY(std::abs(stateOf(session, boxKey).pose.position.y() - 2) < 0.02);
        QVERIFY(session.connectorOf(springKey));
    }
    void connectorsComeGoAndChange() {
        Session session(yard());
        stepOn(session, 20);
        const auto stiff = edited<ConnectorObject>(yard(), springKey, [](ConnectorObject& spring) {
            spring.length = 1;
            spring.stiffness = 500;
        });
        session.step(withLevel(stiff));
        QCOMPARE(session.world().connectors().size(), std::size_t(1));
        QCOMPARE(session.world().connector(*session.connectorOf(springKey)).length, 1.0);
        QVERIFY(session.keyOf(*session.connectorOf(springKey)) == springKey);
        session.step(withLevel(without(*stiff, springKey)));
        QVERIFY(session.world().connectors().empty());
        QVERIFY(!session.connectorOf(springKey));
    }
    void gravityAndStepParametersChangeAtOnce() {
        Session session(yard());
        stepOn(session, 5);
        Level level = yard();
        level.gravity = Vec2(0, 3);
        level.iterations = 7;
        session.step(withLevel(std::make_shared<const Level>(level)));
        QVERIFY(session.world().parameters().gravity == Vec2(0, 3));
        QCOMPARE(session.world().parameters().iterations, 7);
    }
    void keysAndBodiesAreFoundFromEachOther() {
        Session session = towing(openSpace());
        QVERIFY(session.bodyOf(shipKey) == session.shipBody());
        QVERIFY(session.bodyOf(payloadKey) == session.payloadBody());
        QVERIFY(session.bodyOf(finishKey).has_value());
        QVERIFY(!session.bodyOf(77).has_value());
        QVERIFY(session.keyOf(*session.shipBody()) == shipKey);
        QVERIFY(session.rope().has_value());
        QVERIFY(session.keyOf(*session.rope()) == 0);
        press(session, tow);
        QVERIFY(!session.rope());
    }
    void anAttemptAfterACrashBeginsWithTheEditedLevel() {
        Session session(spaceWithCeiling());
        QVERIFY(holdUntil(session, thrust, Phase::Flying));
        const auto moved =
            edited<ShipObject>(spaceWithCeiling(), shipKey, [](ShipObject& ship) { ship.position = Vec2(-1, -0.5); });
        session.step({thrust, {}, moved});
        QVERIFY(std::abs(session.ship()->pose.position.x() + 1) < 1e-9); // it has been shifted while it flew
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        press(session, tow);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
        QVERIFY(session.ship()->pose.position == Vec2(-1, -0.5));
        QCOMPARE(session.lives(), 2);
        Session fresh(*moved);
        QCOMPARE(session.world().bodyCount(),
                 fresh.world().bodyCount() + static_cast<int>(count(session, BodyRole::Debris)));
    }
    void anAttemptAfterACrashHasTheBodiesOfTheEditedLevel() {
        Level level = spaceWithCeiling();
        addBodyObject(level, ballKey, ballAt(Vec2(5, 0)));
        Session session(level);
        QVERIFY(holdUntil(session, thrust, Phase::Flying));
        session.step({thrust, {}, edited<BodyObject>(level, ballKey, [](BodyObject& ball) {
                          ball.position = Vec2(6, 1);
                          ball.mass = 3;
                      })});
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        press(session, tow);
        QVERIFY(stateOf(session, ballKey).pose.position == Vec2(6, 1));
        QCOMPARE(stateOf(session, ballKey).mass, 3.0);
    }
    void aPayloadThatIsEditedWaitsOnAndOneThatIsLostStaysSo() {
        Level level = openSpace();
        level.gravity = Vec2(0, -1);
        Session session(level);
        hold(session, left, 10);
        const auto heavier = [&](double mass) {
            return edited<PayloadObject>(level, payloadKey, [mass](PayloadObject& payload) { payload.mass = mass; });
        };
        session.step({left, {}, heavier(2)});
        hold(session, left, 30);
        QCOMPARE(session.payloadState(), PayloadState::Waiting);
        QVERIFY(session.payload()->positionFrozen && session.payload()->pose.position == Vec2(0, -1));

        Session crashed(spaceWithCeiling());
        QVERIFY(holdUntil(crashed, thrust, Phase::Crashed));
        crashed.step(withLevel(without(spaceWithCeiling(), payloadKey)));
        crashed.step(withLevel(std::make_shared<const Level>(spaceWithCeiling())));
        QVERIFY(!crashed.payload()); // comes with the next attempt
        press(crashed, tow);
        QVERIFY(crashed.payload());
    }
    void gravityStaysTurnedOverWhenSomethingElseIsEdited() {
        Level level = openSpace();
        level.gravity = Vec2(0, -1);
        level.rules.flipGravityOnTow = true;
        Session session = towing(level);
        QVERIFY(session.world().parameters().gravity == Vec2(0, 1));
        level.gravity = Vec2(0, -2);
        session.step({thrust, {}, std::make_shared<const Level>(level)});
        QVERIFY(session.world().parameters().gravity == Vec2(0, 2));
    }
    void theTowedPayloadStaysOnItsRopeWhenItIsMadeHeavier() {
        Session session = towing(openSpace());
        hold(session, thrust, 30);
        const double length = session.world().connector(*session.rope()).length;
        session.step({thrust, {}, edited<PayloadObject>(openSpace(), payloadKey, [](PayloadObject& payload) {
                          payload.mass = 2;
                      })});
        QCOMPARE(session.phase(), Phase::Towing);
        QCOMPARE(session.payload()->mass, 2.0);
        QVERIFY(session.rope());
        QCOMPARE(session.world().connector(*session.rope()).length, length);
        QVERIFY(!session.payload()->positionFrozen);
        hold(session, thrust, 30);
        QVERIFY(session.payload()->pose.position.y() > -1);
    }
    void withoutItsShipALevelIsASandboxAndWithOneAGame() {
        Session session = towing(openSpace());
        session.step(withLevel(without(openSpace(), shipKey)));
        QCOMPARE(session.phase(), Phase::Sandbox);
        QVERIFY(!session.ship() && !session.rope());
        QVERIFY(session.world().connectors().empty());
        session.step(withLevel(std::make_shared<const Level>(openSpace())));
        QCOMPARE(session.phase(), Phase::AwaitingInput);
        press(session, left);
        QCOMPARE(session.phase(), Phase::Flying);
    }
    void withoutItsPayloadAShipFliesOnAlone() {
        Session session = towing(openSpace());
        session.step(withLevel(without(openSpace(), payloadKey)));
        QCOMPARE(session.phase(), Phase::Flying);
        QCOMPARE(session.payloadState(), PayloadState::Absent);
        QVERIFY(!session.payload());
        press(session, tow);
        QCOMPARE(session.phase(), Phase::Flying);
    }
    void theFinishCanBeMovedInFlight() {
        Session session = towing(openSpace());
        session.step({thrust, {}, edited<FinishObject>(openSpace(), finishKey, [](FinishObject& finish) {
                          finish.a.y() = finish.b.y() = 50;
                      })});
        hold(session, thrust, 200);
        QVERIFY(session.payload()->pose.position.y() > 3);
        QCOMPARE(session.phase(), Phase::Towing);
    }
    void aShipThatIsPutInAfterTheLastLifeBeginsWithLivesAndItsOwnTime() {
        Level once = spaceWithCeiling();
        once.rules.lives = 1;
        Session session(once);
        QVERIFY(holdUntil(session, thrust, Phase::GameOver));
        QCOMPARE(session.lives(), 0);
        session.step(withLevel(without(once, shipKey)));
        session.step(withLevel(std::make_shared<const Level>(once)));
        QCOMPARE(session.phase(), Phase::AwaitingInput);
        QCOMPARE(session.lives(), 1);
        QCOMPARE(session.time(), 0.0);
        QCOMPARE(session.fuel(), 0.0);
    }
    void livesAreGivenAndTaken() {
        Session session(openSpace());
        session.step(left);
        Level level = openSpace();
        level.rules.lives = 7;
        session.step({left, {}, std::make_shared<const Level>(level)});
        QCOMPARE(session.lives(), 7);
        level.rules.lives = 1;
        session.step({left, {}, std::make_shared<const Level>(level)});
        QCOMPARE(session.lives(), 1);
    }
    void aTagThatIsTakenFromABodyIsSeen() {
        const std::shared_ptr<const Level> alone = without(yard(), ballKey);
        Session session(*alone);
        stepOn(session, 300);
        const auto ghostly = edited<BodyObject>(*alone, boxKey, [](BodyObject& box) { box.filter.touches = {}; });
        session.step(withLevel(ghostly));
        stepOn(session, 100);
        QVERIFY(stateOf(session, boxKey).pose.position.y() < -1); // falls through the floor
    }
};

SPACETOW_TEST(SessionEditsTest)
#include "session_edits_test.moc"
