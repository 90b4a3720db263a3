// A body whose mass or material is tuned while it runs begins its contacts anew. Nobody is to see that.

#include "core/game/session.h"
#include "tests/support/live_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class TunedStackTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsTunedInARestingStackIsNotSeenToHop_data() {
        QTest::addColumn<int>("what");
        QTest::newRow("friction") << 0;
        QTest::newRow("more mass") << 1;
        QTest::newRow("less mass") << 2;
        QTest::newRow("restitution") << 3;
        QTest::newRow("damping") << 4;
    }
    void whatIsTunedInARestingStackIsNotSeenToHop() {
        QFETCH(int, what);
        Level level;
        level.gravity = Vec2(0, -10);
        level.iterations = 4;
        addBodyObject(level, floorKey, {.shapes = {LineChain{{{-20, 0}, {20, 0}}, false}}});
        const BodyObject crate = std::get<BodyObject>(yard().objects.find(boxKey)->data);
        for (Key key = 100; key < 105; ++key) {
            BodyObject box = crate;
            box.position = Vec2(key % 2 == 0 ? 0 : 0.02, 0.5 + static_cast<double>(key - 100));
            addBodyObject(level, key, box);
        }
        Session session(level);
        stepOn(session, 400);
        std::vector<Vec2> rested;
        for (Key key = 100; key < 105; ++key) {
            rested.push_back(stateOf(session, key).pose.position);
        }
        session.step(withLevel(edited<BodyObject>(level, 102, [what](BodyObject& box) {
            box.friction = what == 0 ? 0.9 : box.friction;
            box.mass = what == 1 ? std::optional(3.0) : what == 2 ? std::optional(0.2) : box.mass;
            box.restitution = what == 3 ? 0.5 : box.restitution;
            box.linearDamping = what == 4 ? 1 : box.linearDamping;
        })));
        for (int i = 0; i < 150; ++i) {
            for (Key key = 100; key < 105; ++key) {
                const BodyState box = stateOf(session, key);
                QVERIFY((box.pose.position - rested[key - 100]).norm() < 5e-4); // a twentieth of a pixel
                QVERIFY(box.velocity.norm() < 0.01);
            }
            session.step(idle);
        }
    }
};

SPACETOW_TEST(TunedStackTest)
#include "tuned_stack_test.moc"
