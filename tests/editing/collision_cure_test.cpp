#include "editor/editing/collision_cure.h"

#include "core/game/session.h"
#include "tests/support/test_main.h"

using namespace spacetow;

namespace {

Object curedBody(Key key, const Filter& filter, BodyKind kind = BodyKind::Dynamic) {
    BodyObject made;
    made.kind = kind;
    made.shapes = {Circle{{0, 0}, 0.5}};
    made.filter = filter;
    return {key, {}, made, {}};
}

Level levelWith(const std::vector<Object>& objects) {
    Level level;
    level.gravity = {0, 0};
    for (const Object& object : objects) {
        level.objects.append(object);
    }
    return level;
}

ApartObjects apartIn(const Level& level, Key a, Key b) {
    Session session(level);
    session.step(Controls{});
    const BodyId first = *session.bodyOf(a);
    const BodyId second = *session.bodyOf(b);
    ApartObjects apart{a, b, false, 0, whyNotColliding(session.world(), first, second)};
    apart.isAboutB = apart.answer.body == second;
    for (const ConnectorId connector : apart.answer.connectors) {
        apart.connector = session.keyOf(connector);
    }
    return apart;
}

/// Cured until nothing is offered any more; whether they touch then.
bool touchWhenCured(Level level, Key a, Key b, int mostCures) {
    for (int i = 0; i <= mostCures; ++i) {
        const ApartObjects apart = apartIn(level, a, b);
        if (apart.answer.why == WhyApart::Touch) {
            return true;
        }
        const std::optional<CollisionCure> cure = cureOf(level, apart);
        if (!cure) {
            return false;
        }
        level = cured(level, *cure);
    }
    return false;
}

} // namespace

class CollisionCureTest : public QObject {
    Q_OBJECT

  private slots:
    void aTagThatIsNotTouchedIsTicked() {
        const Level level = levelWith({curedBody(1, {{1}, {1}}), curedBody(2, {{6}, TagMask::all()})});
        const std::optional<CollisionCure> cure = cureOf(level, apartIn(level, 1, 2));
        QVERIFY(cure && cure->kind == CollisionCure::Kind::TickTag);
        QCOMPARE(cure->object, Key(1));
        QCOMPARE(cure->tag, 1);
        const Level after = cured(level, *cure);
        QCOMPARE(std::get<BodyObject>(after.objects[0].data).filter.touches.bits, 3U);
        QVERIFY(after.objects[1] == level.objects[1]);
        QVERIFY(touchWhenCured(level, 1, 2, 1));
    }

    void bothMasksTakeTwoSteps() {
        const Level level = levelWith({curedBody(1, {{1}, {0}}), curedBody(2, {{2}, {0}})});
        QVERIFY(!touchWhenCured(level, 1, 2, 1));
        QVERIFY(touchWhenCured(level, 1, 2, 2));
    }

    void whatHasNoTagsGetsOne() {
        const Level level = levelWith({curedBody(1, {{1}, {4}}), curedBody(2, {{0}, TagMask::all()})});
        const std::optional<CollisionCure> cure = cureOf(level, apartIn(level, 1, 2));
        QVERIFY(cure && cure->kind == CollisionCure::Kind::GiveTag);
        QCOMPARE(cure->object, Key(2));
        QCOMPARE(cure->tag, 2);
        QVERIFY(touchWhenCured(level, 1, 2, 1));
    }

    void whatTheRulesDecideIsCuredAtTheOther() {
        Level level = levelWith({curedBody(1, {TagMask::bit(9), TagMask::all()}, BodyKind::Static)});
        level.objects.append({2, {}, ShipObject{}, {}});
        const std::optional<CollisionCure> cure = cureOf(level, apartIn(level, 1, 2));
        QVERIFY(cure && cure->kind == CollisionCure::Kind::GiveTag);
        QCOMPARE(cure->object, Key(1));
        QCOMPARE(cure->tag, wallTag);
    }

    void anIntangibleOneBecomesSolidAndAConnectorLetsThem() {
        Object ghost = curedBody(2, {});
        std::get<BodyObject>(ghost.data).tangible = false;
        QVERIFY(touchWhenCured(levelWith({curedBody(1, {}), ghost}), 1, 2, 1));
        Level joined = levelWith({curedBody(1, {}), curedBody(2, {})});
        joined.objects.append({3, {}, ConnectorObject{.a = 1, .b = 2}, {}});
        const std::optional<CollisionCure> cure = cureOf(joined, apartIn(joined, 1, 2));
        QVERIFY(cure && cure->kind == CollisionCure::Kind::LetCollide);
        QCOMPARE(cure->object, Key(3));
        QVERIFY(touchWhenCured(joined, 1, 2, 1));
    }

    void aDistanceHasNoCure() {
        Object far = curedBody(2, {});
        std::get<BodyObject>(far.data).position = {5, 0};
        const Level level = levelWith({curedBody(1, {}), far});
        QVERIFY(!cureOf(level, apartIn(level, 1, 2)));
        QVERIFY(!cureOf(level, apartIn(level, 1, 1)));
    }
};

SPACETOW_TEST(CollisionCureTest)
#include "collision_cure_test.moc"
