#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

#include "core/base/random.h"

#include <malloc.h>
#include <map>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int most = 40; // bodies

/// A closed room in which balls, boxes and zones are thrown about, and a host that answers events with changes.
struct Host {
    World world;
    Random random;
    std::map<std::uint32_t, BodyId> known;    // of all bodies that should be there, by `user`
    std::map<std::uint32_t, BodyId> leaving;  // whose removal has been asked for
    std::map<std::uint32_t, Transform> still; // inactive or wholly frozen since before the update
    std::uint32_t nextUser = 1;
    bool failed = false;

    Host(std::uint64_t seed, int iterations) : world(withIterations(iterations)), random(seed) {
        BodyDef room{.kind = BodyKind::Static};
        room.shapes = {Edge{{-3, 0}, {3, 0}}, Edge{{3, 0}, {3, 8}}, Edge{{3, 8}, {-3, 8}}, Edge{{-3, 8}, {-3, 0}}};
        room.restitution = 0.8;
        addBody(room);
        for (int i = 0; i < 12; ++i) {
            addBody(randomBody());
        }
    }

    BodyDef randomBody() {
        const Vec2 at(random.uniform(-2, 2), random.uniform(1, 7));
        BodyDef def =
            random.below(2) == 0 ? ball(at, random.uniform(0.1, 0.4)) : box(at, random.uniform(0.1, 0.4), 0.2);
        def.kind = random.below(5) == 0 ? static_cast<BodyKind>(random.below(2)) : BodyKind::Dynamic;
        def.velocity = {random.uniform(-5, 5), random.uniform(-5, 5)};
        def.restitution = random.unit();
        def.tangible = random.below(4) != 0;
        def.active = random.below(6) != 0;
        def.positionFrozen = random.below(8) == 0;
        def.rotationFrozen = random.below(8) == 0;
        def.reportsTouches = random.below(3) == 0;
        return def;
    }

    void addBody(BodyDef def) {
        def.user = nextUser;
        known.emplace(nextUser++, add(world, def));
    }

    BodyId any() {
        auto it = known.begin();
        std::advance(it, random.below(static_cast<std::uint32_t>(known.size())));
        return it->second;
    }

    void remove(BodyId id) {
        if (world.body(id).kind == BodyKind::Static && world.shapes(id).size() > 1) {
            return; // the room itself stays
        }
        world.removeBody(id);
        leaving.emplace(static_cast<std::uint32_t>(world.body(id).user), id);
    }

    /// One change of anything, to a body that took part in an event or to any other.
    void change(BodyId id) {
        if (!world.contains(id)) {
            id = any();
        }
        switch (random.below(14)) {
        case 0:
            return remove(id);
        case 1:
            remove(id);
            return remove(id);
        case 2:
            return world.setActive(id, random.below(2) == 0);
        case 3:
            return world.setFrozen(id, random.below(2) == 0);
        case 4:
            return world.setFrozen(id, random.below(2) == 0, random.below(2) == 0);
        case 5:
            return world.setTangible(id, random.below(2) == 0);
        case 6:
            return world.setFilter(id, {TagMask{random.next()}, TagMask{random.next()}});
        case 7:
            return random.below(10) == 0 && world.shapes(id).size() == 1
                       ? world.setPose(id, {random.uniform(-2, 2), random.uniform(1, 7)}, random.uniform(-3, 3))
                       : world.setVelocity(id, {random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(-9, 9));
        case 8:
        case 9:
            return connect(id, any());
        case 10:
            return setMaterial(id);
        case 11:
            return connectElsewhere(id);
        case 12:
            return known.size() < most ? addBody(randomBody()) : remove(id);
        default:
            static_cast<void>(world.applyForce(id, {random.uniform(-50, 50), random.uniform(-50, 50)}));
        }
    }

    void connect(BodyId a, BodyId b) {
        if (random.below(3) == 0 && !world.connectors().empty()) {
            world.removeConnector(world.connectors().front());
        }
        const bool made = bool(world.addConnector({.a = a, .b = b, .stiffness = 50, .damping = 1}));
        failed |= made != (a != b);
    }

    void setMaterial(BodyId id) {
        failed |= !world.setMaterial(id, {.mass = random.uniform(0.1, 10),
                                          .restitution = random.unit(),
                                          .friction = random.unit(),
                                          .linearDamping = random.unit()});
    }

    void connectElsewhere(BodyId a) {
        const BodyId b = any();
        if (!world.connectors().empty()) {
            const bool made =
                bool(world.setConnector(world.connectors().front(), {.a = a, .b = b, .stiffness = 80, .slack = true}));
            failed |= made != (a != b);
        }
    }

    void answerEvents() {
        const Events events = world.events();
        for (const TouchEvent& event : events.began) {
            change(random.below(2) == 0 ? event.a : event.b);
        }
        for (const TouchEvent& event : events.ended) {
            change(event.a);
        }
        for (const TagsTouchedEvent& event : events.tagsTouched) {
            change(event.body);
            if (random.below(4) != 0) {
                break;
            }
        }
        for (const RemovedEvent& event : events.removed) {
            change(event.body);
        }
        change(any());
    }

    void rememberWhatIsStill() {
        still.clear();
        for (const auto& [user, id] : known) {
            const BodyState state = world.body(id);
            if (!state.active || (state.positionFrozen && state.rotationFrozen)) {
                still.emplace(user, state.pose);
            }
        }
    }

    /// What must be true after each update, or the first thing that is not.
    QString complaint() {
        for (const RemovedEvent& event : world.events().removed) {
            const auto user = static_cast<std::uint32_t>(event.user);
            if (leaving.erase(user) != 1 || known.at(user) != event.body || world.contains(event.body)) {
                return QString("body %1 is reported as removed").arg(user);
            }
            known.erase(user);
        }
        if (!leaving.empty() || static_cast<int>(known.size()) != world.bodyCount()) {
            return QString("a removal was not carried out or not reported");
        }
        for (const ConnectorId id : world.connectors()) {
            if (!world.contains(world.connector(id).a) || !world.contains(world.connector(id).b)) {
                return QString("a connector outlived its body");
            }
        }
        for (const auto& [user, id] : known) {
            const BodyState state = world.body(id);
            if (state.user != user || !isFinite(state.massCenter) || !isFinite(state.velocity)) {
                return QString("body %1 is not what it was").arg(user);
            }
        }
        return failed ? QString("a connector was wrongly refused or made") : QString();
    }
};

/// Those that were still before the update and were asked to remain so have not moved.
QString movedThough(const Host& host) {
    for (const auto& [user, pose] : host.still) {
        const auto it = host.known.find(user);
        if (it == host.known.end()) {
            continue;
        }
        const BodyState now = host.world.body(it->second);
        const bool stillStill = !now.active || (now.positionFrozen && now.rotationFrozen);
        const double turn = std::remainder(now.angle - pose.rotation.angle(), 2 * pi);
        if (stillStill && (now.pose.position != pose.position || std::abs(turn) > 1e-15)) {
            return QString("body %1 moved though it was inactive or frozen: by (%2, %3) and %4 rad")
                .arg(user)
                .arg(now.pose.position.x() - pose.position.x())
                .arg(now.pose.position.y() - pose.position.y())
                .arg(turn);
        }
    }
    return {};
}

} // namespace

class ChangesTest : public QObject {
    Q_OBJECT

  private slots:
    void anyChangeInAnswerToAnyEventIsSafe_data() { iterationRows(); }
    void anyChangeInAnswerToAnyEventIsSafe() {
        QFETCH(int, iterations);
        const std::uint64_t seeds = (isFullRun() ? 20000u : 400u) / static_cast<std::uint64_t>(iterations);
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            Host host(seed, iterations);
            World copy = host.world;
            for (int i = 0; i < 150; ++i) {
                host.answerEvents();
                host.rememberWhatIsStill();
                copy = host.world; // with everything that waits to be carried out
                host.world.update();
                copy.update();
                const QString where = QString("seed %1, update %2: ").arg(seed).arg(i);
                const QString complaint = host.complaint();
                QVERIFY2(complaint.isEmpty(), qPrintable(where + complaint));
                QVERIFY2(movedThough(host).isEmpty(), qPrintable(where + movedThough(host)));
                QVERIFY2(copy.hash() == host.world.hash(), qPrintable(where + "a copy went another way"));
            }
        }
    }

    void whatIsRemovedWhileItTouchesEndsItsTouches() {
        for (const bool remove : {true, false}) {
            World world(withIterations(20));
            const BodyId ground = add(world, floorOf("edge"));
            const BodyId id = add(world, ball({0, 0.2}, 0.2));
            const BodyId rider = add(world, ball({0, 0.6}, 0.2));
            run(world, 0.5);
            remove ? world.removeBody(id) : world.setActive(id, false);
            world.update();
            QCOMPARE(world.events().ended.size(), std::size_t{2});
            QCOMPARE(world.events().removed.size(), remove ? std::size_t{1} : std::size_t{0});
            run(world, 1);
            QVERIFY(std::abs(world.body(rider).massCenter.y() - 0.2) < 0.005); // has fallen through to the ground
            QVERIFY(world.contains(ground) && world.contains(id) != remove);
        }
    }

    void aBodyRemovedBeforeItsFirstUpdateIsReportedAllTheSame() {
        World world;
        BodyDef def = ball({0, 0}, 0.2);
        def.user = 7;
        const BodyId id = add(world, def);
        world.removeBody(id);
        world.removeBody(id);
        QVERIFY(world.contains(id)); // until the update
        world.update();
        QCOMPARE(world.events().removed.size(), std::size_t{1});
        QCOMPARE(world.events().removed.front().iteration, -1);
        QCOMPARE(world.events().removed.front().user, std::uint64_t{7});
        QCOMPARE(world.bodyCount(), 0);
        world.update();
        QVERIFY(world.events().removed.empty());
    }

    void aThawedBodyFallsFromRest() {
        World world(withIterations(20));
        BodyDef def = ball({0, 0}, 0.2);
        def.velocity = {3, 0};
        const BodyId id = add(world, def);
        world.setFrozen(id, true);
        run(world, 1);
        QCOMPARE(world.body(id).massCenter, Vec2(0, 0));
        world.setFrozen(id, false);
        run(world, 1);
        QVERIFY((world.body(id).massCenter - Vec2(0, -4.905)).norm() < 1e-9);
    }

    void aStaticBodyIsFoundMovedAndRemovedAtAnyTime() {
        World world(withIterations(20));
        const BodyId id = add(world, ball({0.5, 0.4}, 0.2));
        run(world, 0.1);
        BodyDef def = box({0, -1}, 2, 1); // in the middle of a run
        def.kind = BodyKind::Static;
        def.user = 9;
        const BodyId ground = add(world, def);
        QVERIFY(world.contains(ground));
        QCOMPARE(world.body(ground).user, std::uint64_t{9});
        QCOMPARE(world.shapes(ground), def.shapes);
        run(world, 1);
        QVERIFY(std::abs(world.body(id).massCenter.y() - 0.2) < 0.005);
        world.setPose(ground, {0, -2}, 0);
        run(world, 2);
        QVERIFY(std::abs(world.body(id).massCenter.y() + 0.8) < 0.005);
        world.setActive(ground, false);
        run(world, 1);
        QVERIFY(world.body(id).massCenter.y() < -4);
        world.removeBody(ground);
        world.update();
        QVERIFY(!world.contains(ground));
    }

    void makingAndRemovingBodiesWithoutEndTakesNoMemory() {
        World world(withIterations(4));
        const int rounds = isFullRun() ? 1000 : 50;
        std::size_t inUse = 0;
        for (int round = 0; round < rounds; ++round) {
            BodyId last;
            for (int i = 0; i < 1000; ++i) {
                last = add(world, i % 2 == 0 ? ball({2.0 * i, 0}, 0.2) : box({2.0 * i, 0}, 0.2, 0.2));
                QVERIFY(last.index < 1000);
                if (i > 0 && i % 10 == 0) {
                    QVERIFY(bool(world.addConnector({.a = world.bodies().front(), .b = last})));
                }
            }
            world.update();
            for (const BodyId id : world.bodies()) {
                world.removeBody(id);
            }
            world.update();
            QCOMPARE(world.bodyCount(), 0);
            QVERIFY(world.connectors().empty());
            const std::size_t now = ::mallinfo2().uordblks; // 0 under sanitizers
            inUse = round == 5 ? now : inUse;
            QVERIFY2(round < 5 || now < inUse + 1000000, qPrintable(QString::number(now)));
        }
    }
};

SPACETOW_TEST(ChangesTest)
#include "changes_test.moc"
