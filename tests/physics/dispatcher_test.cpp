#include "core/physics/query/dispatcher.h"

#include "core/base/random.h"
#include "tests/support/dispatch_scene.h"

#include <optional>

using namespace spacetow;
using namespace spacetow::test;

class DispatcherTest : public QObject {
    Q_OBJECT

  private slots:
    void bothBodiesHearThatTheyTouchTheOlderFirst() {
        Hit hit;
        hit.record(hit.ball);
        hit.record(hit.wall);
        std::optional<TouchEvent> event;
        for (int i = 0; i < 20 && !event; ++i) {
            QVERIFY(hit.calls.empty());
            hit.step();
            if (!hit.world.events().began.empty()) {
                event = hit.world.events().began.front();
            }
        }
        QVERIFY(event.has_value());
        const std::vector<Call> expected{{Call::What::Touched, hit.wall, hit.ball, event->iteration, {}},
                                         {Call::What::Touched, hit.ball, hit.wall, event->iteration, {}}};
        QVERIFY(hit.calls == expected);
        hit.step(20);
        QCOMPARE(hit.calls.size(), std::size_t{2});
    }

    void theTouchSaysWhetherItIsSolid() {
        DispatchScene scene;
        BodyDef zone = lineBody({1, -5}, {1, 5});
        zone.tangible = false;
        const BodyId gate = add(scene.world, zone);
        const BodyId ball = scene.addBall({0, 0}, {5, 0});
        int touches = 0;
        scene.onTouch(gate, [&](BodyId other, const TouchEvent& touch) {
            ++touches;
            QVERIFY(other == ball && touch.a == gate && touch.b == ball && !touch.solid);
        });
        scene.step(20);
        QCOMPARE(touches, 1);
        QCOMPARE(scene.world.body(ball).velocity.x(), 5.0);
    }

    void tagsAreThoseOfThisIterationAndNothingIsLatched() {
        DispatchScene scene;
        scene.world.setParameters(withIterations(10, {0, -10}));
        BodyDef ground = floorOf("edge");
        ground.filter.tags = wallMask;
        add(scene.world, ground);
        const BodyId ball = scene.addBall({0, 0.3}, {0, 0}, true);
        const BodyId silent = scene.addBall({3, 0.3}, {0, 0}, false);
        for (const BodyId id : {ball, silent}) {
            scene.record(id);
        }
        run(scene.world, 2); // both lie on the ground
        scene.step();
        QCOMPARE(scene.count(Call::What::Tags, ball), 10);
        QCOMPARE(scene.count(Call::What::Tags, silent), 0);
        for (int i = 0; i < 10; ++i) {
            const Call& call = scene.calls[static_cast<std::size_t>(i)];
            QVERIFY(call.iteration == i && call.tags == wallMask);
        }
        scene.world.setVelocity(ball, {0, 10}, 0);
        scene.step();
        scene.calls.clear();
        scene.step();
        QVERIFY(scene.calls.empty());
    }

    void aRemovedBodyHearsItOnceAndIsForgotten() {
        Hit hit;
        hit.record(hit.ball);
        hit.record(hit.wall);
        hit.world.removeBody(hit.ball);
        hit.step(3);
        const std::vector<Call> expected{{Call::What::Removed, hit.ball, {}, 0, {}}};
        QVERIFY(hit.calls == expected);
        QVERIFY(!hit.dispatcher.contains(hit.ball) && hit.dispatcher.contains(hit.wall));
    }

    void aRemovalThatWasNotDispatchedIsToldLater() {
        Hit hit;
        hit.record(hit.ball);
        hit.world.removeBody(hit.ball);
        hit.world.update();
        hit.step(3);
        QCOMPARE(hit.count(Call::What::Removed, hit.ball), 1);
        QVERIFY(!hit.dispatcher.contains(hit.ball));
        hit.record(hit.wall);
        hit.world = World();
        hit.step(2);
        QCOMPARE(hit.count(Call::What::Removed, hit.wall), 1);
    }

    void aBodyInTheSamePlaceIsAnotherBody() {
        Hit hit;
        hit.record(hit.ball);
        hit.world.removeBody(hit.ball);
        hit.step();
        const BodyId next = hit.addBall({0, 0}, {5, 0});
        QCOMPARE(next.index, hit.ball.index);
        hit.calls.clear();
        hit.step(20);
        QVERIFY(hit.calls.empty());
    }

    void missingFunctionsAreSkipped() {
        Hit hit;
        hit.dispatcher.set(hit.ball, {});
        hit.step(20);
        hit.world.removeBody(hit.ball);
        hit.step();
        QVERIFY(!hit.dispatcher.contains(hit.ball));
    }

    void callsComeInTheOrderOfIterationsTouchesTagsRemovals();
};

void DispatcherTest::callsComeInTheOrderOfIterationsTouchesTagsRemovals() {
    const std::uint64_t seed = 20260;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    Random random(seed);
    DispatchScene scene;
    const auto record = [&](BodyId id) { scene.record(id); };
    for (const double x : {-3.0, 3.0}) {
        record(scene.addWall(x));
    }
    std::vector<BodyId> balls;
    for (int i = 0; i < 40; ++i) {
        const Vec2 at(-2.6 + 0.55 * (i % 10), 0.55 * (i / 10));
        balls.push_back(scene.addBall(at, {random.uniform(-8, 8), random.uniform(-1, 1)}, i % 2 == 0));
        record(balls.back());
    }
    int touches = 0;
    int both = 0; // updates with tags before a touch of a later iteration
    for (int update = 0; update < 60; ++update) {
        if (update % 6 == 0) {
            scene.world.removeBody(balls[static_cast<std::size_t>(update / 6)]);
        }
        scene.calls.clear();
        scene.step();
        const Events& events = scene.world.events();
        std::vector<Call> expected;
        for (int iteration = -1; iteration < 10; ++iteration) {
            for (const TouchEvent& e : events.began) {
                if (e.iteration == iteration) {
                    both += !expected.empty() && expected.back().what == Call::What::Tags ? 1 : 0;
                    expected.push_back({Call::What::Touched, e.a, e.b, iteration, {}});
                    expected.push_back({Call::What::Touched, e.b, e.a, iteration, {}});
                    ++touches;
                }
            }
            for (const TagsTouchedEvent& e : events.tagsTouched) {
                if (e.iteration == iteration) {
                    expected.push_back({Call::What::Tags, e.body, {}, iteration, e.tags});
                }
            }
            for (const RemovedEvent& e : events.removed) {
                if (e.iteration == iteration) {
                    expected.push_back({Call::What::Removed, e.body, {}, 0, {}});
                }
            }
        }
        QVERIFY(scene.calls == expected);
    }
    QVERIFY2(touches > 50 && both > 5, qPrintable(QString("%1 %2").arg(touches).arg(both)));
}

SPACETOW_TEST(DispatcherTest)
#include "dispatcher_test.moc"
