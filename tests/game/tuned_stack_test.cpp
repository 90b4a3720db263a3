// A body whose mass or material is tuned while it runs goes on with its contacts.

#include "core/game/session.h"
#include "tests/support/live_level.h"
#include "tests/support/test_main.h"

#include <functional>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr Key lowest = 100, crates = 5, weightKey = 200, hookKey = 201;

/// A stack of crates on a floor, and beside it a ball that hangs from a hook by a spring.
Level stackLevel() {
    Level level;
    level.gravity = Vec2(0, -10);
    level.iterations = 4;
    addBodyObject(level, floorKey, {.shapes = {LineChain{{{-20, 0}, {20, 0}}, false}}});
    const BodyObject crate = std::get<BodyObject>(yard().objects.find(boxKey)->data);
    for (Key key = lowest; key < lowest + crates; ++key) {
        BodyObject box = crate;
        box.position = Vec2(key % 2 == 0 ? 0 : 0.02, 0.5 + static_cast<double>(key - lowest));
        addBodyObject(level, key, box);
    }
    addBodyObject(level, hookKey, {.shapes = {Circle{{0, 0}, 0.1}}, .position = Vec2(5, 5)});
    addBodyObject(level, weightKey, ballAt(Vec2(5, 4)));
    level.objects.append({springKey, "", ConnectorObject{.a = hookKey, .b = weightKey, .stiffness = 30}, {}});
    return level;
}

using Edit = std::function<std::shared_ptr<const Level>(const Level&)>;

Edit ofCrate(const std::function<void(BodyObject&)>& change, Key above = 2) {
    return [change, above](const Level& level) { return edited<BodyObject>(level, lowest + above, change); };
}

Edit withMass(double mass, Key above) {
    return ofCrate([mass](BodyObject& box) { box.mass = mass; }, above);
}

const std::pair<const char*, Edit> edits[] = {
    {"more friction", ofCrate([](BodyObject& box) { box.friction = 0.9; })},
    {"more mass", ofCrate([](BodyObject& box) { box.mass = 3; })},
    {"less mass", ofCrate([](BodyObject& box) { box.mass = 0.2; })},
    {"thirty times the mass in the middle", withMass(30, 2)},
    {"thirty times the mass at the top", withMass(30, 4)},
    {"three hundred times the mass in the middle", withMass(300, 2)},
    {"a thousandth of the mass in the middle", withMass(0.001, 2)},
    {"a hundredth of the mass at the bottom", withMass(0.01, 0)},
    {"density", ofCrate([](BodyObject& box) { box.density = 2; })},
    {"restitution", ofCrate([](BodyObject& box) { box.restitution = 0.5; })},
    {"linear damping", ofCrate([](BodyObject& box) { box.linearDamping = 1; })},
    {"angular damping", ofCrate([](BodyObject& box) { box.angularDamping = 1; })},
    {"the friction of the floor",
     [](const Level& level) {
         return edited<BodyObject>(level, floorKey, [](BodyObject& floor) { floor.friction = 0.9; });
     }},
    {"a spring beside it",
     [](const Level& level) {
         return edited<ConnectorObject>(level, springKey, [](ConnectorObject& spring) { spring.stiffness = 90; });
     }},
    {"what hangs beside it",
     [](const Level& level) {
         return edited<BodyObject>(level, weightKey, [](BodyObject& weight) { weight.mass = 2; });
     }},
};

} // namespace

class TunedStackTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsTunedInARestingStackIsNotSeenToMove_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < static_cast<int>(std::size(edits)); ++i) {
            QTest::newRow(edits[i].first) << i;
        }
    }
    void whatIsTunedInARestingStackIsNotSeenToMove() {
        QFETCH(int, index);
        const Level level = stackLevel();
        Session session(level);
        stepOn(session, 400);
        std::vector<BodyState> rested;
        for (Key key = lowest; key < lowest + crates; ++key) {
            rested.push_back(stateOf(session, key));
        }
        const int bodies = session.world().bodyCount();
        session.step(withLevel(edits[index].second(level)));
        QCOMPARE(session.world().bodyCount(), bodies);
        QVERIFY(session.world().events().began.empty() && session.world().events().ended.empty());
        double shift = 0; // m
        double speed = 0; // m/s
        for (int i = 0; i < 150; ++i) {
            for (Key key = lowest; key < lowest + crates; ++key) {
                const BodyState box = stateOf(session, key);
                shift = std::max(shift, (box.pose.position - rested[key - lowest].pose.position).norm());
                speed = std::max(speed, box.velocity.norm());
            }
            session.step(idle);
        }
        QVERIFY2(shift < 1e-4 && speed < 0.01, qPrintable(QString("%1 m, %2 m/s").arg(shift).arg(speed)));
    }
};

SPACETOW_TEST(TunedStackTest)
#include "tuned_stack_test.moc"
