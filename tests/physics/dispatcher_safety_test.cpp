#include "core/base/random.h"
#include "tests/support/dispatch_scene.h"

#include <cstdlib>
#include <optional>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Balls between two walls whose handlers do whatever comes to mind.
struct Chaos : DispatchScene {
    Random random;
    std::vector<BodyId> bodies{addWall(-2), addWall(2)};
    std::set<BodyId> handled; // what the dispatcher should know
    int told = 0;             // of removals
    bool asExpected = true;

    explicit Chaos(std::uint64_t seed) : random(seed) {
        for (int i = 0; i < 25; ++i) {
            bodies.push_back(addBall({-1.5 + 0.6 * (i % 5), -1.5 + 0.6 * (i / 5)}, anyVelocity(), true));
        }
        for (const BodyId id : bodies) {
            handle(id);
        }
    }
    bool isConsistent() const {
        return asExpected && std::all_of(bodies.begin(), bodies.end(), [this](BodyId id) {
                   return dispatcher.contains(id) == handled.contains(id) &&
                          (world.contains(id) || !handled.contains(id));
               });
    }

  private:
    Vec2 anyVelocity() { return {random.uniform(-9, 9), random.uniform(-9, 9)}; }
    Vec2 anyPlace() { return {random.uniform(-1, 1), random.uniform(-3, 3)}; }
    bool coin() { return random.below(2) == 0; }

    void handle(BodyId id) {
        handled.insert(id);
        dispatcher.set(id, {[this, id](BodyId, const TouchEvent&) { hear(id); }, [this, id](TagMask, int) { hear(id); },
                            [this, id] {
                                ++told;
                                asExpected &= handled.erase(id) == 1 && !world.contains(id);
                                doAnything();
                            }});
    }
    void hear(BodyId id) {
        asExpected &= handled.contains(id);
        doAnything();
    }
    void doAnything() {
        const BodyId id = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
        const std::uint32_t deed = random.below(9);
        if (deed == 0 && bodies.size() < 60) {
            bodies.push_back(addBall(anyPlace(), anyVelocity(), true));
            handle(bodies.back());
        } else if (deed == 1) {
            handled.erase(id);
            dispatcher.remove(id);
        } else if (world.contains(id)) {
            change(id, deed);
        }
    }
    void change(BodyId id, std::uint32_t deed) {
        switch (deed) {
        case 2:
            handle(id);
            break;
        case 3:
            world.removeBody(id);
            break;
        case 4:
            world.setActive(id, coin());
            break;
        case 5:
            world.setTangible(id, coin());
            break;
        case 6:
            world.setFrozen(id, coin());
            break;
        case 7:
            world.setVelocity(id, anyVelocity(), 1);
            break;
        default:
            world.setPose(id, anyPlace(), 0);
            break;
        }
    }
};

} // namespace

class DispatcherSafetyTest : public QObject {
    Q_OBJECT

  private slots:
    void aHandlerMayRemoveItsBodyAndTheOther() {
        Hit hit;
        hit.record(hit.wall);
        int removed = 0;
        hit.dispatcher.set(hit.ball, {.touched =
                                          [&](BodyId other, const TouchEvent&) {
                                              hit.world.removeBody(hit.ball);
                                              hit.world.removeBody(other);
                                          },
                                      .removed =
                                          [&] {
                                              ++removed;
                                              QVERIFY(!hit.world.contains(hit.ball));
                                              QVERIFY(!hit.dispatcher.contains(hit.ball));
                                          }});
        hit.step(20);
        QCOMPARE(removed, 1);
        QCOMPARE(hit.count(Call::What::Removed, hit.wall), 1);
        QCOMPARE(hit.world.bodyCount(), 0);
    }

    void aHandlerMaySetFlagsAndTheyHoldFromTheNextUpdate_data() {
        QTest::addColumn<QString>("flag");
        for (const char* flag : {"frozen", "inactive", "intangible"}) {
            QTest::newRow(flag) << QString(flag);
        }
    }
    void aHandlerMaySetFlagsAndTheyHoldFromTheNextUpdate() {
        QFETCH(QString, flag);
        Hit hit;
        std::optional<Vec2> at;
        hit.onTouch(hit.ball, [&](BodyId, const TouchEvent&) {
            if (at) {
                return; // touches again on its way through
            }
            hit.world.setFrozen(hit.ball, flag == "frozen");
            hit.world.setActive(hit.ball, flag != "inactive");
            hit.world.setTangible(hit.ball, flag != "intangible");
            hit.world.setVelocity(hit.ball, {5, 0}, 0);
            at = hit.world.body(hit.ball).massCenter;
        });
        while (!at) {
            hit.step();
        }
        hit.step(5);
        const double way = hit.world.body(hit.ball).massCenter.x() - at->x();
        QVERIFY(std::abs(way - (flag == "intangible" ? 0.5 : 0)) < 1e-9); // on through the wall, or not at all
        QCOMPARE(hit.world.body(hit.ball).active, flag != "inactive");
    }

    void aHandlerMaySetABodyFree() {
        Hit hit;
        const BodyId held = hit.addBall({0, 3}, {0, 0});
        hit.world.setFrozen(held, true);
        hit.onTouch(hit.ball, [&](BodyId, const TouchEvent&) { hit.world.setFrozen(held, false); });
        for (int i = 0; i < 20; ++i) {
            hit.world.applyForce(held, {100, 0});
            hit.step();
        }
        QVERIFY(hit.world.body(held).velocity.x() > 1);
    }

    void aHandlerMayAddBodiesWithHandlersOfTheirOwn() {
        Hit hit;
        std::vector<BodyId> added;
        hit.onTouch(hit.wall, [&](BodyId, const TouchEvent&) {
            if (!added.empty()) {
                return;
            }
            for (int i = 0; i < 500; ++i) {
                added.push_back(hit.addBall({0.7, 10.0 + i}, {5, 0}));
                hit.record(added.back());
            }
            added.push_back(hit.addBall({0.5, 3}, {5, 0}));
            hit.record(added.back());
        });
        hit.step(30);
        QCOMPARE(added.size(), std::size_t{501});
        QCOMPARE(hit.count(Call::What::Touched, added.back()), 1);
        QCOMPARE(hit.calls.size(), std::size_t{1});
    }

    void aHandlerMayRemoveReplaceAndSetHandlers_data() {
        QTest::addColumn<QString>("deed");
        for (const char* deed : {"removes itself", "removes the other", "replaces itself", "sets the other"}) {
            QTest::newRow(deed) << QString(deed);
        }
    }
    void aHandlerMayRemoveReplaceAndSetHandlers() {
        QFETCH(QString, deed);
        Hit hit;
        if (deed == "removes the other") {
            hit.record(hit.ball);
        }
        const auto secret = std::make_shared<int>(7); // lives in the handler, which must survive its own removal
        int heard = 0;
        hit.onTouch(hit.wall, [&hit, &heard, &deed, secret](BodyId other, const TouchEvent&) {
            if (deed == "removes itself") {
                hit.dispatcher.remove(hit.wall);
            } else if (deed == "replaces itself") {
                hit.record(hit.wall);
            } else if (deed == "removes the other") {
                hit.dispatcher.remove(other);
            } else {
                hit.record(other);
            }
            heard += *secret;
        });
        hit.addWall(-1); // the ball flies to and fro
        hit.step(100);
        QVERIFY(heard >= 7);
        QCOMPARE(hit.dispatcher.contains(hit.wall), deed != "removes itself");
        if (deed == "removes itself" || deed == "replaces itself") {
            QCOMPARE(heard, 7);
        }
        if (deed == "replaces itself") {
            QVERIFY(hit.count(Call::What::Touched, hit.wall) >= 1);
        }
        QCOMPARE(hit.count(Call::What::Touched, hit.ball) > 0, deed == "sets the other");
        if (deed == "sets the other") {
            QVERIFY(hit.calls.front().other == hit.wall); // the rest of the same touch
        }
    }

    void aHandlerMayUpdateTheWorldOrReplaceIt_data() {
        QTest::addColumn<bool>("replace");
        QTest::newRow("update") << false;
        QTest::newRow("replace") << true;
    }
    void aHandlerMayUpdateTheWorldOrReplaceIt() {
        QFETCH(bool, replace);
        Hit hit;
        hit.record(hit.ball);
        int touches = 0;
        hit.onTouch(hit.wall, [&](BodyId, const TouchEvent&) {
            ++touches;
            if (replace) {
                hit.world = World();
            } else {
                run(hit.world, 0.2);
            }
        });
        hit.step(20);
        QCOMPARE(touches, 1);
        QCOMPARE(hit.count(Call::What::Touched, hit.ball), 1);
        QCOMPARE(hit.count(Call::What::Removed, hit.ball), replace ? 1 : 0);
        QCOMPARE(hit.dispatcher.contains(hit.wall), !replace);
    }

    void handlersThatDoAnythingBreakNothing() {
        const std::uint64_t rounds = std::getenv("SPACETOW_FULL") != nullptr ? 2000 : 40;
        qInfo("seeds 1 to %llu", static_cast<unsigned long long>(rounds));
        int told = 0;
        for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
            Chaos chaos(seed);
            for (int update = 0; update < 15; ++update) {
                chaos.step();
                QVERIFY2(chaos.isConsistent(), qPrintable(QString("seed %1, update %2").arg(seed).arg(update)));
            }
            told += chaos.told;
        }
        QVERIFY(told > static_cast<int>(rounds));
    }
};

SPACETOW_TEST(DispatcherSafetyTest)
#include "dispatcher_safety_test.moc"
