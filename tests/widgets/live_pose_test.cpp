#include "editor/play/live_pose.h"

#include "core/base/random.h"
#include "core/game/session.h"
#include "editor/editing/group_picking.h"
#include "tests/support/game_levels.h"
#include "tests/support/live_level.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// The yard with balls that fall onto what stands there, some of them in a group, and hung from each other by springs.
Level crowdedYard(Random& random) {
    Level level = yard();
    constexpr Key group = 50, firstBall = 100, firstSpring = 200;
    level.objects.append({group, "", GroupObject{}, {}});
    for (Key i = 0; i < 60; ++i) {
        const double x = static_cast<double>(random.below(160)) / 10 - 8;
        Object ball{firstBall + i, "", test::ballAt(Vec2(x, 1 + 0.1 * static_cast<double>(i))), {}};
        ball.parent = i % 4 == 0 ? group : 0;
        level.objects.append(ball);
    }
    for (Key i = 0; i < 8; ++i) {
        const ConnectorObject spring{.a = firstBall + 2 * i, .b = i == 0 ? floorKey : firstBall + 3 * i + 1};
        level.objects.append({firstSpring + i, "", spring, {}});
    }
    return level;
}

std::vector<Key> pickedAt(const Level& level, const Vec2& place) {
    std::vector<Key> objects;
    const Edit edit{std::make_shared<const Level>(level), {}};
    for (const GroupPick& pick : pickedMembers(edit, {.world = place})) {
        objects.push_back(pick.key);
    }
    std::ranges::sort(objects);
    return objects;
}

} // namespace

class LivePoseTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsPickedInWhatIsNearIsWhatIsPickedInAll() {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Random random(seed);
            const Level level = crowdedYard(random);
            Session session(level);
            for (int i = 0; i < 40; ++i) {
                session.step(StepInput{});
            }
            const auto picture = session.snapshot();
            const Level all = posed(level, *picture);
            const Level still = standing(level);
            int found = 0;
            for (int i = 0; i < 200; ++i) {
                const Vec2 place(static_cast<double>(random.below(1600)) / 100 - 8,
                                 static_cast<double>(random.below(400)) / 100 - 0.5);
                const Level near = posedNear(level, still, *picture, Aabb{place, place}.grown(0.2));
                QVERIFY(near.objects.size() < all.objects.size());
                const std::vector<Key> expected = pickedAt(all, place);
                QVERIFY2(pickedAt(near, place) == expected, qPrintable(seedText(seed)));
                found += expected.empty() ? 0 : 1;
            }
            QVERIFY2(found > 20, qPrintable(seedText(seed)));
        }
    }
    void whatHasGoneInTheRunIsNotThere() {
        Session session(spaceWithCeiling());
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        const Level level = session.level();
        const Level near = posedNear(level, standing(level), *session.snapshot(), Aabb{{-50, -50}, {50, 50}});
        QVERIFY(near.objects.find(shipKey) == nullptr);
        QVERIFY(near.objects.find(payloadKey) != nullptr && near.objects.find(finishKey) != nullptr);
    }
};

SPACETOW_TEST(LivePoseTest)
#include "live_pose_test.moc"
