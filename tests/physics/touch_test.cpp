#include "tests/support/contact_scenes.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

class TouchTest : public QObject {
    Q_OBJECT

  private slots:
    void anIntangibleBodyIsFeltOnceAndChangesNoVelocity() {
        World world(withIterations(20, {0, 0}));
        BodyDef zone = lineBody({0, -1}, {0, 1});
        zone.tangible = false;
        const BodyId gate = add(world, zone);
        BodyDef def = ball({-1, 0}, 0.2);
        def.velocity = {1, 0.1};
        def.reportsTouches = true;
        const BodyId id = add(world, def);
        int began = 0;
        int ended = 0;
        int reports = 0;
        for (int i = 0; i < 100; ++i) {
            world.update();
            began += static_cast<int>(world.events().began.size());
            ended += static_cast<int>(world.events().ended.size());
            reports += static_cast<int>(world.events().tagsTouched.size());
            for (const TouchEvent& event : world.events().began) {
                QVERIFY(event.a == gate && event.b == id && !event.solid);
            }
        }
        QCOMPARE(began, 1);
        QCOMPARE(ended, 1);
        QVERIFY(reports > 300 && reports < 500); // 0.4 s of 1,000 iterations a second
        QCOMPARE(world.body(id).velocity.x(), 1.0);
        QCOMPARE(world.body(id).velocity.y(), 0.1);
        QCOMPARE(world.body(id).touchedTags.bits, 0u);
    }

    void aBodyOfSeveralPartsThatIsPutElsewhereEndsItsTouchOnce() {
        World world(withIterations(4, {0, 0}));
        BodyDef zone = ball({0, 0}, 1);
        zone.kind = BodyKind::Static;
        zone.tangible = false;
        add(world, zone);
        BodyDef def = ball({-0.3, 0}, 0.2);
        def.shapes.emplace_back(Circle{{0.6, 0}, 0.2});
        const BodyId id = add(world, def);
        world.update();
        QCOMPARE(world.events().began.size(), std::size_t{1});
        world.setPose(id, {50, 0}, 0);
        world.update();
        QCOMPARE(world.events().ended.size(), std::size_t{1});
    }

    void tagsTouchedAreReportedOfThoseThatAskForIt() {
        World world(withIterations(20));
        add(world, floorOf("edge"));
        const auto addBall = [&](double x, bool reports) {
            BodyDef def = ball({x, 0.2}, 0.2);
            def.reportsTouches = reports;
            return add(world, def);
        };
        const std::vector<BodyId> ids{addBall(0, false), addBall(2, true), addBall(4, true)};
        const auto reports = [&](BodyId id) {
            world.update();
            const std::vector<TagsTouchedEvent>& all = world.events().tagsTouched;
            return std::count_if(all.begin(), all.end(), [id](const auto& event) { return event.body == id; });
        };
        world.update();
        QCOMPARE(reports(ids[1]), 20);
        QCOMPARE(reports(ids[2]), 20);
        QCOMPARE(reports(ids[0]), 0);
        const BodyId later = addBall(6, true);
        QCOMPARE(reports(later), 20);
        world.removeBody(ids[2]);
        QCOMPARE(reports(ids[2]), 0);
    }

    void aPairMeetsWhenEachTouchesTheOthersTags() {
        for (int bit = 0; bit < 32; ++bit) {
            for (const bool mutual : {true, false}) {
                World world(withIterations(4, {0, -10}));
                BodyDef ground = floorOf("edge");
                ground.filter = {TagMask::bit(bit), TagMask::bit(3)};
                add(world, ground);
                BodyDef def = ball({0, 0.3}, 0.2);
                def.filter = {TagMask::bit(3), mutual ? TagMask::bit(bit) : TagMask::bit((bit + 1) % 32)};
                const BodyId id = add(world, def);
                run(world, 1);
                QCOMPARE(world.body(id).massCenter.y() > 0, mutual);
            }
        }
    }
};

SPACETOW_TEST(TouchTest)
#include "touch_test.moc"
